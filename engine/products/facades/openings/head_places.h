// SPDX-License-Identifier: Apache-2.0
// Places along the head of an opening at which rays no longer go through the wall. Arches (arched_top.h) and points
// (pointed_top.h) are fitted to them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/products/facades/openings/openings.h"
#include "kernels/outlines/circle_fit.h"

namespace ilot {

constexpr std::size_t kHeadSlices = 24, kLeastHeadSlices = 8;
// Choice: mixed pixels at the jambs; of narrow openings a step or less.
constexpr double kJamb = 0.04;                       // share of the width that is left out at each jamb
constexpr std::uint64_t kMostHeadSamples = 1 << 17;  // more points do not improve the result
// Derived: 95 % of normal errors are within two standard deviations.
constexpr double kBoundOfHead = 2;
// Choice: half of a beam of 4 mm, as terrestrial scanners have at 10 m.
constexpr double kBeamRadius = 0.002;  // metres

// Whether a ray meets the wall, the back of a joint between its stones, or a surround that stands out of the wall and
// continues where the soffit ends. Such a ray does not go through. An element that stands out farther hides both the
// opening and the wall above it.
bool is_above_head(const RaySamples& samples, const Ray& ray);
bool is_below_head(const RaySamples& samples, const Ray& ray);

// The samples of a slice on both sides of its end, in metres along it.
struct HeadSlice {
  std::vector<double> below, above;
};

// The end of a slice; it is not found where it is less exact than heads need.
struct HeadEnd {
  double at = 0, half_gap = 0;
  bool found = false;
};
HeadEnd end_of_slice(const RaySamples& samples, const HeadSlice& slice);

// Where slices end, and how exactly each of them shows it.
struct HeadPlaces {
  std::vector<PlanePoint> at;
  double half_gap = 0;  // metres, the mean

  void add(PlanePoint place, double gap);
};

// The ends of upright slices beside each other. The box is as wide as the opening. O(n log n) in the points around.
HeadPlaces tops_of_slices(const RaySamples& samples, const Box2& search);

}  // namespace ilot
