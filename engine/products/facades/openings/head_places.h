// SPDX-License-Identifier: Apache-2.0
// Places along the head of an opening at which rays no longer go through the wall. Arches (arched_top.h) and points
// (pointed_top.h) are fitted to them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
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

// Sorts the rays that cross the wall in the box, and some around it, into slices across a head. `slice_of` takes the
// place where a ray crosses the wall, and gives the number of its slice and its distance along it; a number of `count`
// and more: the ray is in none.
template <class SliceOf>
std::vector<HeadSlice> head_slices(const RaySamples& samples, const Box2& search, std::size_t count,
                                   const SliceOf& slice_of) {
  std::vector<HeadSlice> slices(count);
  Rays near = samples.near(search);
  const int level = thinning_level(near, kMostHeadSamples, [](const Ray&) { return true; });
  for (const Ray& ray : near) {
    if (!is_kept(ray, level)) continue;
    const auto [number, along] = slice_of(samples.crossing(ray, 0));
    if (number >= count) continue;
    if (is_below_head(samples, ray)) slices[number].below.push_back(along);
    if (is_above_head(samples, ray)) slices[number].above.push_back(along);
  }
  return slices;
}

// The number of a slice for a place in widths of slices; kNoSlice before the first one or beyond the last.
constexpr std::size_t kNoSlice = SIZE_MAX;
inline std::size_t slice_at(double place, std::size_t count) {
  return place >= 0 && place < static_cast<double>(count) ? static_cast<std::size_t>(place) : kNoSlice;
}

// Where slices end, and how exactly each of them shows it.
struct HeadPlaces {
  std::vector<PlanePoint> at;
  double half_gap = 0;  // metres, the mean

  void add(PlanePoint place, double gap);
};

// The ends of upright slices beside each other. The box is as wide as the opening. O(n log n) in the points around.
HeadPlaces tops_of_slices(const RaySamples& samples, const Box2& search);

}  // namespace ilot
