// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/plane_methods.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "kernels/core/portable_math.h"
#include "kernels/neighbours/knn.h"
#include "kernels/plane_methods/colour_ransac.h"
#include "kernels/plane_methods/facade_ransac.h"
#include "kernels/plane_methods/hough_planes.h"
#include "kernels/plane_methods/roof_ransac.h"
#include "kernels/plane_methods/split_merge.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/ransac.h"
#include "kernels/planes/region_growing.h"
#include "kernels/planes/region_planes.h"
#include "kernels/planes/relabel.h"
#include "kernels/shapes/shape_ransac.h"

namespace ilot {
namespace {

constexpr std::uint32_t kNeighbours = 16;    // for region growing and for relabelling
constexpr std::uint32_t kFewNeighbours = 8;  // for relabelling from the air, where faces are wide compared with epsilon
// The share of epsilon within which points count for a plane where noise is large. 2.3 of 3.5 standard deviations
// contain 98% of the points of a plane. They contain far fewer points of its neighbours, which would pull the plane
// towards them.
// Derived: see above: 2.3 of 3.5 standard deviations.
constexpr double kCore = 0.65;
constexpr int kRelabelRounds = 4;
// Choice: a fifth of epsilon; small planes lose a strip of that width to large ones.
constexpr double kLean = 0.2;  // epsilons by which borders move towards the larger plane, seen from the ground
// Choice: thresholds of the methods that grow and vote (docs/methods.md); rough surfaces need larger ones.
constexpr double kPairDegrees = 5, kSmoothDegrees = 2, kVoteDegrees = 8;

// Derived: airborne scanners look aside by up to 30 degrees, so that walls are met at 60 degrees or more: spots on them
// are 1 / cos(60 degrees) times as far apart as on the ground.
constexpr double kUprightStretch = 2;

PlaneSegments by_ransac(const PlaneSearch& s) {
  RansacParams params{s.params.epsilon,      cos_degrees(s.params.normal_angle),
                      s.params.connectivity, s.params.min_points,
                      s.probability,         s.key};
  if (s.from == SeenFrom::air) params.most_stretch = kUprightStretch;
  return ransac_planes(s.points, params);
}

std::vector<std::uint32_t> neighbours_of_all(const PlaneSearch& s, std::uint32_t k) {
  constexpr std::uint32_t kBatch = 4096;
  const std::uint32_t n = static_cast<std::uint32_t>(s.points.points.size);
  const KnnParams params{static_cast<int>(k), s.params.connectivity * s.params.connectivity};
  std::vector<std::uint32_t> lists(std::size_t{n} * k), queries(kBatch);
  std::vector<std::int64_t> reach2(kBatch);
  for (std::uint32_t first = 0; first < n; first += kBatch) {
    const std::uint32_t count = std::min(kBatch, n - first);
    std::iota(queries.begin(), queries.begin() + count, first);
    knn(s.index, std::span(queries).first(count), params,
        std::span(lists).subspan(std::size_t{first} * k, std::size_t{count} * k), std::span(reach2).first(count));
  }
  return lists;
}

PlaneSegments planes_of(const PlaneSearch& s, const Regions& regions) {
  return planes_of_regions(s.points.points, regions,
                           {s.params.epsilon, s.params.min_points, s.params.connectivity, PlaneEstimate::kBest});
}

PlaneSegments by_region_growing(const PlaneSearch& s, const NeighbourLists& near) {
  return planes_of(
      s, grow_by_pairs(s.points.points, s.normals, near,
                       {cos_degrees(kPairDegrees), s.params.epsilon / 2, s.params.connectivity, s.params.min_points}));
}

PlaneSegments by_smooth_growing(const PlaneSearch& s, const NeighbourLists& near) {
  SmoothGrowthParams params;
  params.min_cos = cos_degrees(kSmoothDegrees);
  params.max_gap = s.params.connectivity;
  params.min_points = s.params.min_points;
  return planes_of(s, grow_smooth(s.points.points, s.normals, near, params));
}

PlaneSegments by_split_merge(const PlaneSearch& s) {
  SplitMergeParams params;
  params.epsilon = s.params.epsilon;
  params.tolerance = s.params.epsilon / 2.5;
  params.max_step = s.params.epsilon / 2;
  params.min_edge = std::max<std::int64_t>(1, 2 * s.params.connectivity / 3);
  params.min_points = s.params.min_points;
  return split_merge(s.points.points, params);
}

PlaneSegments by_hough(const PlaneSearch& s) {
  HoughPlanesParams params;
  params.epsilon = s.params.epsilon;
  params.distance_step = 2 * s.params.epsilon;
  params.min_vote_cos = cos_degrees(kVoteDegrees);
  params.min_cos = cos_degrees(s.params.normal_angle);
  params.connectivity = s.params.connectivity;
  params.min_points = s.params.min_points;
  return hough_planes(s.points, params);
}

PlaneSegments by_roof_ransac(const PlaneSearch& s, const NeighbourLists& near) {
  RoofRansacParams params;
  params.epsilon = s.params.epsilon;
  params.stray_gap = s.params.connectivity;
  params.min_points = s.params.min_points;
  params.key = s.key;
  return roof_ransac(s.points.points, near, params);
}

PlaneSegments by_facade_ransac(const PlaneSearch& s) {
  FacadeRansacParams params;
  params.epsilon = s.params.epsilon;
  params.inclined_gap = s.params.connectivity;
  params.connectivity = s.params.connectivity;
  params.inclined_points = params.parallel_points = s.params.min_points;
  params.probability = s.probability;
  params.key = s.key;
  return facade_ransac(s.points, params).segments;
}

ShapeRansacParams shape_params(const PlaneSearch& s, std::uint32_t min_points, unsigned kinds) {
  ShapeRansacParams params;
  params.epsilon = s.params.epsilon;
  params.min_cos = cos_degrees(s.params.normal_angle);
  params.connectivity = s.params.connectivity;
  params.min_points = min_points;
  params.probability = s.probability;
  params.kinds = kinds;
  params.key = s.key;
  return params;
}

// Whether a shape is as thin as the edge strip where two planes meet: most of its points are within four epsilons
// around a plane. Along such edges, normals are mixtures and turn evenly from one plane to the other, as those of a
// thin cylinder or a steep cone do.
bool is_flat(Points points, std::span<const std::uint32_t> members, double epsilon) {
  // Derived: see above: half of the four epsilons of an edge strip.
  constexpr double kEdgeStrip = 2;  // root mean square distance, in epsilons
  const Moments m = moments_of(points, members);
  const PlaneFit fit = fit_plane(m);
  return !fit.unique || rms_to_plane(m, fit.plane) <= kEdgeStrip * epsilon;
}

// Whether the points belong to two planes that meet. For example, a cone of 45 degrees touches a wall and the underside
// of its band. Then the two largest planes contain nearly all points. A surface that continues to bend leaves the
// planes.
bool is_edge(const OrientedPoints& points, std::span<const std::uint32_t> members, ShapeRansacParams params) {
  // Choice: nine of ten points; a surface that bends little is taken for an edge and keeps planes.
  constexpr double kShare = 0.9;
  std::array<std::vector<float>, 6> column;
  const std::array<const float*, 6> from{points.points.x, points.points.y, points.points.z,
                                         points.nx,       points.ny,       points.nz};
  for (std::size_t c = 0; c < column.size(); ++c)
    for (const std::uint32_t i : members) column[c].push_back(from[c][i]);
  params.kinds = shape_bit(ShapeKind::kPlane);
  params.min_points = std::max<std::uint32_t>(3, static_cast<std::uint32_t>(members.size() / 10));
  const ShapeSegments planes = ransac_shapes({{column[0].data(), column[1].data(), column[2].data(), members.size()},
                                              column[3].data(),
                                              column[4].data(),
                                              column[5].data()},
                                             params);
  std::vector<std::uint32_t> sizes;
  for (const FoundShape& plane : planes.shapes) sizes.push_back(plane.points);
  std::sort(sizes.rbegin(), sizes.rend());
  const std::uint64_t two = (sizes.empty() ? 0 : sizes[0]) + (sizes.size() < 2 ? 0 : sizes[1]);
  return static_cast<double>(two) >= kShare * static_cast<double>(members.size());
}

PlaneSegments by_shape_ransac(const PlaneSearch& s) {
  const ShapeRansacParams params = shape_params(s, s.params.min_points, shape_bit(ShapeKind::kPlane));
  ShapeSegments found = ransac_shapes(s.points, params);
  PlaneSegments segments{std::move(found.label), {}};
  for (const FoundShape& shape : found.shapes) segments.planes.push_back(plane_of(shape.shape));
  return segments;
}

PlaneSegments by_colour_ransac(const PlaneSearch& s) {
  ColourRansacParams params;
  params.epsilon = s.params.epsilon;
  params.min_cos = cos_degrees(s.params.normal_angle);
  params.probability = s.probability;
  params.min_points = s.params.min_points;
  params.key = s.key;
  return colour_ransac(s.points, s.colour_class, params).segments;
}

// Whether the method works on neighbours itself.
bool grows(PlaneMethod method) {
  return method == PlaneMethod::region_growing || method == PlaneMethod::smooth_growing ||
         method == PlaneMethod::roof_ransac;
}

PlaneSegments by_method(PlaneMethod method, const PlaneSearch& search, const NeighbourLists& near) {
  switch (method) {
    case PlaneMethod::region_growing:
      return by_region_growing(search, near);
    case PlaneMethod::smooth_growing:
      return by_smooth_growing(search, near);
    case PlaneMethod::split_merge:
      return by_split_merge(search);
    case PlaneMethod::hough:
      return by_hough(search);
    case PlaneMethod::roof_ransac:
      return by_roof_ransac(search, near);
    case PlaneMethod::facade_ransac:
      return by_facade_ransac(search);
    case PlaneMethod::shape_ransac:
      return by_shape_ransac(search);
    case PlaneMethod::colour_ransac:
      return by_colour_ransac(search);
    case PlaneMethod::ransac:
      break;
  }
  return by_ransac(search);
}

}  // namespace

PlaneSegments find_planes(PlaneMethod method, const PlaneSearch& search) {
  const bool from_the_air = search.from == SeenFrom::air;
  const bool noisy = from_the_air && search.params.noisy;
  const std::uint32_t k = from_the_air && !noisy && !grows(method) ? kFewNeighbours : kNeighbours;
  std::vector<std::uint32_t> lists;  // made only when needed: they are as large as the data of a method
  if (grows(method)) lists = neighbours_of_all(search, k);
  PlaneSearch narrow = search;
  if (noisy) narrow.params.epsilon *= kCore;
  PlaneSegments found = by_method(method, narrow, {lists, k});
  if (lists.empty()) lists = neighbours_of_all(search, k);
  RelabelParams relabel{search.params.epsilon, search.params.connectivity, 2, kRelabelRounds};
  if (!from_the_air) relabel.lean = kLean * search.params.epsilon;
  if (noisy) relabel.border = RelabelParams::Border::nearest;
  relabel_until_stable(search.points.points, {lists, k}, relabel, search.params.min_points, found);
  return found;
}

ShapeSegments find_curved(const PlaneSearch& search, std::uint32_t min_points) {
  const ShapeRansacParams params = shape_params(search, min_points, kAllShapes);
  ShapeSegments all = ransac_shapes(search.points, params);
  std::vector<std::vector<std::uint32_t>> members(all.shapes.size());
  for (std::uint32_t i = 0; i < all.label.size(); ++i)
    if (all.label[i] != 0) members[all.label[i] - 1].push_back(i);
  ShapeSegments curved;
  std::vector<std::uint32_t> number{0};  // by label: number among the curved shapes, 0 = a plane
  for (std::size_t s = 0; s < all.shapes.size(); ++s) {
    const bool plane = all.shapes[s].shape.kind == ShapeKind::kPlane ||
                       is_flat(search.points.points, members[s], search.params.epsilon) ||
                       is_edge(search.points, members[s], params);
    if (!plane) curved.shapes.push_back(all.shapes[s]);
    number.push_back(plane ? 0 : static_cast<std::uint32_t>(curved.shapes.size()));
  }
  curved.label = std::move(all.label);
  for (std::uint32_t& label : curved.label) label = number[label];
  return curved;
}

bool wants_curved(const PlanesSettings& settings, double step_m) {
  // Choice: planes.curved_points points cover this area at most; sparser cells show no curvature that noise does not.
  constexpr double kMostSquareMetres = 1;
  const bool dense = step_m > 0 && settings.curved_points * step_m * step_m <= kMostSquareMetres;
  return settings.curved.value_or(!settings.method && dense);
}

std::uint64_t bytes_per_point(std::optional<PlaneMethod> method) {
  constexpr std::uint64_t kShapes = 208, kGrown = 104, kOthers = 80;  // measured: 190, 95, 62
  const PlaneMethod largest = method.value_or(PlaneMethod::shape_ransac);
  if (largest == PlaneMethod::shape_ransac) return kShapes;
  return grows(largest) ? kGrown : kOthers;
}

PlaneMethod choose_method(const PlanesSettings& settings, SeenFrom from) {
  if (settings.method) return *settings.method;
  return from == SeenFrom::ground ? PlaneMethod::shape_ransac : PlaneMethod::ransac;
}

}  // namespace ilot
