// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/facade_ransac.h"

#include <cmath>

#include "kernels/core/portable_math.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/ransac.h"
#include "kernels/planes/region_planes.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

double sine_degrees(double degrees) {
  return cos_degrees(degrees - 90);
}

PlaneSegments inclined_segments(const OrientedPoints& points, const FacadeRansacParams& params) {
  Indices inclined;
  for (std::uint32_t i = 0; i < points.points.size; ++i) {
    const double z = std::abs(points.nz[i]);
    if (z > params.inclined_from && z < params.inclined_to) inclined.push_back(i);
  }
  const Clusters clusters = euclidean_clusters(points.points, inclined, params.inclined_gap);
  Regions regions{Indices(points.points.size, 0), clusters.count, Indices(clusters.count, 0)};
  for (std::size_t i = inclined.size(); i-- > 0;) {
    regions.id[inclined[i]] = clusters.id[i] + 1;
    regions.seed[clusters.id[i]] = inclined[i];
  }
  return planes_of_regions(points.points, regions,
                           {params.epsilon, params.inclined_points, params.inclined_gap, PlaneEstimate::kLeastSquares});
}

// The points without a label, and where they come from.
struct Pool {
  std::vector<float> x, y, z, nx, ny, nz;
  Indices index;
  OrientedPoints view() const {
    return {{x.data(), y.data(), z.data(), index.size()}, nx.data(), ny.data(), nz.data()};
  }
};

Pool pool_of(const OrientedPoints& p, const Indices& label) {
  constexpr std::size_t kPadding = 16;
  Pool pool;
  for (std::uint32_t i = 0; i < p.points.size; ++i)
    if (label[i] == 0) pool.index.push_back(i);
  const auto gather = [&](const float* from, std::vector<float>& to) {
    to.reserve(pool.index.size() + kPadding);
    for (const std::uint32_t i : pool.index) to.push_back(from[i]);
    to.resize(pool.index.size() + kPadding, 0.0f);
  };
  gather(p.points.x, pool.x);
  gather(p.points.y, pool.y);
  gather(p.points.z, pool.z);
  gather(p.nx, pool.nx);
  gather(p.ny, pool.ny);
  gather(p.nz, pool.nz);
  return pool;
}

}  // namespace

FacadeRansacParams with_degrees(FacadeRansacParams params, double inclined_from, double inclined_to, double parallel) {
  params.inclined_from = sine_degrees(inclined_from);
  params.inclined_to = sine_degrees(inclined_to);
  params.parallel_sine = sine_degrees(parallel);
  return params;
}

FacadeRansacParams with_raw_numbers(FacadeRansacParams params) {
  params.inclined_from = 0.2;
  params.inclined_to = 0.8;
  params.parallel_sine = 0.02;
  return params;
}

FacadeSegments facade_ransac(const OrientedPoints& points, const FacadeRansacParams& params) {
  FacadeSegments r;
  r.segments.label.assign(points.points.size, 0);
  r.direction = facade_direction(points);
  if (!r.direction.found) return r;
  r.segments = inclined_segments(points, params);
  r.inclined = static_cast<std::uint32_t>(r.segments.planes.size());
  const Pool pool = pool_of(points, r.segments.label);
  const PlaneSegments parallel = ransac_planes(pool.view(), {params.epsilon,
                                                             params.min_cos,
                                                             params.connectivity,
                                                             params.parallel_points,
                                                             params.probability,
                                                             params.key,
                                                             {r.direction.along, Vec3{0, 0, 1}},
                                                             params.parallel_sine});
  r.segments.planes.insert(r.segments.planes.end(), parallel.planes.begin(), parallel.planes.end());
  for (std::size_t i = 0; i < pool.index.size(); ++i)
    if (parallel.label[i] != 0) r.segments.label[pool.index[i]] = r.inclined + parallel.label[i];
  return r;
}

}  // namespace ilot
