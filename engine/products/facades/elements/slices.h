// SPDX-License-Identifier: Apache-2.0
// Measures how deep an element is and where it ends there, with cuts through its points parallel to the wall [Lorraine
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
  double within = 0.75;    // share of the spacing: a point so near to a cut is consistent with it; it may be consistent
                           // with the next cut too
  double reach_steps = 3;  // sampling steps: greatest circumradius of the triangles that form the shape of a cut
};

struct FacadeSlice {
  double w = 0;              // metres out of the wall
  std::size_t points = 0;    // P': number of points that are consistent with the cut
  std::size_t boundary = 0;  // B: number of these points that are on the boundary of their alpha shape
  Box2 extent;               // of these points, without half a percent of them on each side
  int level = 0;             // one in 2^level of the points was used for the boundary
  double ratio() const {
    return boundary == 0 ? 0 : std::ldexp(static_cast<double>(points), -level) / static_cast<double>(boundary);
  }
};

// A box along the wall. The cuts go through the points in it, from one depth to the other.
struct SliceRange {
  Box2 box;
  double from = 0, to = 0;
};

// Cuts the points that lie within the box along the wall, at depths from `from` up to `to`, wherever a point lies. The
// cuts are ordered by w. If a cut has more than 32,768 points, or all cuts have more than 131,072, only one point in
// two, in four and so on is used. This share is the same for all cuts and depends only on the coordinates; the
// triangles may be longer accordingly. O(n log n).
std::vector<FacadeSlice> slices_of(const RaySamples& samples, const SliceRange& range, const SliceParams& params = {});

// The extent of all points of a cut for which only a share of the points was used.
Box2 whole_extent(const RaySamples& samples, const SliceRange& range, const FacadeSlice& slice,
                  const SliceParams& params = {});

// The cut with the largest T = |P'| / |B| [Lorraine thesis, 4.2.1]: a sheet that fills the element has few points on
// its boundary. Curtains and rooms fill the element too. Therefore the cut nearest to the wall is taken among those
// that reach half of that ratio and half of those points. Without cuts there is no result.
std::optional<FacadeSlice> end_slice(std::span<const FacadeSlice> slices);

}  // namespace ilot
