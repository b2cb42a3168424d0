// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/planes/plane_errors.h"

#include <algorithm>
#include <map>
#include <numbers>

namespace ilot {
namespace {

ErrorSummary summarise(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double sum = 0;
  for (const double v : values) sum += v;
  return {sum / static_cast<double>(values.size()), values[(values.size() - 1) / 2], values.back()};
}

double angle_deg(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), std::abs(dot(a, b))) * 180 / std::numbers::pi;
}

}  // namespace

PlaneErrors plane_errors(std::span<const PlaneMatch> matches, std::span<const TruePlane> truth,
                         std::span<const Segment> found, double metres_per_unit) {
  std::map<std::uint32_t, const TruePlane*> true_planes;
  std::map<std::uint32_t, const Segment*> found_planes;
  for (const TruePlane& plane : truth) true_planes.emplace(plane.id, &plane);
  for (const Segment& segment : found) found_planes.emplace(segment.id, &segment);
  std::vector<double> angles, offsets;
  for (const PlaneMatch& match : matches) {
    const auto t = true_planes.find(match.truth);
    const auto f = found_planes.find(match.found);
    if (t == true_planes.end() || f == found_planes.end()) continue;
    angles.push_back(angle_deg(t->second->plane.n, f->second->plane.n));
    offsets.push_back(std::abs(signed_distance(t->second->plane, f->second->centroid)) * metres_per_unit);
  }
  const std::uint64_t planes = angles.size();
  return {planes, summarise(std::move(angles)), summarise(std::move(offsets))};
}

}  // namespace ilot
