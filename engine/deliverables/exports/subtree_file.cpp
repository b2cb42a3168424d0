// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/subtree_file.h"

#include <algorithm>
#include <span>

#include "engine/deliverables/exports/glb.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

// Bits of x and y take turns, x first (Morton's order).
std::size_t in_level(std::uint32_t level, std::uint32_t x, std::uint32_t y) {
  std::size_t index = 0;
  for (std::uint32_t bit = 0; bit < level; ++bit)
    index |= std::size_t{(x >> bit) & 1} << (2 * bit) | std::size_t{(y >> bit) & 1} << (2 * bit + 1);
  return index;
}

constexpr std::size_t tiles_above(std::uint32_t level) {
  return ((std::size_t{1} << (2 * level)) - 1) / 3;
}

std::size_t index_of(const SubtreeTile& tile) {
  return tiles_above(tile.level) + in_level(tile.level, tile.x, tile.y);
}

// The binary part of the file and its views.
struct Buffer {
  std::string bytes;
  Json views = Json::array();

  std::size_t add(std::span<const std::byte> data) {
    bytes = padded(std::move(bytes), '\0');
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
    bytes.append(reinterpret_cast<const char*>(data.data()), data.size());
    return views.size() - 1;
  }

  // `indices` are those of the bits that are set, of `length`.
  Json availability(const std::vector<std::size_t>& indices, std::size_t length) {
    if (indices.empty()) return {{"constant", 0}};
    std::vector<std::uint8_t> bits((length + 7) / 8);
    for (const std::size_t i : indices) bits[i / 8] |= static_cast<std::uint8_t>(1u << (i % 8));
    return {{"bitstream", add(std::as_bytes(std::span(bits)))}, {"availableCount", indices.size()}};
  }
};

}  // namespace

Json subtree_schema() {
  const Json box{{"description", "box of the tile and all below it, in the frame of the root"},
                 {"type", "SCALAR"},
                 {"componentType", "FLOAT64"},
                 {"array", true},
                 {"count", 12},
                 {"required", true},
                 {"semantic", "TILE_BOUNDING_BOX"}};
  const Json error{{"description", "size of the largest model that only tiles below show (m)"},
                   {"type", "SCALAR"},
                   {"componentType", "FLOAT64"},
                   {"required", true},
                   {"semantic", "TILE_GEOMETRIC_ERROR"}};
  return {{"id", "ilot_tiles"},
          {"classes", {{"tile", {{"properties", {{"box", box}, {"geometric_error_m", error}}}}}}}};
}

std::string subtree_file(Subtree subtree) {
  std::sort(subtree.tiles.begin(), subtree.tiles.end(),
            [](const SubtreeTile& a, const SubtreeTile& b) { return index_of(a) < index_of(b); });
  std::vector<std::size_t> tiles, contents, below;
  std::vector<double> boxes, errors;
  for (const SubtreeTile& tile : subtree.tiles) {
    tiles.push_back(index_of(tile));
    if (tile.has_content) contents.push_back(tiles.back());
    boxes.insert(boxes.end(), tile.box.begin(), tile.box.end());
    errors.push_back(tile.geometric_error_m);
  }
  for (const auto& [x, y] : subtree.below) below.push_back(in_level(kSubtreeLevels, x, y));
  Buffer buffer;
  Json json{{"buffers", Json::array()}, {"bufferViews", Json::array()}};
  json["tileAvailability"] = buffer.availability(tiles, tiles_above(kSubtreeLevels));
  json["contentAvailability"] = Json::array({buffer.availability(contents, tiles_above(kSubtreeLevels))});
  json["childSubtreeAvailability"] = buffer.availability(below, std::size_t{1} << (2 * kSubtreeLevels));
  json["propertyTables"] =
      Json::array({{{"class", "tile"},
                    {"count", tiles.size()},
                    {"properties",
                     {{"box", {{"values", buffer.add(std::as_bytes(std::span(boxes)))}}},
                      {"geometric_error_m", {{"values", buffer.add(std::as_bytes(std::span(errors)))}}}}}}});
  json["tileMetadata"] = 0;
  json["bufferViews"] = buffer.views;
  const std::string binary = padded(std::move(buffer.bytes), '\0');
  json["buffers"].push_back({{"byteLength", binary.size()}});
  const std::string text = padded(json.dump(), ' ');
  std::string file = "subt";
  append_number(file, 1);
  for (const std::uint64_t length : {text.size(), binary.size()}) {  // of 64 bits each
    append_number(file, length);
    append_number(file, length >> 32);
  }
  return file + text + binary;
}

}  // namespace ilot
