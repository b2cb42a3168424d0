// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

struct RefineParams {
  double epsilon = 0;            // units; greatest distance of a member, inclusive
  double min_cos = 0;            // of the angle between a member's normal and the plane's; ignored without normals
  std::uint32_t min_points = 3;  // the rounds end when there are fewer members
  int max_rounds = 10;           // the sets can cycle, so the number of rounds is limited
};

struct RefinedPlane {
  Plane plane;                         // the plane that `members` were tested against
  std::vector<std::uint32_t> members;  // of the candidates, in their order
  int rounds = 0;                      // least-squares fits made
  enum class End { kConverged, kCapped, kTooFew } end = End::kTooFew;
};

// Returns the members of one plane: the candidates (indices) within epsilon of it whose normals agree, judged in
// double. O(n).
std::vector<std::uint32_t> consensus_set(const OrientedPoints& points, std::span<const std::uint32_t> candidates,
                                         const Plane& plane, const RefineParams& params);

// Refines a plane [Lorraine thesis, 2.2.2]. Consensus set and least squares alternate from the start until the set no
// longer changes, the rounds are used up, or a set would have fewer than min_points. In the last case the previous set
// is kept. Every member is within epsilon of the plane returned. With too few members at the start, the start and its
// members are returned. O(rounds x n).
RefinedPlane refine_plane(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
                          const RefineParams& params);

}  // namespace ilot
