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
  std::uint32_t min_points = 1000;     // of a plane
  std::uint32_t max_planes = 0xffffffffu;
  std::uint64_t max_draws = 100000;  // per plane
  std::uint64_t key = 0;
};

// How the search for one plane went: the consensus set after each draw that enlarged it.
struct DrawProgress {
  std::uint64_t draw = 0;  // from 1
  std::uint32_t support = 0;
};

struct ColourRansacPlanes {
  PlaneSegments segments;
  std::vector<std::uint64_t> draws;                 // per plane, until the bound was met
  std::vector<std::vector<DrawProgress>> progress;  // per plane
};

// RANSAC guided by colour [Lorraine thesis, 2.2.2]. The first samples of a plane come from all points left; once there
// is a consensus set, from the colour class that most of it has, while that class holds a larger share of it than the
// cloud does, and the search stops at the bound that belongs to the sampler in use: kappa' inside the class, kappa
// outside (plan_sampling). The best plane is refined [Lorraine thesis, 2.2.2] and its points are taken. Ends when a
// plane has fewer than min_points. `colour_class` as colour_classes() gives it, 1 and up; empty: the classical search.
// Draws are counted one at a time after each improvement, then two, four, eight, which a bound may overrun. O(draws x
// n).
ColourRansacPlanes colour_ransac(const OrientedPoints& points, std::span<const std::uint32_t> colour_class,
                                 const ColourRansacParams& params);

}  // namespace ilot
