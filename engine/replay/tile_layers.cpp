// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/replay/tile_replay.h"

namespace ilot {
namespace {

// The CRS coordinates of the tile's corners.
struct TileBox {
  double x0, y0, x1, y1;
  bool holds(Vec3 p) const { return p.x >= x0 && p.x < x1 && p.y >= y0 && p.y < y1; }
};

TileBox box_of(const TileReplay& replay) {
  const TileRaster& raster = *replay.steps.raster;
  const double side = static_cast<double>(raster.tile_units()) * raster.unit;
  const double x = static_cast<double>(replay.window.column) * side, y = static_cast<double>(replay.window.row) * side;
  return {x, y, x + side, y + side};
}

// Returns the object candidates: the parts and their joins. Selected candidates have the column "taken" set.
Layer thing_layer(const TileReplay& replay) {
  Layer layer{"candidates",
              LayerShape::point,
              false,
              {"candidate", "taken", "part_1", "part_2", "object", "label", "probability", "whole", "part", "merged"},
              {}};
  for (std::size_t f = 0; f < kCandidateFeatures; ++f) layer.fields.push_back(candidate_feature_name(f));
  const StreetSteps& steps = replay.steps;
  const TileRaster& raster = *steps.raster;
  const TileBox box = box_of(replay);
  for (std::size_t i = 0; i < steps.candidates.size(); ++i) {
    const ObjectCandidate& t = steps.candidates[i];
    const Vec3 base{raster.crs_x(t.x + 0.5), raster.crs_y(t.y + 0.5), t.ground * raster.unit};
    if (!box.holds(base)) continue;
    const CandidateClass& c = steps.classes[i];
    LayerFeature feature{
        {{base}},
        {static_cast<std::int64_t>(i + 1), steps.taken[i] != 0, std::int64_t{t.parts[0]}, std::int64_t{t.parts[1]},
         std::int64_t{steps.object_of[i + 1]}, class_name_of(c.label, {}), c.probability, c.whole, c.part, c.merged}};
    for (const double value : t.features) feature.values.emplace_back(value);
    layer.features.push_back(std::move(feature));
  }
  return layer;
}

Layer object_layer(const TileReplay& replay) {
  Layer layer{"objects",
              LayerShape::point,
              false,
              {"id", "label", "probability", "height_m", "length_m", "width_m", "heading_deg", "area_m2", "points"},
              {}};
  const TileBox box = box_of(replay);
  for (const StreetObject& o : replay.steps.objects)
    if (box.holds(o.base))
      layer.features.push_back({{{o.base}},
                                {std::int64_t{o.id}, class_name_of(o.label, {}), o.probability, o.height_m, o.length_m,
                                 o.width_m, o.heading_deg, o.area_m2, static_cast<std::int64_t>(o.points)}});
  return layer;
}

}  // namespace

std::vector<Layer> layers_of(const TileReplay& replay) {
  const TileBox b = box_of(replay);
  Layer tile{"tile", LayerShape::polygon, true, {"row", "column", "pixel_m"}, {}};
  tile.features.push_back({{{{b.x0, b.y0, 0}, {b.x1, b.y0, 0}, {b.x1, b.y1, 0}, {b.x0, b.y1, 0}}},
                           {replay.window.row, replay.window.column, replay.steps.raster->scale.pixel}});
  return {std::move(tile), thing_layer(replay), object_layer(replay)};
}

}  // namespace ilot
