// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/roof_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/roofs/faces/level_tops.h"
#include "engine/products/roofs/faces/plane_joining.h"
#include "engine/products/roofs/faces/shown_heights.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "kernels/core/union_find.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/hough_normals.h"
#include "kernels/neighbours/knn.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/ransac.h"
#include "kernels/planes/relabel.h"
#include "kernels/planes/run_neighbours.h"

namespace ilot {
namespace {

constexpr double kUnit = 0.001;  // metres per unit of the kernels' points
constexpr std::uint32_t kNeighbours = kSamplingNeighbours;
constexpr int kVoters = 20;
constexpr double kPi = 3.141592653589793;
// Measured: the comment on the line.
constexpr double kVoteDeviation = 0.12;  // gives fewer votes than the default: half the time, the same roofs
// Derived: 3.5 standard deviations contain 99.95 % of normal noise.
constexpr double kNoiseFactor = 3.5;
// Choice: a chimney; smaller faces are tops (level_tops.h).
constexpr double kLeastFaceArea = 0.5;  // m2 that the points of the smallest face cover
constexpr int kFewestPoints = 6;
// Choice: two lost points in a row; 0.6 m at least, so that a snow guard does not split a face of a dense cloud.
constexpr double kPlaneGapSteps = 3, kLeastGap = 0.6;  // metres
constexpr int kFirstRounds = 1, kRelabelRounds = 3;    // rounds before and after similar planes are joined
// Choice: mansards have 70 degrees; steeper ones are taken for walls.
constexpr double kSteepest = 0.25881904510252074;  // cosine of 75 degrees

// A site's points in the form that the kernels need: whole millimetres from their lowest corner, padded.
struct Cloud : PaddedOrientedPoints {
  Vec3 corner;  // metres
};

Cloud cloud_of(const std::vector<Vec3>& points) {
  Cloud c;
  c.reset(points.size());
  constexpr double kFar = std::numeric_limits<double>::infinity();
  c.corner = {kFar, kFar, kFar};
  for (const Vec3& p : points)
    c.corner = {std::min(c.corner.x, p.x), std::min(c.corner.y, p.y), std::min(c.corner.z, p.z)};
  for (std::size_t i = 0; i < c.size; ++i) {
    const Vec3 p = points[i] - c.corner;
    c.x[i] = static_cast<float>(std::round(p.x / kUnit));
    c.y[i] = static_cast<float>(std::round(p.y / kUnit));
    c.z[i] = static_cast<float>(std::round(p.z / kUnit));
  }
  return c;
}

std::uint64_t content_key(const Cloud& c) {
  std::uint64_t key = c.size;
  for (std::size_t i = 0; i < c.size; ++i)
    key += mix64(mix64(static_cast<std::uint64_t>(c.x[i]) << 32 | static_cast<std::uint64_t>(c.y[i])) ^
                 static_cast<std::uint64_t>(c.z[i]));
  return key;
}

std::vector<std::uint32_t> neighbours_of_all(const NeighbourIndex& index, std::vector<std::int64_t>& reach2) {
  std::vector<std::uint32_t> all(index.points.size), lists(index.points.size * kNeighbours);
  std::iota(all.begin(), all.end(), 0u);
  reach2.resize(index.points.size);
  knn(index, all, {kNeighbours, kMaxSquaredReach}, lists, reach2);
  return lists;
}

// The normal of the flattest neighbour of i (i included) whose plane passes within epsilon of i.
PackedNormal borrowed(const NeighbourLists& neighbours, std::span<const PackedNormal> normals, double epsilon,
                      const Cloud& c, std::uint32_t i) {
  PackedNormal best = normals[i];
  const Vec3 p = c.position(i);
  for (const std::uint32_t j : neighbours.of(i)) {
    if (j == kNoNeighbour) break;
    const PackedNormal& n = normals[j];
    if (n.curvature >= best.curvature) continue;
    const double off = dot({double(n.x), double(n.y), double(n.z)}, p - c.position(j)) / 32767;
    if (std::abs(off) <= epsilon) best = n;
  }
  return best;
}

// Computes normals by principal components. Beside an edge these would average over both faces, so a point there takes
// the normal of the flattest neighbour whose plane contains it. Where no neighbour is flat either, its neighbours vote.
void give_normals(const NeighbourIndex& index, const NeighbourLists& neighbours, std::span<const std::int64_t> reach2,
                  double step, double epsilon, Cloud& c) {
  std::vector<std::uint32_t> points(c.size);
  std::iota(points.begin(), points.end(), 0u);
  std::vector<PackedNormal> own(c.size);
  normals_of_neighbours(c.points(), points, kNeighbours, neighbours.indices, reach2, own);
  // The curvature on a plane with noise of a third of epsilon: l0 / (l0 + l1 + l2), where l1 = l2 = a quarter of the
  // squared radius.
  const double noise2 = epsilon * epsilon / 9, spread2 = kNeighbours * step * step / (4 * kPi);
  const double flat = std::min(1.0, 3 * noise2 / (noise2 + 2 * spread2)) * 65535;
  std::vector<PackedNormal> given(own);
  std::vector<std::uint32_t> at_edges;
  for (const std::uint32_t i : points) {
    if (own[i].curvature <= flat) continue;
    given[i] = borrowed(neighbours, own, epsilon, c, i);
    if (given[i].curvature > 10 * flat) at_edges.push_back(i);
  }
  std::vector<PackedNormal> sharp(at_edges.size());
  std::vector<std::int64_t> sharp_reach2(at_edges.size());
  hough_normals(index, at_edges, {kVoters, kMaxSquaredReach, 0.95, kVoteDeviation}, sharp, sharp_reach2);
  for (std::size_t e = 0; e < at_edges.size(); ++e) given[at_edges[e]] = sharp[e];
  // Derived: the unit of packed normals.
  constexpr float kScale = 1.0f / 32767;
  for (std::size_t i = 0; i < c.size; ++i) {
    c.nx[i] = static_cast<float>(given[i].x) * kScale;
    c.ny[i] = static_cast<float>(given[i].y) * kScale;
    c.nz[i] = static_cast<float>(given[i].z) * kScale;
  }
}

// Measures the points again without those on walls. Where walls were scanned so much more densely than the roof that
// its own step is a gap by theirs, the roof's counts.
Sampling sampling_of_roof(const Cloud& c, const Sampling& all) {
  std::vector<Vec3> others;
  for (std::uint32_t i = 0; i < c.size; ++i) {
    const bool known = c.nx[i] != 0 || c.ny[i] != 0 || c.nz[i] != 0;
    if (!known || std::abs(c.nz[i]) >= kSteepest) others.push_back(kUnit * c.position(i));
  }
  // Choice: walls with a quarter of the points or less do not decide what is measured of all.
  if (4 * others.size() >= 3 * c.size) return all;
  const Cloud roof = cloud_of(others);
  const Sampling found = measure_sampling(build_neighbour_index(roof.points()));
  return found.step > kPlaneGapSteps * all.step ? found : all;
}

std::vector<Moments> moments_of_planes(const Cloud& c, const PlaneSegments& s) {
  std::vector<std::vector<std::uint32_t>> members(s.planes.size());
  for (std::uint32_t i = 0; i < c.size; ++i)
    if (s.label[i] != 0) members[s.label[i] - 1].push_back(i);
  std::vector<Moments> moments;
  for (const auto& m : members) moments.push_back(moments_of(c.points(), m));
  return moments;
}

// Pairs of planes whose points are neighbours, the pairs with the most such neighbours first.
std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts(const NeighbourLists& neighbours,
                                                              const PlaneSegments& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> count;
  for (std::uint32_t i = 0; i < s.label.size(); ++i) {
    if (s.label[i] == 0) continue;
    for (const std::uint32_t j : neighbours.of(i)) {
      if (j == kNoNeighbour) break;
      if (s.label[j] > s.label[i]) ++count[{s.label[i] - 1, s.label[j] - 1}];
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const auto& [pair, n] : count) pairs.push_back(pair);
  std::stable_sort(pairs.begin(), pairs.end(), [&](auto a, auto b) { return count.at(a) > count.at(b); });
  return pairs;
}

// Joins planes that touch, have similar normals and stay within half of epsilon of their common plane.
void join_alike(const Cloud& c, const NeighbourLists& neighbours, double epsilon, double same_angle, PlaneSegments& s) {
  std::vector<Moments> moments = moments_of_planes(c, s);
  std::vector<std::uint32_t> parents(s.planes.size());
  UnionFind groups(parents);
  const double min_cos = cos_degrees(same_angle);
  std::vector<Plane> planes = s.planes;
  for (const auto& [a, b] : contacts(neighbours, s)) {
    const std::uint32_t g = groups.find(a), h = groups.find(b);
    if (g == h || std::abs(dot(planes[g].n, planes[h].n)) < min_cos) continue;
    Moments both = moments[g];
    both.add(moments[h]);
    const PlaneFit fit = fit_plane(both);
    if (!fit.unique || rms_to_plane(moments[g], fit.plane) > epsilon / 2 ||
        rms_to_plane(moments[h], fit.plane) > epsilon / 2)
      continue;
    groups.unite(g, h);
    moments[groups.find(g)] = both;
    planes[groups.find(g)] = fit.plane;
  }
  std::vector<std::uint32_t> number(s.planes.size() + 1, 0);
  std::vector<Plane> kept;
  for (std::uint32_t p = 0; p < s.planes.size(); ++p) {
    if (groups.find(p) == p) {
      kept.push_back(planes[p]);
      number[p + 1] = static_cast<std::uint32_t>(kept.size());
    } else {
      number[p + 1] = number[groups.find(p) + 1];
    }
  }
  for (std::uint32_t& label : s.label) label = number[label];
  s.planes = std::move(kept);
}

// Keeps the planes that a roof can have, and the labels of the points on them.
void sort_out(const RoofSite& site, const Cloud& c, const PlaneSegments& s, RoofPlanes& r) {
  std::vector<std::uint32_t> number(s.planes.size() + 1, 0);
  std::vector<std::uint8_t> used(s.planes.size() + 1, 0);
  for (const std::uint32_t label : s.label) used[label] = 1;
  for (std::size_t p = 0; p < s.planes.size(); ++p) {
    if (s.planes[p].n.z < kSteepest || !used[p + 1]) continue;
    r.planes.push_back(roof_plane(s.planes[p], c.corner));
    number[p + 1] = static_cast<std::uint32_t>(r.planes.size());
  }
  for (std::size_t i = 0; i < c.size; ++i) {
    const std::uint32_t label = number[s.label[i]];
    r.of_point[i] = label;
    r.on_wall[i] = s.label[i] != 0 && label == 0;
    if (label == 0) continue;
    RoofPlane& plane = r.planes[label - 1];
    ++plane.points;
    plane.lowest = std::min(plane.lowest, site.points[i].z);
    plane.highest = std::max(plane.highest, site.points[i].z);
  }
}

// Without superstructures, only planes stay that cover a good part of the area of the largest one.
void drop_superstructures(const RoofModelParams& params, double area_per_point, const Cloud& c, PlaneSegments& s) {
  std::vector<std::uint32_t> size(s.planes.size() + 1, 0);
  for (std::size_t i = 0; i < c.size; ++i) ++size[s.label[i]];
  std::uint32_t largest = 0;
  for (std::size_t p = 1; p < size.size(); ++p)
    if (s.planes[p - 1].n.z >= kSteepest) largest = std::max(largest, size[p]);
  for (std::uint32_t& label : s.label)
    if (label != 0 && size[label] * area_per_point < params.main_roof_area &&
        size[label] < params.main_roof_share * largest)
      label = 0;
}

}  // namespace

RoofPlanes find_roof_planes(const RoofSite& site, const RoofModelParams& params) {
  RoofPlanes r;
  r.of_point.assign(site.points.size(), 0);
  r.on_wall.assign(site.points.size(), 0);
  if (site.points.size() < 3) return r;
  Cloud c = cloud_of(site.points);
  const NeighbourIndex index = build_neighbour_index(c.points());
  std::vector<std::int64_t> reach2;
  const std::vector<std::uint32_t> lists = neighbours_of_all(index, reach2);
  const NeighbourLists neighbours{lists, kNeighbours};
  const auto use = [&](const Sampling& sampling) {
    r.step = sampling.step * kUnit;
    r.epsilon = params.epsilon > 0
                    ? params.epsilon
                    : std::clamp(kNoiseFactor * sampling.noise * kUnit, params.least_epsilon, params.most_epsilon);
  };
  const Sampling all = measure_sampling(c.points(), lists, reach2);
  use(all);
  give_normals(index, neighbours, reach2, all.step, r.epsilon / kUnit, c);
  use(sampling_of_roof(c, all));
  const double by_area = kLeastFaceArea / std::max(r.step * r.step, 1e-6);
  const auto min_points = static_cast<std::uint32_t>(
      params.min_points > 0 ? params.min_points : std::max<double>(kFewestPoints, std::min(by_area, 1e6)));
  const double epsilon = r.epsilon / kUnit;
  const auto gap = static_cast<std::int64_t>(std::ceil(std::max(kPlaneGapSteps * r.step, kLeastGap) / kUnit));
  PlaneSegments s =
      ransac_planes(c.oriented(), {epsilon, cos_degrees(params.normal_angle), gap, min_points, 0.99, content_key(c)});
  const RunNeighbours runs(c.size, neighbours);
  relabel_until_stable(c.points(), neighbours, runs, {epsilon, gap, 2, kFirstRounds}, min_points, s);
  join_alike(c, neighbours, epsilon, params.same_angle, s);
  relabel_until_stable(c.points(), neighbours, runs, {epsilon, gap, 2, kRelabelRounds}, min_points, s);
  if (!params.superstructures) drop_superstructures(params, r.step * r.step, c, s);
  sort_out(site, c, s, r);
  if (params.superstructures) add_level_tops(site, r);
  join_explained(c.points(), c.corner, params.detail, r);
  widen_heights(site.points, neighbours, runs, r);
  return r;
}

}  // namespace ilot
