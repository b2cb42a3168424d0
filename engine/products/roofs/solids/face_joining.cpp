// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/face_joining.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/products/roofs/faces/plane_joining.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {
namespace {

// Derived: moments are exact in whole millimetres.
constexpr double kUnitsPerMetre = 1000;

Index3 in_millimetres(Vec3 p) {
  return {std::llround(p.x * kUnitsPerMetre), std::llround(p.y * kUnitsPerMetre), std::llround(p.z * kUnitsPerMetre)};
}

// Returns the number of the plane (1 + index) on which the points of a face lie; 0 for a face without points.
std::uint32_t plane_of(const RoofModel& model, std::uint32_t face, const RoofPlanes& planes) {
  for (std::size_t i = 0; i < planes.of_point.size(); ++i)
    if (model.face_of_point[i] == face && planes.of_point[i] != 0) return planes.of_point[i];
  return 0;
}

bool lies_on(const RoofPlane& plane, Vec3 p, double epsilon) {
  const double lean = std::sqrt(1 + plane.gx * plane.gx + plane.gy * plane.gy);
  return std::abs(p.z - plane.at(p.x, p.y)) <= epsilon * lean;
}

// The points that a merge gives to one plane: those on the planes of both faces, and those given to them before.
std::vector<std::uint32_t> points_of_both(const PlanesWithMerges& joined, std::uint32_t a, std::uint32_t b) {
  std::vector<std::uint32_t> both;
  const auto of_both = [&](std::uint32_t plane) { return plane == a || plane == b; };
  for (std::uint32_t i = 0; i < joined.given.size(); ++i)
    if (of_both(joined.planes.of_point[i]) || of_both(joined.given[i])) both.push_back(i);
  return both;
}

// The plane through all these points or that of the first face, whichever has more of them within epsilon.
RoofPlane plane_of_both(std::span<const Vec3> points, std::span<const std::uint32_t> both, const RoofPlane& first,
                        double epsilon) {
  Moments moments;
  for (const std::uint32_t i : both) moments.add_point(in_millimetres(points[i]));
  const PlaneFit fit = fit_plane(moments);
  if (!fit.unique || !(fit.plane.n.z > 0)) return first;
  const RoofPlane joint = roof_plane(fit.plane, {});
  const auto on = [&](const RoofPlane& plane) {
    return std::ranges::count_if(both, [&](std::uint32_t i) { return lies_on(plane, points[i], epsilon); });
  };
  return on(joint) > on(first) ? joint : first;
}

// Makes one plane of planes a and b. Of the points of both, those within epsilon lie on it and show its heights.
void join_planes(std::uint32_t a, std::uint32_t b, std::span<const Vec3> points, PlanesWithMerges& joined) {
  RoofPlanes& planes = joined.planes;
  const std::vector<std::uint32_t> both = points_of_both(joined, a, b);
  RoofPlane plane = plane_of_both(points, both, planes.planes[a - 1], planes.epsilon);
  plane.points = 0;
  plane.lowest = INFINITY, plane.highest = -INFINITY;
  for (const std::uint32_t i : both) {
    const bool on = lies_on(plane, points[i], planes.epsilon);
    planes.of_point[i] = on ? a : 0;
    joined.given[i] = on ? 0 : a;
    if (!on) continue;
    ++plane.points;
    plane.lowest = std::min(plane.lowest, points[i].z);
    plane.highest = std::max(plane.highest, points[i].z);
  }
  planes.planes[a - 1] = plane;
  planes.planes.erase(planes.planes.begin() + (b - 1));
  for (auto* numbers : {&planes.of_point, &joined.given})
    for (std::uint32_t& number : *numbers) number -= number > b ? 1 : 0;
}

}  // namespace

std::uint32_t face_above(const RoofFaceMap& map, FlatPoint place) {
  return regions_of(map.faces, std::vector<FlatPoint>{{place.x * kUnitsPerMetre, place.y * kUnitsPerMetre}})[0];
}

EditResult join_planes_of_faces(const RoofModel& model, const FaceMerge& merge, std::span<const Vec3> points,
                                PlanesWithMerges& joined) {
  const auto refused = [](const char* reason) { return EditResult{EditOutcome::without_partner, reason}; };
  if (model.status != RoofStatus::lod22) return refused(kNoFacesToMerge);
  const std::uint32_t first = face_above(model.map, merge.first), second = face_above(model.map, merge.second);
  if (first == kOutside || second == kOutside) return refused("a place of this edit is on no face of the roof");
  if (first == second) return {EditOutcome::repeated, {}};
  const RoofPlanes& planes = joined.planes;
  const std::uint32_t a = plane_of(model, first, planes), b = plane_of(model, second, planes);
  if (a == 0 || b == 0) return refused("a face of this edit has no points of its own");
  if (a == b) return refused("the faces of this edit are on one plane already and do not touch");
  joined.given.resize(points.size(), 0);
  join_planes(a, b, points, joined);
  return {};
}

RoofPlanes with_given_points(const PlanesWithMerges& joined, std::span<const Vec3> points) {
  RoofPlanes planes = joined.planes;
  for (std::size_t i = 0; i < joined.given.size(); ++i) {
    if (joined.given[i] == 0) continue;
    planes.of_point[i] = joined.given[i];
    RoofPlane& plane = planes.planes[joined.given[i] - 1];
    const double z = plane.at(points[i].x, points[i].y);
    plane.lowest = std::min(plane.lowest, z);
    plane.highest = std::max(plane.highest, z);
  }
  return planes;
}

}  // namespace ilot
