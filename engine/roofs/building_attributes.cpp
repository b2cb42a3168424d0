// SPDX-License-Identifier: Apache-2.0
#include "engine/roofs/building_attributes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/roofs/outline_repair.h"

namespace ilot {
namespace {

constexpr double kMillimetre = 0.001;
constexpr double kLevel = 0.996;  // cosine of 5 degrees: flatter faces are level

Vec3 from_anchor(Vec3 p, const RoofSite& site, double metres_per_unit) {
  return metres_per_unit * (p - site.anchor);
}

// Newell's normal, twice the area long, and a plane through the ring's mean; metres from the anchor.
struct Face {
  Plane plane;
  double area = 0;
};

Face face_of(const Building& building, const BuildingSurface& surface, const RoofSite& site, double metres_per_unit) {
  Vec3 normal{0, 0, 0}, mean{0, 0, 0};
  const auto at = [&](std::uint32_t v) { return from_anchor(building.vertices[v], site, metres_per_unit); };
  for (const auto& ring : surface.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 a = at(ring[i]), b = at(ring[(i + 1) % ring.size()]);
      normal = normal + cross(a, b);
      if (&ring == &surface.rings.front()) mean = mean + a;
    }
  }
  const double length = norm(normal);
  if (surface.rings.empty() || !(length > 0)) return {};
  const Vec3 n = (1 / length) * normal;
  return {{n, -dot(n, (1.0 / static_cast<double>(surface.rings.front().size())) * mean)}, length / 2};
}

std::map<std::uint32_t, Face> roof_faces_of(const RoofModel& model, const RoofSite& site, double metres_per_unit) {
  std::map<std::uint32_t, Face> faces;
  for (const BuildingSurface& s : model.lod22.surfaces) {
    if (s.kind != SurfaceKind::roof) continue;
    const Face face = face_of(model.lod22, s, site, metres_per_unit);
    Face& known = faces[s.plane_id];
    if (face.area > known.area) known = face;
  }
  return faces;
}

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void add_heights(const RoofSite& site, const RoofModel& model, double metres_per_unit, BuildingAttributes& out) {
  const auto height = [&](double z) { return site.anchor.z + z / metres_per_unit; };
  out.emplace_back("h_ground", height(site.ground));
  out.emplace_back("ground_source",
                   std::string(site.ground_source == GroundSource::measured ? "measured" : "lowest_point"));
  std::vector<double> z;
  for (std::size_t i = 0; i < site.points.size(); ++i)
    if (i < model.face_of_point.size() && model.face_of_point[i] != 0) z.push_back(site.points[i].z);
  if (z.empty())
    for (const Vec3& p : site.points) z.push_back(p.z);
  if (z.empty()) return;
  std::sort(z.begin(), z.end());
  out.emplace_back("h_roof_min", height(z.front()));
  out.emplace_back("h_roof_50", height(quantile(z, 0.5)));
  out.emplace_back("h_roof_70", height(quantile(z, 0.7)));
  out.emplace_back("h_roof_max", height(z.back()));
}

// Root mean square distance of the points from their faces.
double rmse_of(const RoofSite& site, const RoofModel& model, const std::map<std::uint32_t, Face>& faces) {
  double sum = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < std::min(site.points.size(), model.face_of_point.size()); ++i) {
    const auto face = faces.find(model.face_of_point[i]);
    if (model.face_of_point[i] == 0 || face == faces.end()) continue;
    const double d = signed_distance(face->second.plane, site.points[i]);
    sum += d * d;
    ++n;
  }
  return n == 0 ? NAN : std::sqrt(sum / static_cast<double>(n));
}

// Share of the outline's cells that hold a point; cells two sampling steps wide.
double coverage_of(const RoofSite& site, double area) {
  if (site.points.empty() || !(area > 0)) return 0;
  const double cell = std::max(0.5, 2 * std::sqrt(area / static_cast<double>(site.points.size())));
  std::vector<std::pair<std::int64_t, std::int64_t>> cells;
  for (const Vec3& p : site.points)
    cells.emplace_back(static_cast<std::int64_t>(std::floor(p.x / cell)),
                       static_cast<std::int64_t>(std::floor(p.y / cell)));
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return std::min(1.0, static_cast<double>(cells.size()) * cell * cell / area);
}

