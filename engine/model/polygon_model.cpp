// SPDX-License-Identifier: Apache-2.0
#include "engine/model/polygon_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "kernels/outlines/ear_clipping.h"

namespace ilot {
namespace {

constexpr double kLeaning = 0.1;  // smallest |z| of the unit normal of a roof
constexpr double kFloor = 0.1;    // metres above the lowest vertex up to which a face is a floor

// Returns for each vertex the first one at the same place.
std::vector<std::uint32_t> merged_vertices(const PolygonModel& model) {
  std::map<std::tuple<double, double, double>, std::uint32_t> first;
  std::vector<std::uint32_t> merged(model.vertices.size());
  for (std::uint32_t i = 0; i < merged.size(); ++i) {
    const Vec3 v = model.vertices[i];
    merged[i] = first.try_emplace({v.x, v.y, v.z}, i).first->second;
  }
  return merged;
}

}  // namespace

Vec3 face_normal(const PolygonModel& model, const PolygonFace& face) {
  Vec3 sum;
  if (face.rings.empty()) return sum;
  const std::vector<std::uint32_t>& ring = face.rings[0];
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec3 anchor = model.vertices[ring[0]];
    sum = sum + cross(model.vertices[ring[i]] - anchor, model.vertices[ring[i + 1]] - anchor);
  }
  return sum;
}

std::vector<bool> roof_faces(const PolygonModel& model, double metres_per_unit) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& v : model.vertices) {
    low = std::min(low, v.z);
    high = std::max(high, v.z);
  }
  const double floor =
      high - low > kFloor / metres_per_unit ? low + kFloor / metres_per_unit : -std::numeric_limits<double>::infinity();
  std::vector<bool> roofs;
  for (const PolygonFace& face : model.faces) {
    const Vec3 n = face_normal(model, face);
    const bool leans = std::abs(n.z) > kLeaning * norm(n);
    const bool raised = std::any_of(face.rings[0].begin(), face.rings[0].end(),
                                    [&](std::uint32_t i) { return model.vertices[i].z > floor; });
    roofs.push_back(face.kind == FaceKind::unknown ? leans && raised : face.kind == FaceKind::roof);
  }
  return roofs;
}

void append_triangles(const PolygonModel& model, const PolygonFace& face, std::vector<Triangle3>& out) {
  const Vec3 n = face_normal(model, face);
  const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
  std::vector<FlatPoint> flat;
  std::vector<std::uint32_t> corners;
  std::vector<std::vector<std::uint32_t>> rings;
  for (const std::vector<std::uint32_t>& ring : face.rings) {
    rings.emplace_back();
    for (const std::uint32_t i : ring) {
      const Vec3 v = model.vertices[i] - model.vertices[face.rings[0][0]];
      rings.back().push_back(static_cast<std::uint32_t>(flat.size()));
      corners.push_back(i);
      flat.push_back(z >= x && z >= y ? FlatPoint{v.x, v.y} : x >= y ? FlatPoint{v.y, v.z} : FlatPoint{v.z, v.x});
    }
  }
  for (const auto& [a, b, c] : triangulate(flat, rings))
    out.push_back({model.vertices[corners[a]], model.vertices[corners[b]], model.vertices[corners[c]]});
}

bool is_closed(const PolygonModel& model) {
  const std::vector<std::uint32_t> merged = merged_vertices(model);
  std::map<std::array<std::uint32_t, 3>, int> balance;  // shell, lower vertex, higher vertex
  for (const PolygonFace& face : model.faces) {
    for (const std::vector<std::uint32_t>& ring : face.rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::uint32_t a = merged[ring[i]], b = merged[ring[i + 1 == ring.size() ? 0 : i + 1]];
        if (a != b) balance[{face.shell, std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
      }
    }
  }
  return !balance.empty() && std::all_of(balance.begin(), balance.end(), [](const auto& e) { return e.second == 0; });
}

}  // namespace ilot
