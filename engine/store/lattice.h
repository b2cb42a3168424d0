// SPDX-License-Identifier: Apache-2.0
// The place of a point in integers. World coordinates are multiples of one unit for all inputs. Space is divided into
// fixed tiles of 2^21 units, and each tile into an octree by Morton code. The key of a point is its tile and its code.
// The keys give the global order of points, which does not change when all points are shifted by whole tiles.
#pragma once
#include <compare>
#include <cstdint>
#include <string>

#include "engine/cloud/record.h"
#include "kernels/core/types.h"
#include "kernels/geometry/box3.h"
#include "kernels/neighbours/morton.h"

namespace ilot {

constexpr int kTileBits = kMortonBits;  // tile edge 2^21 units: 2,097 m at a millimetre

struct Tile {
  std::int32_t x = 0, y = 0, z = 0;
  friend auto operator<=>(const Tile&, const Tile&) = default;
};

struct PointKey {
  Tile tile;
  std::uint64_t code = 0;
  friend auto operator<=>(const PointKey&, const PointKey&) = default;
};

// Inline, like the inverse function, because it is called for each point of every input.
inline PointKey key_of(Index3 p) {
  constexpr std::int64_t kMask = (std::int64_t{1} << kTileBits) - 1;
  const auto high = [](std::int64_t v) { return static_cast<std::int32_t>(v >> kTileBits); };
  const auto low = [](std::int64_t v) { return static_cast<std::uint32_t>(v & kMask); };
  return {{high(p.x), high(p.y), high(p.z)}, morton_code({low(p.x), low(p.y), low(p.z)})};
}
inline Index3 corner(Tile tile) {
  constexpr std::int64_t kEdge = std::int64_t{1} << kTileBits;
  return {tile.x * kEdge, tile.y * kEdge, tile.z * kEdge};
}
inline Index3 index_of(const PointKey& key) {
  const Index3 c = corner(key.tile);
  const Cell3 cell = morton_cell(key.code);
  return {c.x + cell.x, c.y + cell.y, c.z + cell.z};
}

// A cube of the octree of one tile: level 0 is the tile, level 21 a single lattice point.
struct Node {
  Tile tile;
  std::int32_t level = 0;
  std::uint64_t first_code = 0;  // smallest code inside the node

  std::uint64_t last_code() const { return first_code + (std::uint64_t{1} << 3 * (kTileBits - level)) - 1; }
  std::int64_t edge() const { return std::int64_t{1} << (kTileBits - level); }
  Node child(int octant) const {
    return {tile, level + 1, first_code + (static_cast<std::uint64_t>(octant) << 3 * (kTileBits - level - 1))};
  }
  Node ancestor(int at_level) const;
  Index3 min_corner() const;
  IndexBox box() const;
  bool contains(const Node& o) const {
    return tile == o.tile && first_code <= o.first_code && o.last_code() <= last_code();
  }
  std::string name() const;  // usable as a file name
  friend bool operator==(const Node&, const Node&) = default;
};

// The order of disjoint nodes is the global order of their points.
inline bool before(const Node& a, const Node& b) {
  return a.tile != b.tile ? a.tile < b.tile : a.first_code < b.first_code;
}

// The lattice of all inputs. When `multiple` is above 1, the scales of the inputs are finer than the unit, but all
// points (except strays) are on the lattice.
struct InputLattice {
  double unit = 0.001;  // CRS units
  std::int64_t multiple = 1;
  InputLattice(double step = 0.001, std::int64_t of = 1) : unit(step), multiple(of) {}
  double finest() const { return unit / static_cast<double>(multiple); }
  friend bool operator==(const InputLattice&, const InputLattice&) = default;
};

// Converts raw integers of a file to lattice coordinates. The result is exact when the file's scale is a multiple of
// the unit and its offset is on the lattice; else it is the nearest lattice point.
class LatticeMap {
 public:
  LatticeMap(const RecordLayout& layout, double unit);
  // False when the point is too far from the origin (beyond 2^51 units).
  bool map(std::int32_t x, std::int32_t y, std::int32_t z, Index3& out) const {
    return axes_[0].map(x, out.x) && axes_[1].map(y, out.y) && axes_[2].map(z, out.z);
  }
  // Returns the place of the point relative to an anchor, in units, without rounding to the lattice. It is a whole
  // number for points on the lattice.
  Vec3 offset_from(Index3 anchor, std::int32_t x, std::int32_t y, std::int32_t z) const;
  bool exact() const { return axes_[0].exact && axes_[1].exact && axes_[2].exact; }

 private:
  static constexpr std::int64_t kFarthest = std::int64_t{1} << 51;
  struct Axis {
    double scale, offset, unit;
    std::int64_t factor, shift;
    std::int64_t divisor;  // of raw + shift, when the unit is a multiple of the scale; else 0
    bool exact;
    bool map(std::int32_t raw, std::int64_t& out) const {
      if (!exact) return round(raw, out);
      out = raw * factor + shift;
      return out > -kFarthest && out < kFarthest;
    }
    bool round(std::int32_t raw, std::int64_t& out) const;  // to the nearest lattice point
    double offset_from(std::int64_t anchor, std::int32_t raw) const;
  };
  static void set_divisor(Axis& axis);
  std::array<Axis, 3> axes_;
};

}  // namespace ilot
