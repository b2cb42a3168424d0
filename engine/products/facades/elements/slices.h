// SPDX-License-Identifier: Apache-2.0
// How deep an element goes and where it ends there: cuts through its points parallel to the wall [Lorraine
// thesis, 4.2.1].
#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

struct SliceParams {
  double spacing = 0.02;   // metres between cuts
  double within = 0.75;    // of the spacing: points so near to a cut are consistent with it, and with its neighbour
  double reach_steps = 3;  // sampling steps: circumradius of the triangles that make up a cut's shape
};

struct FacadeSlice {
  double w = 0;              // metres out of the wall
  std::size_t points = 0;    // P', consistent with the cut
  std::size_t boundary = 0;  // B, those of them on the boundary of their alpha shape
  Box2 extent;               // of all but half a percent of them on each side
  int level = 0;             // one in 2^level of the points was looked at for the boundary
  double ratio() const {
    return boundary == 0 ? 0 : std::ldexp(static_cast<double>(points), -level) / static_cast<double>(boundary);
  }
};

// A box along the wall, and cuts through what is in it from one depth to the other.
struct SliceRange {
  Box2 box;
  double from = 0, to = 0;
};

// Of the points that lie within the box along the wall, cuts from `from` on up to `to`, where any point lies, by w. Of
// more than 32,768 points of a cut, or 131,072 of all, one in two, in four and so on is looked at, of all cuts alike
// and by their coordinates; triangles are so much longer. O(n log n).
std::vector<FacadeSlice> slices_of(const RaySamples& samples, const SliceRange& range, const SliceParams& params = {});

// Of a cut that was not looked at whole the extent of all its points.
Box2 whole_extent(const RaySamples& samples, const SliceRange& range, const FacadeSlice& slice,
                  const SliceParams& params = {});

// The cut with the largest T = |P'| / |B| [Lorraine thesis, 4.2.1]: a sheet that fills the element has few points on
// its boundary. Of cuts that come to half of that ratio and of those points the one nearest to the wall: curtains and
// rooms fill as well. None of no cuts.
std::optional<FacadeSlice> end_slice(std::span<const FacadeSlice> slices);

}  // namespace ilot
