// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/region_planes.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/refine.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::size_t kMeanNormalPoints = 10000;  // regions above it use least squares
constexpr std::size_t kMeanNormalSamples = 64;
constexpr std::size_t kSeedPoints = 64;  // neighbourhood of a seed that starts a plane
constexpr std::size_t kSeeds = 8;        // further seeds, evenly spread, where not all points are on one plane

double squared_distance(const Points& p, std::uint32_t i, std::uint32_t j) {
  const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j], dz = p.z[i] - p.z[j];
  return dx * dx + dy * dy + dz * dz;
}

// Returns the `count` members nearest to `centre`, ties by index.
Indices nearest(const Points& p, const Indices& members, std::uint32_t centre, std::size_t count) {
  std::vector<std::pair<double, std::uint32_t>> near;
  near.reserve(members.size());
  for (const std::uint32_t i : members) near.emplace_back(squared_distance(p, i, centre), i);
  count = std::min(count, near.size());
  std::nth_element(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count) - 1, near.end());
  Indices r(count);
  for (std::size_t i = 0; i < count; ++i) r[i] = near[i].second;
  return r;
}

PlaneFit fit_around(const Points& p, const Indices& members, std::uint32_t centre, std::size_t count) {
  return fit_plane(moments_of(p, nearest(p, members, centre, count)));
}

// The mean normal [Boltcheva et al. 2019, 3.2.1]. Normals are turned to the side of the first one before they are
// summed.
Plane mean_normal_plane(const Points& p, const Indices& members) {
  const std::size_t wide = std::max<std::size_t>(3, members.size() / 5);
  const std::size_t stride = std::max<std::size_t>(1, members.size() / kMeanNormalSamples);
  Vec3 sum;
  for (std::size_t m = 0; m < members.size(); m += stride) {
    const PlaneFit fit = fit_around(p, members, members[m], wide);
    if (fit.unique) sum = dot(sum, fit.plane.n) < 0 ? sum - fit.plane.n : sum + fit.plane.n;
  }
  const Moments all = moments_of(p, members);
  if (dot(sum, sum) == 0) return fit_plane(all).plane;
  Vec3 n = (1 / norm(sum)) * sum;
  if (n.z < 0 || (n.z == 0 && (n.y < 0 || (n.y == 0 && n.x < 0)))) n = -1.0 * n;
  return {n, -dot(n, centroid(all))};
}

struct Part {
  Plane plane;
  Indices members;
};

Part least_squares_part(const Points& p, const Indices& members, std::uint32_t seed, const RefineParams& params) {
  Part best;
  const auto offer = [&](const PlaneFit& start) {
    if (!start.unique) return;
    RefinedPlane r = refine_plane({p}, members, start.plane, params);
    if (r.members.size() > best.members.size()) best = {r.plane, std::move(r.members)};
  };
  offer(fit_plane(moments_of(p, members)));
  if (best.members.size() == members.size()) return best;
  offer(fit_around(p, members, seed, kSeedPoints));
  for (std::size_t s = 0; s < kSeeds; ++s)
    offer(fit_around(p, members, members[members.size() * (2 * s + 1) / (2 * kSeeds)], kSeedPoints));
  return best;
}

Part best_part(const Points& p, const Indices& members, std::uint32_t seed, const RegionPlaneParams& params) {
  const RefineParams refine{params.epsilon, 0, params.min_points};
  const bool mean = params.estimate != PlaneEstimate::kLeastSquares && members.size() <= kMeanNormalPoints;
  Part best;
  if (params.estimate != PlaneEstimate::kMeanNormal || !mean) best = least_squares_part(p, members, seed, refine);
  if (!mean || best.members.size() == members.size()) return best;
  const Plane plane = mean_normal_plane(p, members);
  Indices in = consensus_set({p}, members, plane, refine);
  if (in.size() > best.members.size()) best = {plane, std::move(in)};
  return best;
}

// Returns the remaining members (ascending) in connected components.
std::vector<Indices> unassigned(const Points& p, const Indices& members, const Indices& taken,
                                const RegionPlaneParams& params) {
  Indices rest;
  std::set_difference(members.begin(), members.end(), taken.begin(), taken.end(), std::back_inserter(rest));
  if (rest.size() < params.min_points) return {};
  const Clusters clusters = euclidean_clusters(p, rest, params.connectivity);
  std::vector<Indices> parts(clusters.count);
  for (std::size_t i = 0; i < rest.size(); ++i) parts[clusters.id[i]].push_back(rest[i]);
  std::erase_if(parts, [&](const Indices& part) { return part.size() < params.min_points; });
  return parts;
}

}  // namespace

PlaneSegments planes_of_regions(Points points, const Regions& regions, const RegionPlaneParams& params) {
  std::vector<Indices> members(regions.count);
  for (std::uint32_t i = 0; i < regions.id.size(); ++i)
    if (regions.id[i] != 0) members[regions.id[i] - 1].push_back(i);
  PlaneSegments result;
  result.label.assign(points.size, 0);
  for (std::uint32_t r = 0; r < regions.count; ++r) {
    std::deque<Indices> parts;
    if (members[r].size() >= params.min_points) parts.push_back(std::move(members[r]));
    std::uint32_t seed = regions.seed[r];
    while (!parts.empty()) {
      const Indices part = std::move(parts.front());
      parts.pop_front();
      const Part taken = best_part(points, part, seed, params);
      if (taken.members.size() < params.min_points) continue;
      result.planes.push_back(taken.plane);
      for (const std::uint32_t i : taken.members) result.label[i] = static_cast<std::uint32_t>(result.planes.size());
      for (Indices& rest : unassigned(points, part, taken.members, params)) parts.push_back(std::move(rest));
      if (!parts.empty()) seed = parts.front()[parts.front().size() / 2];
    }
  }
  return result;
}

}  // namespace ilot
