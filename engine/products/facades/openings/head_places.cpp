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
  std::vector<HeadSlice> slices(kHeadSlices);
  const double margin = kJamb * search.width(), width = (search.width() - 2 * margin) / kHeadSlices;
  Rays near = samples.near(search);
  const int level = thinning_level(near, kMostHeadSamples, [](const Ray&) { return true; });
  for (const Ray& ray : near) {
    if (!is_kept(ray, level)) continue;
    const Place2 p = samples.crossing(ray, 0);
    const double at = (p.u - search.u0 - margin) / width;
    if (at < 0 || at >= kHeadSlices || p.v < search.v0 || p.v > search.v1) continue;
    if (is_below_head(samples, ray)) slices[static_cast<std::size_t>(at)].below.push_back(p.v);
    if (is_above_head(samples, ray)) slices[static_cast<std::size_t>(at)].above.push_back(p.v);
  }
  HeadPlaces tops;
  for (std::size_t s = 0; s < kHeadSlices; ++s) {
    const double u = search.u0 + margin + (static_cast<double>(s) + 0.5) * width;
    if (const HeadEnd end = end_of_slice(samples, slices[s]); end.found) tops.add({u, end.at}, end.half_gap);
  }
  return tops;
}

}  // namespace ilot
