// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"
#include "kernels/planes/plane_segments.h"

namespace ilot {

struct ColourRansacParams {
  double epsilon = 0;                  // units; delta of the document [2 cm]
  double min_cos = 0.766044443118978;  // beta, the angle between a point's normal and the plane's [40 degrees]
  double probability = 0.99;           // that a sample of three members was drawn
  std::uint32_t min_points = 1000;     // fewest points of a plane
  std::uint32_t max_planes = 0xffffffffu;
  std::uint64_t max_draws = 100000;  // per plane
  std::uint64_t key = 0;
};

// The progress of the search for one plane: the consensus set after each draw that enlarged it.
struct DrawProgress {
  std::uint64_t draw = 0;  // from 1
  std::uint32_t support = 0;
};

struct ColourRansacPlanes {
  PlaneSegments segments;
  std::vector<std::uint64_t> draws;                 // per plane, until the bound was reached
  std::vector<std::vector<DrawProgress>> progress;  // per plane
};

// RANSAC guided by colour [Lorraine thesis, 2.2.2]. The first samples of a plane come from all points that are left.
// Once there is a consensus set, samples come from the colour class of most of its points, while the share of the class
// in the set is larger than its share in the cloud. The search stops at the bound of the sampler in use: kappa' inside
// the class, kappa outside (plan_sampling). The best plane is refined [Lorraine thesis, 2.2.2] and its points are
// removed. The search ends when a plane has fewer than min_points. `colour_class` is that of colour_classes(), from 1.
// When it is empty, the search is the classical one. After each improvement, draws are made and counted one at a time,
// then two, four and eight at a time, so their number may exceed a bound. O(draws x n).
ColourRansacPlanes colour_ransac(const OrientedPoints& points, std::span<const std::uint32_t> colour_class,
                                 const ColourRansacParams& params);

}  // namespace ilot
