// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/step_parts.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// A part while parts are joined.
struct GrowingPart {
  std::vector<double> z;  // of its points
  double height = 0;
  std::set<std::uint32_t> beside;    // parts that share an edge with it
  std::vector<std::uint32_t> faces;  // empty: it is in another part
};

// The mean height of the corners of each face.
std::vector<double> corner_heights(const Partition& faces, std::span<const RoofPlane> planes) {
  std::vector<double> sum(planes.size() + 1), count(planes.size() + 1);
  for (const PartitionEdge& e : faces.edges)
    for (const std::uint32_t region : {e.left, e.right})
      for (const std::uint32_t v : {e.from, e.to}) {
        if (region == kOutside) continue;
        sum[region] += planes[region - 1].at(faces.vertices[v].x / 1000.0, faces.vertices[v].y / 1000.0);
        count[region] += 1;
      }
  for (std::size_t i = 1; i < sum.size(); ++i) sum[i] = count[i] > 0 ? sum[i] / count[i] : 0;
  return sum;
}

std::vector<GrowingPart> single_faces(const Partition& faces, std::span<const RoofPlane> planes,
                                      std::span<const Vec3> points, double quantile) {
  std::vector<GrowingPart> parts(faces.regions + 1);
  std::vector<FlatPoint> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.push_back({p.x * 1000, p.y * 1000});
  const std::vector<std::uint32_t> region = regions_of(faces, flat);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (region[i] != kOutside) parts[region[i]].z.push_back(points[i].z);
  const std::vector<double> corners = corner_heights(faces, planes);
  for (std::uint32_t i = 1; i < parts.size(); ++i) {
    parts[i].faces = {i};
    parts[i].height = parts[i].z.empty() ? corners[i] : lower_quantile(parts[i].z, quantile);
  }
  for (const PartitionEdge& e : faces.edges) {
    if (e.left == kOutside || e.right == kOutside || e.left == e.right) continue;
    parts[e.left].beside.insert(e.right);
    parts[e.right].beside.insert(e.left);
  }
  return parts;
}

// The two parts that share an edge and differ least in height, the first of equal ones; {0, 0} where all differ by a
// step.
std::pair<std::uint32_t, std::uint32_t> least_step(const std::vector<GrowingPart>& parts, double step) {
  std::tuple<double, std::uint32_t, std::uint32_t> least{step, 0, 0};
  for (std::uint32_t i = 1; i < parts.size(); ++i)
    for (const std::uint32_t k : parts[i].beside)
      if (k > i) least = std::min(least, std::tuple(std::abs(parts[i].height - parts[k].height), i, k));
  return std::get<0>(least) < step ? std::pair(std::get<1>(least), std::get<2>(least)) : std::pair(0u, 0u);
}

void join(std::vector<GrowingPart>& parts, std::uint32_t into, std::uint32_t from, double quantile) {
  GrowingPart &a = parts[into], b = std::move(parts[from]);
  parts[from] = {};
  if (a.z.empty() && !b.z.empty()) a.height = b.height;
  const bool both = !a.z.empty() && !b.z.empty();
  a.z.insert(a.z.end(), b.z.begin(), b.z.end());
  if (both) a.height = lower_quantile(a.z, quantile);
  a.faces.insert(a.faces.end(), b.faces.begin(), b.faces.end());
  for (const std::uint32_t other : b.beside) {
    parts[other].beside.erase(from);
    if (other == into) continue;
    parts[other].beside.insert(into);
    a.beside.insert(other);
  }
}

}  // namespace

StepParts step_parts(const Partition& faces, std::span<const RoofPlane> planes, const SitePolygon& outline,
                     std::span<const Vec3> points, const StepPartParams& params) {
  std::vector<GrowingPart> growing = single_faces(faces, planes, points, params.quantile);
  for (;;) {
    const auto [into, from] = least_step(growing, params.step);
    if (into == 0) break;
    join(growing, into, from, params.quantile);
  }
  StepParts result;
  std::vector<std::uint32_t> label(faces.regions);
  for (const GrowingPart& part : growing) {
    if (part.faces.empty()) continue;
    result.planes.push_back({0, 0, part.height, part.height, part.height, static_cast<std::uint32_t>(part.z.size())});
    for (const std::uint32_t face : part.faces) label[face - 1] = static_cast<std::uint32_t>(result.planes.size());
  }
  result.parts = merged(faces, label, static_cast<std::uint32_t>(result.planes.size()), corners_in(faces, outline));
  return result;
}

}  // namespace ilot
