// SPDX-License-Identifier: Apache-2.0
// How many objects of a street each step could keep at best, from the true object of each point.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <utility>

namespace ilot {

// Where a point went, as a run has it before candidates get classes.
enum class PointPlace : std::uint8_t { ground, building, overhead, no_part, part };
constexpr std::size_t kPointPlaces = 5;

// A point in its pixel. `object`: the true object, 0 = none.
struct PlacedPoint {
  std::int64_t x = 0, y = 0;
  std::uint32_t object = 0;
  PointPlace place = PointPlace::ground;
};

// The bounds of one object. Shares are intersections over unions of points.
struct ObjectBounds {
  std::uint64_t points = 0;
  std::array<std::uint64_t, kPointPlaces> places{};  // points by where they went
  double apart = 0;  // its pixels against it, if each pixel belongs to the object that has most points in it
  double above = 0;  // the same if what is no object counts too: walls, and crowns where they were not taken out

  std::uint64_t standing() const { return points - places[static_cast<std::size_t>(PointPlace::ground)]; }
};

class StreetBounds {
 public:
  void add(const PlacedPoint& p);
  std::map<std::uint32_t, ObjectBounds> objects() const;

 private:
  struct Standing {
    std::map<std::uint32_t, std::uint64_t> all, seen;  // points by object; `seen` is without what is overhead
  };
  std::map<std::pair<std::int64_t, std::int64_t>, Standing> pixels_;
  std::map<std::uint32_t, ObjectBounds> objects_;
};

}  // namespace ilot
