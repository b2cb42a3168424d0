// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/building_attributes.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/model/building_geometry.h"
#include "engine/products/roofs/sites/outline_repair.h"

namespace ilot {
namespace {

constexpr double kMillimetre = 0.001;
// Choice: 5 degrees; flat roofs fall by 2 to 3 degrees.
constexpr double kLevel = 0.996;  // cosine of 5 degrees: flatter faces are level

const char* name_of(GroundSource source) {
  switch (source) {
    case GroundSource::measured:
      return "measured";
    case GroundSource::nearby:
      return "nearby";
    default:
      return "lowest_point";
  }
}

double quantile(ValueCounts& values, double share) {
  return values.nth(static_cast<std::uint64_t>(share * static_cast<double>(values.count() - 1)));
}

void add_heights(const RoofSite& site, ValueCounts& z, double metres_per_unit, BuildingAttributes& out) {
  const auto height = [&](double v) { return site.anchor.z + v / metres_per_unit; };
  if (site.ground_source != GroundSource::none) {
    out.emplace_back("h_ground", height(site.ground));
    out.emplace_back("ground_source", std::string(name_of(site.ground_source)));
  }
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

void add_quality(const RoofModel& model, PointMeasures& measures, BuildingAttributes& out) {
  if (measures.measured()) {
    out.emplace_back("rmse_m", measures.rmse());
    out.emplace_back("p95_m", measures.quantile(0.95));
    out.emplace_back("explained", measures.explained());
    out.emplace_back("largest_off_m2", measures.largest_off());
    out.emplace_back("bare", measures.bare_share());
    out.emplace_back("overshoot_m", measures.overshoot());
  }
  const RoofVerdict verdict = measures.verdict(model.status);
  out.emplace_back("quality", std::string(verdict.quality));
  if (!verdict.reason.empty()) out.emplace_back("quality_reason", verdict.reason);
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
  out.emplace_back("coverage", coverage_of(site, area));
  add_quality(model, measures, out);
  return out;
}

BuildingAttributes volumes(std::span<const Building> levels, double metres_per_unit) {
  constexpr std::pair<const char*, const char*> kNames[] = {
      {"1.2", "volume_lod12_m3"}, {"1.3", "volume_lod13_m3"}, {"2.2", "volume_lod22_m3"}};
  BuildingAttributes out;
  for (const Building& level : levels)
    for (const auto& [lod, name] : kNames)
      if (level.lod == lod) out.emplace_back(name, volume_m3(level, metres_per_unit));
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