std::string roof_type(const std::map<std::uint32_t, Face>& faces) {
  if (faces.empty()) return "unknown";
  std::size_t level = 0;
  for (const auto& [id, face] : faces) level += std::abs(face.plane.n.z) > kLevel;
  if (level < faces.size()) return "slanted";
  return faces.size() == 1 ? "horizontal" : "multiple horizontal";
}

struct WallEdge {
  double x, y, dx, dy, top;
};

std::vector<WallEdge> wall_edges(const RoofSite& site, const Building& building, double metres_per_unit) {
  std::vector<WallEdge> edges;
  for (const BuildingSurface& s : building.surfaces) {
    if (s.kind != SurfaceKind::wall || s.rings.empty()) continue;
    double top = -HUGE_VAL;
    for (const std::uint32_t v : s.rings[0])
      top = std::max(top, from_anchor(building.vertices[v], site, metres_per_unit).z);
    for (std::size_t i = 0; i < s.rings[0].size(); ++i) {
      const auto at = [&](std::size_t n) {
        return from_anchor(building.vertices[s.rings[0][n % s.rings[0].size()]], site, metres_per_unit);
      };
      const Vec3 a = at(i), b = at(i + 1);
      if (a.x != b.x || a.y != b.y) edges.push_back({a.x, a.y, b.x - a.x, b.y - a.y, top});
    }
  }
  return edges;
}

bool stands_at(const WallEdge& e, Vec3 p) {
  constexpr double kReach = 0.3;
  if (p.z > e.top + kReach) return false;
  const double px = p.x - e.x, py = p.y - e.y;
  const double along = std::clamp((px * e.dx + py * e.dy) / (e.dx * e.dx + e.dy * e.dy), 0.0, 1.0);
  const double x = px - along * e.dx, y = py - along * e.dy;
  return x * x + y * y <= kReach * kReach;
}

}  // namespace

const char* name_of(RoofStatus status) {
  switch (status) {
    case RoofStatus::lod22:
      return "lod22";
    case RoofStatus::lod12:
      return "lod12";
    default:
      return "footprint_only";
  }
}

BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit) {
  const auto faces = roof_faces_of(model, site, metres_per_unit);
  const double area = area_of(site.outline);
  BuildingAttributes out;
  out.emplace_back("status", std::string(name_of(model.status)));
  out.emplace_back("reason", model.reason);
  out.emplace_back("points", static_cast<std::int64_t>(site.points.size()));
  add_heights(site, model, metres_per_unit, out);
  out.emplace_back("area_m2", area);
  out.emplace_back("roof_faces", static_cast<std::int64_t>(faces.size()));
  out.emplace_back("roof_type", site.points.empty() ? std::string("no points") : roof_type(faces));
  if (const double rmse = rmse_of(site, model, faces); !std::isnan(rmse)) out.emplace_back("rmse_m", rmse);
  out.emplace_back("coverage", coverage_of(site, area));
  return out;
}

std::vector<PointLabel> point_labels(const RoofSite& site, const RoofModel& model, double metres_per_unit) {
  const Building& solid = model.lod22.surfaces.empty() ? model.lod12 : model.lod22;
  const std::vector<WallEdge> walls = wall_edges(site, solid, metres_per_unit);
  const bool level = model.lod22.surfaces.empty() && !model.lod12.surfaces.empty();
  std::vector<PointLabel> labels(site.points.size(), PointLabel::none);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (i < model.face_of_point.size() && model.face_of_point[i] != 0) {
      labels[i] = PointLabel::roof;
    } else if (std::any_of(walls.begin(), walls.end(), [&](const auto& w) { return stands_at(w, site.points[i]); })) {
      labels[i] = PointLabel::wall;
    } else if (level) {
      labels[i] = PointLabel::roof;
    }
  }
  return labels;
}

Building flat_outline(const RoofSite& site, double metres_per_unit) {
  Building flat;
  flat.id = site.id;
  flat.lod = "0";
  BuildingSurface surface{SurfaceKind::ground, 0, {}};
  for (const auto& ring : site.outline) {
    auto& numbers = surface.rings.emplace_back();
    for (const Point2 p : ring) {
      numbers.push_back(static_cast<std::uint32_t>(flat.vertices.size()));
      const Vec3 offset{p.x * kMillimetre, p.y * kMillimetre, site.ground};
      flat.vertices.push_back(site.anchor + (1 / metres_per_unit) * offset);
    }
  }
  if (!surface.rings.empty()) flat.surfaces.push_back(surface);
  return flat;
}

}  // namespace ilot
