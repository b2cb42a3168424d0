// SPDX-License-Identifier: Apache-2.0
// Trunks of trees, among what stands on the ground.
#pragma once
#include <cstdint>
#include <vector>

namespace ilot {

// The points of a voxel: their number, and the sums of their distances from its corner in whole steps, so that they do
// not depend on the order of the points. Sums hold 16 million points.
constexpr std::uint32_t kTrunkSteps = 256;  // along the side of a voxel
struct TrunkVoxel {
  std::uint32_t x = 0, y = 0;  // steps
  std::uint32_t points = 0;
};

// Voxels over a rectangle of the plan. Few places of a street have anything upright, so only columns with points have
// voxels.
struct TrunkVoxels {
  static constexpr std::size_t kNone = SIZE_MAX;

  std::uint32_t width = 0, height = 0, slices = 0;
  double side = 0.1;    // metres, in plan
  double first = 0.3;   // metres above the ground where the lowest slice begins
  double slice = 0.25;  // metres, height of a slice
  // For each place of the plan, row by row, the number of its column from 1; 0 where it has none. Empty until add().
  std::vector<std::uint32_t> columns = {};
  std::vector<TrunkVoxel> values = {};  // `slices` of each column, from the lowest, in the order of their first points

  // The voxel at a place, with its column if that is new.
  TrunkVoxel& add(std::uint32_t at_slice, std::uint32_t x, std::uint32_t y);

  // The index in `values`; kNone where the column has no points.
  std::size_t find(std::uint32_t at_slice, std::uint32_t x, std::uint32_t y) const {
    const std::uint32_t column = columns.empty() ? 0 : columns[std::size_t{y} * width + x];
    return column == 0 ? kNone : std::size_t{column - 1} * slices + at_slice;
  }
};

struct TrunkParams {
  double widest = 1.3;      // metres; what is wider in a slice is no trunk
  double least_run = 0.75;  // metres; a trunk is seen over so much of its height
  double apart = 0.3;       // metres; the middles of a trunk in slices above each other are no farther apart
  double foot = 1.3;        // metres above the ground; a trunk is seen from there on, or lower
  double ring = 0.4;        // metres around a trunk in which there are fewer points than on it: leaves are everywhere
  double stems = 1;         // metres; of trunks that are nearer to each other the one with most points counts
};

// A trunk. Places are metres from the corner of the voxels.
struct Trunk {
  double x = 0, y = 0;            // of its axis at the ground
  double lean_x = 0, lean_y = 0;  // metres per metre of height
  double radius = 0;              // metres; of the circle through its points, or half of their width
  double from = 0, to = 0;        // metres above the ground; where it was seen
  std::uint64_t points = 0;
};

// Finds what is narrow and upright: connected voxels that are narrow in each slice, over several slices. The axis is
// the line through the middles of the slices; a circle is fitted to all points along it [Taubin 1991], as a scanner
// sees one side of a trunk. Sorted by y, then x; the order of the columns does not matter. O(width height slices).
std::vector<Trunk> find_trunks(const TrunkVoxels& voxels, const TrunkParams& params = {});

}  // namespace ilot
