// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/glb.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/error.h"
#include "engine/version.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "glTF is little endian");

constexpr int kFloat = 5126, kShort = 5123, kInt = 5125;
constexpr std::size_t kAlignment = 8;  // of property tables; arrays of vertices need 4

Json material(const char* name, double red, double green, double blue) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {red, green, blue, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}}};
}

}  // namespace

void append_number(std::string& text, std::uint64_t value) {
  const auto number = static_cast<std::uint32_t>(value);
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::string padded(std::string text, char with) {
  text.resize((text.size() + kAlignment - 1) / kAlignment * kAlignment, with);
  return text;
}

std::size_t Glb::add_view(std::span<const std::byte> bytes, GlbTarget target) {
  binary_ = padded(std::move(binary_), '\0');
  Json view{{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != GlbTarget::none) view["target"] = static_cast<int>(target);
  views_.push_back(std::move(view));
  binary_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return views_.size() - 1;
}

std::size_t Glb::add_accessor(std::size_t view, int component, std::size_t count, const char* type) {
  accessors_.push_back({{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
  return accessors_.size() - 1;
}

std::size_t Glb::add_vectors(std::span<const float> xyz, bool with_bounds) {
  const std::size_t accessor =
      add_accessor(add_view(std::as_bytes(xyz), GlbTarget::vertices), kFloat, xyz.size() / 3, "VEC3");
  if (!with_bounds) return accessor;
  std::array<float, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t i = 0; i < xyz.size(); ++i) {
    low[i % 3] = std::min(low[i % 3], xyz[i]);
    high[i % 3] = std::max(high[i % 3], xyz[i]);
  }
  accessors_.back()["min"] = low;
  accessors_.back()["max"] = high;
  return accessor;
}

std::size_t Glb::add_scalars(std::span<const float> values) {
  return add_accessor(add_view(std::as_bytes(values), GlbTarget::vertices), kFloat, values.size(), "SCALAR");
}

std::size_t Glb::add_indices(std::span<const std::uint32_t> values) {
  constexpr std::uint32_t kShortest = 65535;  // values below it: it is reserved
  const bool small = std::all_of(values.begin(), values.end(), [](std::uint32_t v) { return v < kShortest; });
  if (!small) return add_accessor(add_view(std::as_bytes(values), GlbTarget::indices), kInt, values.size(), "SCALAR");
  const std::vector<std::uint16_t> shorts(values.begin(), values.end());
  return add_accessor(add_view(std::as_bytes(std::span(shorts)), GlbTarget::indices), kShort, values.size(), "SCALAR");
}

std::string Glb::file(const std::string& name) const {
  const std::string binary = padded(binary_, '\0');
  Json whole = json;
  if (!views_.empty()) {
    whole["buffers"] = Json::array({{{"byteLength", binary.size()}}});
    whole["bufferViews"] = views_;
    whole["accessors"] = accessors_;
  }
  const std::string text = padded(whole.dump(-1, ' ', false, Json::error_handler_t::replace), ' ');
  const std::uint64_t size = 12 + 8 + std::uint64_t{text.size()} + (views_.empty() ? 0 : 8 + binary.size());
  if (size > UINT32_MAX)
    throw Error(name + ": would exceed the 4 GiB of a GLB file; export 3dtiles, which are cut into pieces");
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, size);
  append_number(file, text.size());
  file += "JSON" + text;
  if (views_.empty()) return file;
  append_number(file, binary.size());
  file.append("BIN\0", 4);
  return file + binary;
}

Json glb_start() {
  return {
      {"asset", {{"version", "2.0"}, {"generator", "ilot " + version()}}},
      {"materials",
       {material("roof", 0.72, 0.30, 0.22), material("wall", 0.82, 0.80, 0.76), material("ground", 0.45, 0.45, 0.45)}}};
}

Json z_up() {
  return {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)};
}

Json y_up_place(Vec3 place) {
  return {place.x, place.z, 0 - place.y};
}

}  // namespace ilot
