// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "engine/products/roofs/sites/outline_repair.h"
#include "engine/replay/building_replay.h"
#include "engine/replay/building_shapes.h"

namespace ilot {
namespace {

constexpr double kDegrees = 57.29577951308232;

// Converts metres from the anchor to the CRS.
class Places {
 public:
  Places(Vec3 anchor, double metres_per_unit) : anchor_(anchor), per_metre_(1 / metres_per_unit) {}
  Vec3 of(Vec3 p) const { return anchor_ + per_metre_ * p; }
  std::vector<std::vector<Vec3>> of(const SitePolygon& polygon, double z) const {
    std::vector<std::vector<Vec3>> rings;
    for (const auto& ring : polygon) {
      auto& placed = rings.emplace_back();
      for (const Point2 p : ring) placed.push_back(of({p.x * 0.001, p.y * 0.001, z}));
    }
    return rings;
  }

 private:
  Vec3 anchor_;
  double per_metre_;
};

// The single values of the building: the reason for its status, its ground and the parameters of the search for planes.
Layer building_layer(const BuildingReplay& b, const Places& at) {
  const RoofSite& site = b.steps.gathered.site;
  const RoofPlanes& planes = b.steps.roof.planes;
  Layer layer{
      "building", LayerShape::polygon, true, {"id", "repair", "ground_m", "epsilon_m", "step_m", "refused"}, {}};
  std::string refused;
  for (const std::string& reason : b.steps.roof.refused) refused += (refused.empty() ? "" : "; ") + reason;
  LayerFeature feature{
      at.of(site.outline, 0),
      {b.planned.id, b.planned.repair, floor_of(b) + site.ground, planes.epsilon, planes.step, refused}};
  for (const auto& [name, value] : b.result.levels.at(0).attributes) {
    layer.fields.push_back(name);
    feature.values.push_back(value);
  }
  layer.features.push_back(std::move(feature));
  return layer;
}

Layer outline_layer(const BuildingReplay& b, const Places& at) {
  Layer layer{"outlines", LayerShape::polygon, true, {"id", "own", "area_m2"}, {}};
  const PlacedOutline& own = b.planned.outline;
  layer.features.push_back({at.of(own.polygon, 0), {b.planned.id, true, area_of(own.polygon)}});
  for (const PlannedSite& other : b.around)
    layer.features.push_back(
        {at.of(seen_from(other.outline, own.x, own.y), 0), {other.id, false, area_of(other.outline.polygon)}});
  return layer;
}

Layer point_layer(const BuildingReplay& b, const Places& at) {
  Layer layer{
      "points", LayerShape::point, false, {"role", "belonging", "used", "plane", "on_wall", "cell", "face"}, {}};
  const RoofSteps& roof = b.steps.roof;
  const auto value = [](const auto& values, std::size_t i) { return i < values.size() ? whole(values[i]) : 0; };
  for (const SeenPoint& p : seen_points(b)) {
    const bool used = p.number.has_value();
    const std::size_t i = p.number.value_or(0);
    layer.features.push_back({{{at.of(p.at)}},
                              {std::string(name_of(p.role)), std::string(name_of(p.membership)), used,
                               used ? value(roof.planes.of_point, i) : 0, used && value(roof.planes.on_wall, i) != 0,
                               used ? value(roof.cell_of_point, i) : 0, used ? value(b.steps.face_of_point, i) : 0}});
  }
  return layer;
}

Layer plane_layer(const BuildingReplay& b, const Places& at) {
  Layer layer{"planes",
              LayerShape::polygon,
              false,
              {"plane", "points", "slope_deg", "azimuth_deg", "lowest_m", "highest_m"},
              {}};
  const auto& planes = b.steps.roof.planes.planes;
  const std::vector<SitePolygon> hulls = plane_hulls(b.steps);
  const double floor = floor_of(b);
  for (std::size_t n = 0; n < planes.size(); ++n) {
    if (hulls[n].empty()) continue;
    const RoofPlane& p = planes[n];
    LayerFeature feature;
    for (const auto& ring : hulls[n]) {
      auto& lifted = feature.rings.emplace_back();
      for (const Point2 q : ring) lifted.push_back(at.of({q.x * 0.001, q.y * 0.001, p.at(q.x * 0.001, q.y * 0.001)}));
    }
    const double azimuth = std::fmod(kDegrees * std::atan2(-p.gx, -p.gy) + 360, 360);
    feature.values = {whole(n + 1), whole(p.points),  kDegrees * std::atan(std::hypot(p.gx, p.gy)),
                      azimuth,      floor + p.lowest, floor + p.highest};
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

Layer line_layer(const BuildingReplay& b, const Places& at) {
  Layer layer{"lines", LayerShape::line, true, {"line", "length_m"}, {}};
  for (const FlatEdge& e : b.steps.roof.lines)
    layer.features.push_back({{{at.of({e.a.x, e.a.y, 0}), at.of({e.b.x, e.b.y, 0})}},
                              {whole(layer.features.size() + 1), std::hypot(e.b.x - e.a.x, e.b.y - e.a.y)}});
  return layer;
}

// Returns the regions of a partition, each with its own number.
Layer region_layer(const char* name, const Partition& partition, const std::vector<std::string>& fields,
                   const std::function<std::vector<AttributeValue>(std::size_t)>& values, const Places& at) {
  Layer layer{name, LayerShape::polygon, true, fields, {}};
  const std::vector<SitePolygon> regions = region_polygons(partition);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (regions[r].empty()) continue;
    layer.features.push_back({at.of(regions[r], 0), values(r)});
  }
  return layer;
}

Layer solid_layer(const BuildingReplay& b) {
  constexpr const char* kKinds[] = {"roof", "wall", "ground"};
  Layer layer{"solid", LayerShape::polygon, false, {"lod", "kind", "face"}, {}};
  for (const Building& level : b.result.levels)
    for (const BuildingSurface& surface : level.surfaces) {
      LayerFeature feature;
      for (const auto& ring : surface.rings) {
        auto& placed = feature.rings.emplace_back();
        for (const std::uint32_t v : ring) placed.push_back(level.vertices[v]);
      }
      feature.values = {level.lod, std::string(kKinds[static_cast<int>(surface.kind)]), whole(surface.plane_id)};
      layer.features.push_back(std::move(feature));
    }
  return layer;
}

}  // namespace

std::vector<Layer> layers_of(const BuildingReplay& b) {
  const Places at(b.steps.gathered.site.anchor, b.file.metres_per_unit);
  const RoofSteps& roof = b.steps.roof;
  const std::vector<double> cell_areas = region_areas(roof.cells), face_areas = region_areas(roof.faces);
  const auto cell_values = [&](std::size_t r) -> std::vector<AttributeValue> {
    return {whole(r + 1), r < roof.label.size() ? whole(roof.label[r]) : 0, cell_areas[r + 1]};
  };
  const auto face_values = [&](std::size_t r) -> std::vector<AttributeValue> {
    const RoofPlane& p = roof.face_planes[r];
    return {whole(r + 1), face_areas[r + 1], kDegrees * std::atan(std::hypot(p.gx, p.gy))};
  };
  return {building_layer(b, at),
          outline_layer(b, at),
          point_layer(b, at),
          plane_layer(b, at),
          line_layer(b, at),
          region_layer("cells", roof.cells, {"cell", "plane", "area_m2"}, cell_values, at),
          region_layer("faces", roof.faces, {"face", "area_m2", "slope_deg"}, face_values, at),
          solid_layer(b)};
}

}  // namespace ilot
