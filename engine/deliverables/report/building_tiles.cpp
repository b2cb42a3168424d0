// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/building_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/report/packed.h"
#include "engine/report/product_files.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTileBytes = 512u << 10, kMostInPage = 8u << 20;

// The outline of a building: the rings of its ground, or of what it has.
std::string outline_of(const BuildingRow& row) {
  const Building building = unpacked_shape(row.shape, {});
  const bool has_ground = std::any_of(building.surfaces.begin(), building.surfaces.end(),
                                      [](const BuildingSurface& s) { return s.kind == SurfaceKind::ground; });
  std::vector<const std::vector<std::uint32_t>*> rings;
  for (const BuildingSurface& s : building.surfaces)
    if (!has_ground || s.kind == SurfaceKind::ground)
      for (const auto& ring : s.rings) rings.push_back(&ring);
  std::string bytes;
  put_whole(bytes, rings.size());
  std::int64_t x = 0, y = 0;
  for (const auto* ring : rings) {
    put_whole(bytes, ring->size());
    for (const std::uint32_t v : *ring) {
      const std::int64_t cx = std::llround(100 * building.vertices[v].x),
                         cy = std::llround(100 * building.vertices[v].y);
      put_signed(bytes, cx - x), put_signed(bytes, cy - y);
      x = cx, y = cy;
    }
  }
  return bytes;
}

// Interleaves the bits of the middle's metres; places to the south-west come first.
std::uint64_t place_key(Vec3 middle) {
  constexpr double kShift = 1 << 30;
  const auto cell = [&](double v) { return static_cast<std::uint64_t>(std::clamp(v + kShift, 0.0, 2 * kShift - 1)); };
  const std::uint64_t x = cell(middle.x), y = cell(middle.y);
  std::uint64_t key = 0;
  for (unsigned bit = 0; bit < 32; ++bit) key |= (x >> bit & 1) << (2 * bit) | (y >> bit & 1) << (2 * bit + 1);
  return key;
}

}  // namespace

void remove_building_tiles(const fs::path& folder) {
  const fs::path tiles = folder / kReportTiles;
  if (!fs::is_directory(fs::symlink_status(tiles))) return;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(tiles)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("models-") && name.ends_with(".js")) old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path);
  std::error_code not_empty;
  fs::remove(tiles, not_empty);
}

namespace {

struct Tile {
  std::string bytes;
  std::size_t count = 0;
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;

  void add(std::size_t number, const BuildingRow& row) {
    put_whole(bytes, number);
    bytes += row.shape;
    ++count;
    x0 = std::min(x0, row.middle.x), y0 = std::min(y0, row.middle.y);
    x1 = std::max(x1, row.middle.x), y1 = std::max(y1, row.middle.y);
  }
};

class TileWriter {
 public:
  TileWriter(const fs::path& folder, bool beside, BuildingTiles& tiles)
      : folder_(folder), beside_(beside), tiles_(tiles) {}

  void write(const Tile& tile) {
    if (tile.count == 0) return;
    const std::string name = fmt::format("models-{}", tiles_.about.size());
    tiles_.about.push_back({{"name", name}, {"buildings", tile.count}, {"box", {tile.x0, tile.y0, tile.x1, tile.y1}}});
    if (!beside_) {
      tiles_.elements += packed_element(name, tile.bytes);
      return;
    }
    const std::string file = std::string(kReportTiles) + "/" + name + ".js";
    const std::string script = "ilot.tile(\"" + name + "\",\"" + packed(tile.bytes) + "\");\n";
    fs::create_directories(folder_ / kReportTiles);
    write_whole_file(folder_ / file, script);
    tiles_.about.back()["file"] = file;
    tiles_.bytes_beside += script.size();
  }

 private:
  fs::path folder_;
  bool beside_;
  BuildingTiles& tiles_;
};

}  // namespace

BuildingTiles write_building_tiles(const fs::path& folder, const std::vector<BuildingRow>& rows) {
  BuildingTiles tiles;
  tiles.about = nlohmann::ordered_json::array();
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    tiles.outlines += outline_of(rows[i]);
    bytes += rows[i].shape.size();
    if (!rows[i].shape.empty()) order.emplace_back(place_key(rows[i].middle), i);
  }
  std::sort(order.begin(), order.end());
  remove_building_tiles(folder);
  TileWriter writer(folder, bytes > kMostInPage, tiles);
  Tile tile;
  for (const auto& [key, i] : order) {
    tile.add(i, rows[i]);
    if (tile.bytes.size() < kTileBytes) continue;
    writer.write(tile);
    tile = {};
  }
  writer.write(tile);
  return tiles;
}

}  // namespace ilot
