// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/roof_setup.h"

#include <algorithm>
#include <cmath>

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

OutlineMap map_of(std::span<const PlannedSite> sites) {
  std::vector<GridBox> boxes;
  boxes.reserve(sites.size());
  for (const PlannedSite& site : sites) boxes.push_back(site.outline.polygon.empty() ? GridBox{} : site.outline.box);
  return OutlineMap(std::move(boxes));
}

}  // namespace

RoofSetup::RoofSetup(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
                     const PassContext& context)
    : map(map_of(sites)),
      work{store, sites, map, {}, context.metres_per_unit},
      model(model_params(settings.roofs)),
      file{crs.epsg, origin_near(context.corner, store.unit(), context.metres_per_unit), 0.0001,
           settings.roofs.attribute_style, context.metres_per_unit} {
  work.params.margin = settings.roofs.margin;
}

}  // namespace ilot
