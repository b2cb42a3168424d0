// SPDX-License-Identifier: Apache-2.0
// Places along kerbs, and the kerbs around them.
#pragma once
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "kernels/core/types.h"

namespace ilot {

// A place on a kerb. The pavement is ahead.
struct Transect {
  std::uint32_t number = 0;           // along the kerb, from 1
  Vec3 at;                            // metres
  double across_x = 0, across_y = 1;  // unit vector away from the road
  double along = 0;                   // metres from the start of the kerb
};

// Places along a kerb in steps of `spacing` metres from its start, the first after half a step. The vertices are
// metres, the pavement is on the left. O(vertices + places log vertices).
std::vector<Transect> transects_along(std::span<const Vec3> line, double spacing);

// The same from end to end: the first and the last place are the ends of the line, and those between are in even steps
// of `spacing` metres or a little less.
std::vector<Transect> transects_over(std::span<const Vec3> line, double spacing);

// The first kerb in a direction.
struct KerbAhead {
  double distance = std::numeric_limits<double>::infinity();  // metres; infinity where there is none
  std::size_t line = 0;                                       // its index
  bool faces = false;  // its pavement is behind it, so that it is the other side of a road
};

// The kerbs of a street, for finding the next one in a direction.
class KerbLookup {
 public:
  explicit KerbLookup(std::span<const std::vector<Vec3>> lines);

  // The first kerb from a place along a direction (a unit vector), at a distance of more than `from` and at most
  // `reach` metres. Where two kerbs meet it is the one with the lower index.
  KerbAhead next(double x, double y, double dx, double dy, double from, double reach) const;

 private:
  struct Segment {
    double x = 0, y = 0, dx = 0, dy = 0;
    std::size_t line = 0;
  };
  std::vector<Segment> segments_;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells_;
};

}  // namespace ilot
