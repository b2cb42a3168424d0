// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/head_places.h"

#include <cmath>

#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

// Choice: three steps of 2 cm; coarser scans keep few slices and no arch.
constexpr double kMostHeadGap = 0.06;  // metres; slices whose end is less exact are left out
// Choice: mouldings around openings stand out less; deeper canopies hide the arch.
constexpr double kSurround = 0.15;  // metres before the wall at which surrounds end

}  // namespace

bool is_above_head(const RaySamples& samples, const Ray& ray) {
  if (samples.in_joint(ray)) return true;
  const RayOutcome met = samples.met(ray, 0, samples.site().epsilon);
  return met == RayOutcome::solid || (met == RayOutcome::before && static_cast<double>(ray.at.w) < kSurround);
}

bool is_below_head(const RaySamples& samples, const Ray& ray) {
  return !samples.in_joint(ray) && samples.met(ray, 0, samples.site().epsilon) == RayOutcome::through;
}

HeadEnd end_of_slice(const RaySamples& samples, const HeadSlice& slice) {
  const EdgeSplit split = split_edge(slice.below, slice.above);
  if (!samples.oblique()) return {split.at + split.half_gap - samples.site().step / 2, split.half_gap, split.found};
  return {split.at, split.half_gap, split.found && split.half_gap < kMostHeadGap};
}

void HeadPlaces::add(PlanePoint place, double gap) {
  at.push_back(place);
  half_gap += (gap - half_gap) / static_cast<double>(at.size());
}

HeadPlaces tops_of_slices(const RaySamples& samples, const Box2& search) {
  const double margin = kJamb * search.width(), width = (search.width() - 2 * margin) / kHeadSlices;
  const auto slices = head_slices(samples, search, kHeadSlices, [&](Place2 p) {
    const bool inside = p.v >= search.v0 && p.v <= search.v1;
    return std::pair(inside ? slice_at((p.u - search.u0 - margin) / width, kHeadSlices) : kNoSlice, p.v);
  });
  HeadPlaces tops;
  for (std::size_t s = 0; s < kHeadSlices; ++s) {
    const double u = search.u0 + margin + (static_cast<double>(s) + 0.5) * width;
    if (const HeadEnd end = end_of_slice(samples, slices[s]); end.found) tops.add({u, end.at}, end.half_gap);
  }
  return tops;
}

}  // namespace ilot
