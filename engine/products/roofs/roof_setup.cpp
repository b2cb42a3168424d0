// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_setup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/settings/parameters.h"
#include "engine/version.h"

namespace ilot {
namespace {

// A corner of the CRS's own raster of 100 km near the least corner of the whole cloud. It is the same for each part of
// the cloud.
Vec3 origin_near(Index3 least, double unit, double metres_per_unit) {
  const double raster = 100000 / metres_per_unit;
  const auto corner = [&](std::int64_t v) { return std::round(static_cast<double>(v) * unit / raster) * raster; };
  return {corner(least.x), corner(least.y), 0};
}

RoofModelParams model_params(const RoofsSettings& s) {
  RoofModelParams params;
  params.epsilon = s.epsilon.value_or(0);
  params.min_points = s.min_points.value_or(0);
  params.least_face_area = s.least_face_area.value_or(0);
  params.detail = s.detail;
  params.lod13_step = s.lod13_step;
  params.superstructures = s.superstructures;
  params.normal_angle = s.advanced.normal_angle;
  params.same_angle = s.advanced.same_angle;
  params.least_epsilon = s.advanced.least_epsilon;
  params.most_epsilon = std::max(s.advanced.least_epsilon, s.advanced.most_epsilon);
  params.main_roof_area = s.advanced.main_roof_area;
  params.main_roof_share = s.advanced.main_roof_share;
  params.border_cost = s.advanced.border_cost;
  params.wall_cost = s.advanced.wall_cost;
  params.overshoot = s.advanced.overshoot;
  params.block_height = s.advanced.block_height;
  return params;
}

// The columns of the attributes of the footprints, in the order in which they appear.
Columns columns_of(std::span<const PlannedSite> sites) {
  constexpr FieldKind kKinds[] = {FieldKind::whole, FieldKind::real, FieldKind::text, FieldKind::truth};
  Columns columns;
  std::map<std::string, std::size_t> known;
  for (const PlannedSite& site : sites)
    for (const auto& [name, value] : site.attributes)
      if (known.try_emplace(name, columns.size()).second) columns.emplace_back(name, kKinds[value.index()]);
  return columns;
}

// The box of the outlines that the cloud meets, with the heights of the cloud; CRS units.
std::optional<std::array<double, 6>> extent_of(const IndexBox& points, double unit, std::span<const PlannedSite> sites,
                                               double metres_per_unit) {
  if (points.is_empty()) return std::nullopt;
  const double per_mm = 0.001 / metres_per_unit;
  const auto at = [&](std::int64_t v) { return static_cast<double>(v) * unit; };
  const double z0 = at(points.min.z), z1 = at(points.max.z);
  std::array<double, 6> all{INFINITY, INFINITY, INFINITY, -INFINITY, -INFINITY, -INFINITY};
  for (const PlannedSite& site : sites) {
    if (site.outline.polygon.empty()) continue;
    const GridBox& box = site.outline.box;
    const double x0 = static_cast<double>(box.min_x) * per_mm, x1 = static_cast<double>(box.max_x) * per_mm;
    const double y0 = static_cast<double>(box.min_y) * per_mm, y1 = static_cast<double>(box.max_y) * per_mm;
    if (x1 < at(points.min.x) || x0 > at(points.max.x) || y1 < at(points.min.y) || y0 > at(points.max.y)) continue;
    all = {std::min(all[0], x0), std::min(all[1], y0), z0, std::max(all[3], x1), std::max(all[4], y1), z1};
  }
  if (!(all[0] <= all[3])) return std::nullopt;
  return all;
}

// The settings of roofs as an object of JSON.
std::string roof_parameters(const Settings& settings) {
  nlohmann::json own = nlohmann::json::object();
  const nlohmann::json all = nlohmann::json::parse(settings_json(settings));
  for (const auto& [key, value] : all.items())
    if (key.starts_with("roofs.")) own[key] = value;
  return own.dump();
}

}  // namespace

OutlineMap map_of_outlines(std::span<const PlannedSite> sites) {
  std::vector<GridBox> boxes;
  boxes.reserve(sites.size());
  for (const PlannedSite& site : sites) boxes.push_back(site.outline.polygon.empty() ? GridBox{} : site.outline.box);
  return OutlineMap(std::move(boxes));
}

RoofFrame roof_frame(const IndexBox& points, double unit, std::span<const PlannedSite> sites,
                     const PassContext& context) {
  return {origin_near(context.corner, unit, context.metres_per_unit),
          extent_of(points, unit, sites, context.metres_per_unit), columns_of(sites)};
}

RoofFilesParams roof_files_params(const RoofFrame& frame, const Settings& settings, const Crs& crs) {
  CityJsonParams params{crs.epsg, frame.origin, 0.0001, settings.roofs.attribute_style, crs.metres_per_unit};
  params.title = "Buildings from a point cloud";
  params.software = "ilot " + version();
  params.parameters = roof_parameters(settings);
  params.extent = frame.extent;
  return {params, RoofFilesParams{}.largest_object, frame.further};
}

RoofSetup::RoofSetup(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
                     const PassContext& context, std::span<const Edit> edits)
    : map(map_of_outlines(sites)),
      class_edits(edits, store.unit()),
      merges(plan_merges(edits, sites, map, context.metres_per_unit)),
      work{store, sites, map, {}, context.metres_per_unit},
      model(model_params(settings.roofs)),
      file(roof_files_params(roof_frame(store.box(), store.unit(), sites, context), settings, crs)) {
  work.params.margin = settings.roofs.margin;
  work.class_edits = &class_edits;
  work.merges = merges;
}

}  // namespace ilot
