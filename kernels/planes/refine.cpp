// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/refine.h"

#include <cmath>
#include <utility>

#include "kernels/planes/plane_fit.h"

namespace ilot {

std::vector<std::uint32_t> consensus_set(const OrientedPoints& points, std::span<const std::uint32_t> candidates,
                                         const Plane& plane, const RefineParams& params) {
  std::vector<std::uint32_t> members(candidates.size());
  std::size_t n = 0;
  const Points& p = points.points;
  for (const std::uint32_t i : candidates) {
    bool in = std::abs(signed_distance(plane, {p.x[i], p.y[i], p.z[i]})) <= params.epsilon;
    if (points.nx != nullptr)
      in = in && std::abs(dot(plane.n, {points.nx[i], points.ny[i], points.nz[i]})) >= params.min_cos;
    members[n] = i;
    n += in;
  }
  members.resize(n);
  return members;
}

RefinedPlane refine_plane(const OrientedPoints& points, std::span<const std::uint32_t> candidates, const Plane& start,
                          const RefineParams& params) {
  RefinedPlane r{start, consensus_set(points, candidates, start, params)};
  if (r.members.size() < params.min_points) return r;
  r.end = RefinedPlane::End::kCapped;
  while (r.rounds < params.max_rounds) {
    const PlaneFit fit = fit_plane(moments_of(points.points, r.members));
    if (!fit.unique) break;
    std::vector<std::uint32_t> next = consensus_set(points, candidates, fit.plane, params);
    if (next.size() < params.min_points) break;
    ++r.rounds;
    r.plane = fit.plane;
    const bool converged = next == r.members;
    r.members = std::move(next);
    if (!converged) continue;
    r.end = RefinedPlane::End::kConverged;
    break;
  }
  return r;
}

}  // namespace ilot
