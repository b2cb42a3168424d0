// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/building_attributes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/products/roofs/sites/outline_repair.h"

namespace ilot {
namespace {

constexpr double kMillimetre = 0.001;
// Choice: 5 degrees; flat roofs fall by 2 to 3 degrees.
constexpr double kLevel = 0.996;  // cosine of 5 degrees: flatter faces are level

Vec3 from_anchor(Vec3 p, const RoofSite& site, double metres_per_unit) {
  return metres_per_unit * (p - site.anchor);
}

// The plane of a face by Newell's normal, whose length is twice the area, through the mean of the ring; metres from the
// anchor.
MeasuredFace face_of(const Building& building, const BuildingSurface& surface, const RoofSite& site,
                     double metres_per_unit) {
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

std::map<std::uint32_t, MeasuredFace> roof_faces_of(const RoofModel& model, const RoofSite& site,
                                                    double metres_per_unit) {
  std::map<std::uint32_t, MeasuredFace> faces;
  for (const BuildingSurface& s : model.lod22.surfaces) {
    if (s.kind != SurfaceKind::roof) continue;
    const MeasuredFace face = face_of(model.lod22, s, site, metres_per_unit);
    MeasuredFace& known = faces[s.plane_id];
    if (face.area > known.area) known = face;
  }
  return faces;
}

double quantile(ValueCounts& values, double share) {
  return values.nth(static_cast<std::uint64_t>(share * static_cast<double>(values.count() - 1)));
}

void add_heights(const RoofSite& site, ValueCounts& z, double metres_per_unit, BuildingAttributes& out) {
  const auto height = [&](double v) { return site.anchor.z + v / metres_per_unit; };
  out.emplace_back("h_ground", height(site.ground));
  out.emplace_back("ground_source",
                   std::string(site.ground_source == GroundSource::measured ? "measured" : "lowest_point"));
  if (z.count() == 0) return;
  out.emplace_back("h_roof_min", height(quantile(z, 0)));
  out.emplace_back("h_roof_50", height(quantile(z, 0.5)));
  out.emplace_back("h_roof_70", height(quantile(z, 0.7)));
  out.emplace_back("h_roof_max", height(quantile(z, 1)));
}

// The share of the outline's cells that contain a point; cells are two sampling steps wide.
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

std::string roof_type(const std::map<std::uint32_t, MeasuredFace>& faces) {
  if (faces.empty()) return "unknown";
  std::size_t level = 0;
  for (const auto& [id, face] : faces) level += std::abs(face.plane.n.z) > kLevel;
  if (level < faces.size()) return "slanted";
  return faces.size() == 1 ? "horizontal" : "multiple horizontal";
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

PointMeasures::PointMeasures(const RoofSite& site, const RoofModel& model, double metres_per_unit)
    : faces_(roof_faces_of(model, site, metres_per_unit)) {}

void PointMeasures::add(Vec3 p, std::uint32_t face) {
  ++points_;
  if (face == 0) ++off_;
  (face != 0 ? on_faces_ : off_faces_).add(p.z);
  const auto at = face == 0 ? faces_.end() : faces_.find(face);
  if (at == faces_.end()) return;
  const double d = signed_distance(at->second.plane, p);
  squares_ += d * d;
  ++measured_;
}

double PointMeasures::rmse() const {
  return measured_ == 0 ? NAN : std::sqrt(squares_ / static_cast<double>(measured_));
}

double PointMeasures::share_off() const {
  return points_ == 0 ? 0 : static_cast<double>(off_) / static_cast<double>(points_);
}

BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit,
                                       PointMeasures& measures) {
  const auto& faces = measures.faces();
  const double area = area_of(site.outline);
  BuildingAttributes out;
  out.emplace_back("status", std::string(name_of(model.status)));
  out.emplace_back("reason", model.reason);
  out.emplace_back("points", static_cast<std::int64_t>(measures.points()));
  add_heights(site, measures.heights(), metres_per_unit, out);
  out.emplace_back("area_m2", area);
  out.emplace_back("roof_faces", static_cast<std::int64_t>(faces.size()));
  out.emplace_back("roof_type", site.points.empty() ? std::string("no points") : roof_type(faces));
  if (const double rmse = measures.rmse(); !std::isnan(rmse)) out.emplace_back("rmse_m", rmse);
  out.emplace_back("coverage", coverage_of(site, area));
  return out;
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
