// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/building_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace ilot {
namespace {

// The light comes from the north-west, at an elevation of 45 degrees.
constexpr Vec3 kLight{-0.5, 0.5, 0.7071067811865476};
// The view is from the south-west: to the right, away, and 30 degrees up.
constexpr double kDiagonal = 0.7071067811865476, kSineUp = 0.5, kCosineUp = 0.8660254037844386;

Vec3 normal_of(const Building& b, const BuildingSurface& s) {
  Vec3 n;
  const auto& ring = s.rings[0];
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 p = b.vertices[ring[i]] - b.vertices[ring[0]];
    const Vec3 q = b.vertices[ring[(i + 1) % ring.size()]] - b.vertices[ring[0]];
    n = n + cross(p, q);
  }
  const double length = norm(n);
  return length > 0 ? (1 / length) * n : n;
}

// Roofs have warm colours, walls are grey; faces away from the light are dark.
std::string colour_of(SurfaceKind kind, Vec3 normal) {
  const double light = std::clamp(0.55 + 0.45 * dot(normal, kLight), 0.0, 1.0);
  return kind == SurfaceKind::roof ? fmt::format("hsl(22,38%,{:.0f}%)", 30 + 48 * light)
                                   : fmt::format("hsl(215,12%,{:.0f}%)", 45 + 40 * light);
}

struct Flat {
  double x = 0, y = 0;  // to the right, downwards
};

void add_rings(std::string& path, const BuildingSurface& s, const std::vector<Flat>& at) {
  for (const auto& ring : s.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      path += fmt::format("{}{:.2f} {:.2f}", i == 0 ? "M" : "L", at[ring[i]].x, at[ring[i]].y);
    path += "Z";
  }
}

struct View {
  Vec3 from;
  double scale = 1, left = 0, top = 0;

  static Flat turned(Vec3 p) {
    const double right = kDiagonal * (p.x - p.y), away = kDiagonal * (p.x + p.y);
    return {right, -(kCosineUp * p.z + kSineUp * away)};
  }
  Flat at(Vec3 p) const {
    const Flat f = turned(p - from);
    return {(f.x - left) * scale, (f.y - top) * scale};
  }
  // The distance from the eye, for the order in which faces are painted.
  static double depth(Vec3 p) { return kCosineUp * kDiagonal * (p.x + p.y) - kSineUp * p.z; }
};

View view_of(const Building& b, int width, int height) {
  View view;
  view.from = b.vertices[0];
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double x0 = kFar, y0 = kFar, x1 = -kFar, y1 = -kFar;
  for (const Vec3& v : b.vertices) {
    const Flat f = View::turned(v - view.from);
    x0 = std::min(x0, f.x);
    x1 = std::max(x1, f.x);
    y0 = std::min(y0, f.y);
    y1 = std::max(y1, f.y);
  }
  constexpr double kMargin = 0.9;
  view.scale = kMargin * std::min(width / std::max(x1 - x0, 1e-9), height / std::max(y1 - y0, 1e-9));
  view.left = (x0 + x1) / 2 - width / (2 * view.scale);
  view.top = (y0 + y1) / 2 - height / (2 * view.scale);
  return view;
}

}  // namespace

std::string plan_paths(const Building& building, Vec3 origin) {
  std::vector<Flat> at;
  for (const Vec3& v : building.vertices) at.push_back({v.x - origin.x, origin.y - v.y});
  const bool solid = std::any_of(building.surfaces.begin(), building.surfaces.end(),
                                 [](const BuildingSurface& s) { return s.kind == SurfaceKind::roof; });
  std::string paths;
  for (const BuildingSurface& s : building.surfaces) {
    if (solid && s.kind != SurfaceKind::roof) continue;
    const std::string fill = solid ? colour_of(s.kind, normal_of(building, s)) : "none";
    paths += fmt::format("<path fill=\"{}\" d=\"", fill);
    add_rings(paths, s, at);
    paths += "\"/>";
  }
  return paths;
}

std::string oblique_drawing(const Building& building, std::span<const Vec3> points, int width, int height) {
  std::string svg = fmt::format("<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\">", width, height);
  if (building.vertices.empty()) return svg + "</svg>";
  const View view = view_of(building, width, height);
  std::vector<Flat> at;
  for (const Vec3& v : building.vertices) at.push_back(view.at(v));
  struct Face {
    double depth;
    std::size_t surface;
  };
  std::vector<Face> faces;
  const Vec3 towards_us{-kCosineUp * kDiagonal, -kCosineUp * kDiagonal, kSineUp};
  for (std::size_t i = 0; i < building.surfaces.size(); ++i) {
    const BuildingSurface& s = building.surfaces[i];
    if (dot(normal_of(building, s), towards_us) <= 0) continue;
    double depth = 0;
    for (const std::uint32_t v : s.rings[0]) depth += View::depth(building.vertices[v] - view.from);
    faces.push_back({depth / static_cast<double>(s.rings[0].size()), i});
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.depth > b.depth; });
  for (const Face& f : faces) {
    const BuildingSurface& s = building.surfaces[f.surface];
    svg += fmt::format("<path fill=\"{}\" d=\"", colour_of(s.kind, normal_of(building, s)));
    add_rings(svg, s, at);
    svg += "\"/>";
  }
  svg += "<g class=\"points\">";
  for (const Vec3& p : points) {
    const Flat f = view.at(p);
    svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1\"/>", f.x, f.y);
  }
  return svg + "</g></svg>";
}

}  // namespace ilot
