// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/cleaning.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "kernels/core/quantile.h"
#include "kernels/core/radix_sort.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/morton.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {

Kept density_filter(std::span<const std::int64_t> reach2, double factor) {
  std::int64_t sum = 0, count = 0;
  for (const std::int64_t r2 : reach2) {
    if (r2 < 0) continue;
    sum += static_cast<std::int64_t>(std::sqrt(static_cast<double>(r2)));
    ++count;
  }
  const double limit = count > 0 ? factor * static_cast<double>(sum) / static_cast<double>(count) : 0;
  Kept kept(reach2.size());
  for (std::size_t i = 0; i < reach2.size(); ++i)
    kept[i] = reach2[i] >= 0 && static_cast<double>(reach2[i]) <= limit * limit;
  return kept;
}

Kept distance_split(Points points, std::int64_t max_gap, std::uint32_t min_points) {
  std::vector<std::uint32_t> all(points.size);
  std::iota(all.begin(), all.end(), 0u);
  const Clusters clusters = euclidean_clusters(points, all, max_gap);
  std::vector<std::uint32_t> size(clusters.count, 0);
  for (const std::uint32_t c : clusters.id) ++size[c];
  Kept kept(points.size);
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = size[clusters.id[i]] >= min_points;
  return kept;
}

Kept slab_split(Points points, const Plane& plane, double behind, double before) {
  Kept kept(points.size);
  for (std::size_t i = 0; i < points.size; ++i) {
    const double d = signed_distance(plane, {points.x[i], points.y[i], points.z[i]});
    kept[i] = d >= behind && d <= before;
  }
  return kept;
}

Kept isolation_filter(const NeighbourLists& neighbours, std::span<const std::int64_t> reach2, double factor) {
  Kept kept(reach2.size());
  std::vector<std::int64_t> around;
  for (std::size_t i = 0; i < reach2.size(); ++i) {
    if (reach2[i] < 0) continue;
    around.clear();
    for (const std::uint32_t j : neighbours.of(i))
      if (j != kNoNeighbour && j != i && reach2[j] >= 0) around.push_back(reach2[j]);
    if (around.empty()) continue;
    const std::int64_t quarter = nth_smallest(around, around.size() / 4);
    kept[i] = static_cast<double>(reach2[i]) <= factor * factor * static_cast<double>(quarter);
  }
  return kept;
}

namespace {

constexpr double kDirectionUnits = 0x1p20;  // lattice units per unit of a direction
constexpr int kRays = 9;                    // the ray itself and eight around it

// Directions from the station as lattice points in Morton order, with the ranges.
struct Rays : PaddedPoints {
  std::vector<double> range;
  std::vector<std::uint32_t> index;  // index of the caller's point
};

Rays rays_from(Points p, Vec3 station) {
  struct Ray {
    Vec3 direction;  // integer values
    double range;
    std::uint32_t index;
  };
  std::vector<Ray> rays;
  std::vector<std::uint64_t> codes;
  for (std::uint32_t i = 0; i < p.size; ++i) {
    const Vec3 v = Vec3{p.x[i], p.y[i], p.z[i]} - station;
    const double range = norm(v);
    if (!(range > 0)) continue;
    const auto whole = [&](double c) { return std::nearbyint(c / range * (kDirectionUnits - 1)); };
    rays.push_back({{whole(v.x), whole(v.y), whole(v.z)}, range, i});
    const auto positive = [](double c) { return static_cast<std::uint32_t>(c + kDirectionUnits); };
    const Vec3& d = rays.back().direction;
    codes.push_back(morton_code({positive(d.x), positive(d.y), positive(d.z)}));
  }
  Rays r;
  for (const std::uint32_t at : sorted_order(codes)) {
    const Ray& ray = rays[at];
    r.add(static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
          static_cast<float>(ray.direction.z));
    r.range.push_back(ray.range);
    r.index.push_back(ray.index);
  }
  r.pad();
  return r;
}

bool is_mixed_pixel(Points points, const Rays& rays, std::uint32_t at, std::span<const std::uint32_t> around,
                    const MixedPixelParams& params) {
  std::uint32_t nearer = 0, farther = 0, same = 0;
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t j : around) {
    if (j == kNoNeighbour) break;
    indices.push_back(rays.index[j]);
    if (j == at) continue;
    const double step = rays.range[j] - rays.range[at];
    nearer += step < -params.jump;
    farther += step > params.jump;
    same += std::abs(step) <= params.jump;
  }
  if (nearer < params.least || farther < params.least || same > params.support) return false;
  // Neighbouring rays have almost the same direction, so any ranges along them are near some plane along the rays. What
  // counts is how well the plane predicts the range.
  const PlaneFit fit = fit_plane(moments_of(points, indices));
  const double incidence = std::abs(dot(fit.plane.n, {rays.x[at], rays.y[at], rays.z[at]})) / kDirectionUnits;
  return !fit.unique || fit.rms > params.jump * incidence;
}

}  // namespace

Kept mixed_pixel_filter(Points points, Vec3 station, const MixedPixelParams& params) {
  Kept kept(points.size, 1);
  const Rays rays = rays_from(points, station);
  const auto n = static_cast<std::uint32_t>(rays.index.size());
  if (n == 0) return kept;
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::uint32_t> around(std::size_t{n} * kRays);
  std::vector<std::int64_t> reach2(n);
  const double reach = params.max_angle * kDirectionUnits;
  knn(build_neighbour_index(rays.points()), all, {kRays, static_cast<std::int64_t>(reach * reach)}, around, reach2);
  for (std::uint32_t i = 0; i < n; ++i)
    if (is_mixed_pixel(points, rays, i, std::span(around).subspan(std::size_t{i} * kRays, kRays), params))
      kept[rays.index[i]] = 0;
  return kept;
}

}  // namespace ilot
