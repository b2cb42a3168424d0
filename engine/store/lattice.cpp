// SPDX-License-Identifier: Apache-2.0
#include "engine/store/lattice.h"

#include <cmath>
#include <cstdio>

namespace ilot {
namespace {

constexpr double kSameScale = 1e-12;  // relative; over 2^31 raw steps it is less than a hundredth of a step

}  // namespace

Node Node::ancestor(int at_level) const {
  const int shift = 3 * (kTileBits - at_level);
  return {tile, at_level, first_code >> shift << shift};
}

Index3 Node::min_corner() const {
  return index_of({tile, first_code});
}

IndexBox Node::box() const {
  const Index3 c = min_corner();
  const std::int64_t e = edge() - 1;
  return {c, {c.x + e, c.y + e, c.z + e}};
}

std::string Node::name() const {
  char text[96];
  std::snprintf(text, sizeof text, "t%d_%d_%d_l%02d_%016llx", tile.x, tile.y, tile.z, level,
                static_cast<unsigned long long>(first_code));
  return text;
}

LatticeMap::LatticeMap(const RecordLayout& layout, double unit) {
  for (std::size_t i = 0; i < 3; ++i) {
    Axis& axis = axes_[i];
    axis = {layout.scale[i], layout.offset[i], unit, 0, 0, 0, false};
    const double factor = std::nearbyint(axis.scale / unit);
    const double shift = std::nearbyint(axis.offset / unit);
    axis.exact = factor >= 1 && std::abs(axis.scale / unit - factor) < kSameScale * factor && factor < 0x1p20 &&
                 std::abs(shift) < static_cast<double>(kFarthest) && std::abs(axis.offset / unit - shift) < 1e-5;
    if (axis.exact) {
      axis.factor = static_cast<std::int64_t>(factor);
      axis.shift = static_cast<std::int64_t>(shift);
    } else {
      set_divisor(axis);
    }
  }
}

void LatticeMap::set_divisor(Axis& axis) {
  const double divisor = std::nearbyint(axis.unit / axis.scale);
  const double shift = std::nearbyint(axis.offset / axis.scale);
  if (!(divisor > 1 && std::abs(axis.unit / axis.scale - divisor) < kSameScale * divisor && divisor < 0x1p31 &&
        std::abs(shift) < static_cast<double>(kFarthest) && std::abs(axis.offset / axis.scale - shift) < 1e-5))
    return;
  axis.divisor = static_cast<std::int64_t>(divisor);
  axis.shift = static_cast<std::int64_t>(shift);
}

bool LatticeMap::Axis::round(std::int32_t raw, std::int64_t& out) const {
  const double v = std::nearbyint((raw * scale + offset) / unit);
  if (!(std::abs(v) < static_cast<double>(kFarthest))) return false;
  out = static_cast<std::int64_t>(v);
  return true;
}

double LatticeMap::Axis::offset_from(std::int64_t anchor, std::int32_t raw) const {
  if (exact) return static_cast<double>(raw * factor + shift - anchor);
  if (divisor != 0 && (raw + shift) % divisor == 0) return static_cast<double>((raw + shift) / divisor - anchor);
  return (raw * scale + offset) / unit - static_cast<double>(anchor);
}

Vec3 LatticeMap::offset_from(Index3 anchor, std::int32_t x, std::int32_t y, std::int32_t z) const {
  return {axes_[0].offset_from(anchor.x, x), axes_[1].offset_from(anchor.y, y), axes_[2].offset_from(anchor.z, z)};
}

}  // namespace ilot
