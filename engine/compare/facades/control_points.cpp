// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/control_points.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ilot {
namespace {

// A corner of a drawn element.
struct DrawnVertex {
  const Facade* facade = nullptr;
  const FacadeElement* element = nullptr;
  Vec3 place;
  bool completed = false;
};

struct CornerPair {
  double distance = 0, dx = 0, dz = 0;
  std::size_t point = 0, vertex = 0;
};

bool is_occluded(const FacadeElement& e, std::size_t corner) {
  if (e.edges.empty()) return false;
  const std::size_t before = corner == 0 ? e.edges.size() - 1 : corner - 1;
  return e.edges[corner].status == DrawnStatus::occluded || e.edges[before].status == DrawnStatus::occluded;
}

bool is_completed(const FacadeElement& e, std::size_t corner) {
  if (e.status == DrawnStatus::completed) return true;
  if (e.edges.empty()) return false;
  const std::size_t before = corner == 0 ? e.edges.size() - 1 : corner - 1;
  return e.edges[corner].status != DrawnStatus::seen || e.edges[before].status != DrawnStatus::seen;
}

std::vector<DrawnVertex> vertices_of_kind(std::span<const Facade> facades, const std::string& kind, bool as_documents) {
  std::vector<DrawnVertex> vertices;
  for (const Facade& facade : facades) {
    for (const FacadeElement& e : facade.elements) {
      const bool asked = e.kind == kind || (kind == "window" && e.kind == "opening");
      if (!asked || e.status == DrawnStatus::occluded) continue;
      for (std::size_t i = 0; i < e.ring.size(); ++i)
        if (as_documents || !is_occluded(e, i)) vertices.push_back({&facade, &e, e.ring[i], is_completed(e, i)});
    }
  }
  return vertices;
}

std::vector<CornerPair> pairs_within_reach(const std::vector<Vec3>& points, const std::vector<DrawnVertex>& vertices,
                                           const ControlPointParams& params) {
  std::vector<CornerPair> pairs;
  for (std::size_t p = 0; p < points.size(); ++p) {
    for (std::size_t v = 0; v < vertices.size(); ++v) {
      const Vec3 gap = params.metres_per_unit * (vertices[v].place - points[p]);
      const double dx = std::abs(dot(gap, vertices[v].facade->right)), dz = std::abs(dot(gap, vertices[v].facade->up));
      const double distance = std::sqrt(dx * dx + dz * dz);
      if (distance <= params.limit_m && std::abs(dot(gap, vertices[v].facade->out)) <= params.depth_m)
        pairs.push_back({distance, dx, dz, p, v});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const CornerPair& a, const CornerPair& b) {
    return std::tie(a.distance, a.point, a.vertex) < std::tie(b.distance, b.point, b.vertex);
  });
  return pairs;
}

ControlGroup evaluate_group(const std::string& name, const std::vector<Vec3>& points, std::span<const Facade> facades,
                            const ControlPointParams& params) {
  const std::vector<DrawnVertex> vertices =
      vertices_of_kind(facades, name.substr(0, name.find('_')), params.as_documents);
  std::vector<char> point_taken(points.size()), vertex_taken(vertices.size());
  std::vector<double> dx, dz, dd, completed;
  for (const CornerPair& pair : pairs_within_reach(points, vertices, params)) {
    if (point_taken[pair.point] || vertex_taken[pair.vertex]) continue;
    point_taken[pair.point] = vertex_taken[pair.vertex] = 1;
    dx.push_back(pair.dx);
    dz.push_back(pair.dz);
    dd.push_back(pair.distance);
    if (vertices[pair.vertex].completed) completed.push_back(pair.distance);
  }
  ControlGroup group{name,
                     points.size(),
                     dd.size(),
                     points.size() - dd.size(),
                     mean_and_spread(dx),
                     mean_and_spread(dz),
                     mean_and_spread(dd),
                     completed.size(),
                     mean_and_spread(completed)};
  return group;
}

}  // namespace

MeanAndSpread mean_and_spread(std::span<const double> values) {
  if (values.empty()) return {};
  double sum = 0, squares = 0;
  for (const double v : values) sum += v;
  const double mean = sum / static_cast<double>(values.size());
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, values.size() < 2 ? 0 : std::sqrt(squares / static_cast<double>(values.size() - 1))};
}

std::vector<ControlGroup> evaluate_control_points(std::span<const TrueControlPoint> truth,
                                                  std::span<const Facade> facades, const ControlPointParams& params) {
  std::vector<std::pair<std::string, std::vector<Vec3>>> groups;
  for (const TrueControlPoint& point : truth) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == point.group; });
    if (group == groups.end()) group = groups.insert(groups.end(), {point.group, {}});
    group->second.push_back(point.position);
  }
  std::vector<ControlGroup> judged;
  for (const auto& [name, points] : groups) judged.push_back(evaluate_group(name, points, facades, params));
  return judged;
}

}  // namespace ilot
