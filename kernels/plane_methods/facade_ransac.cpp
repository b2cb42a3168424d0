// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/facade_ransac.h"

#include <cmath>

#include "kernels/core/portable_math.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/oriented_pool.h"
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
  const OrientedPool pool = unlabelled(points, r.segments.label);
  const PlaneSegments parallel = ransac_planes(pool.oriented(), {params.epsilon,
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
