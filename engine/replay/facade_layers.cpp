// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/replay/facade_shapes.h"

namespace ilot {
namespace {

std::vector<std::vector<Vec3>> placed(std::span<const Place2> ring, double depth = 0) {
  std::vector<std::vector<Vec3>> rings(1);
  for (const Place2 p : ring) rings[0].push_back({p.u, p.v, depth});
  return rings;
}

Layer wall_layer(const FacadeReplay& r) {
  Layer layer{"wall",
              LayerShape::polygon,
              true,
              {"facade", "width_m", "height_m", "epsilon_m", "noise_m", "step_m", "stations", "planes"},
              {}};
  layer.features.push_back({placed(r.steps.outline.ring),
                            {whole(r.facade.id), r.site.width, r.site.height, r.site.epsilon, r.site.noise, r.site.step,
                             whole(r.site.stations.size()), whole(r.site.wall.size())}});
  return layer;
}

Layer ring_layer(const FacadeReplay& r) {
  Layer layer{"rings", LayerShape::polygon, true, {"ring"}, {}};
  for (const OutlineRing& ring : r.site.rings)
    if (ring.size() > 2) layer.features.push_back({placed(ring), {whole(layer.features.size() + 1)}});
  return layer;
}

Layer point_layer(const FacadeReplay& r) {
  Layer layer{"points", LayerShape::point, false, {"plane", "on_wall", "met", "crossed_u", "crossed_v"}, {}};
  for (const WallPoint& p : r.points)
    layer.features.push_back(
        {{{p.at}}, {whole(p.plane), p.on_wall, std::string(name_of(p.met)), p.crossed.u, p.crossed.v}});
  return layer;
}

// Equal cells in a row become one rectangle.
Layer cell_layer(const FacadeReplay& r) {
  Layer layer{"cells", LayerShape::polygon, true, {"seen", "filled"}, {}};
  const WallCells &seen = r.steps.cells.seen, &filled = r.steps.cells.filled;
  for (std::int64_t row = 0; row < seen.rows; ++row)
    for (std::int64_t c = 0, end = 0; c < seen.columns; c = end) {
      const auto same = [&](std::int64_t k) {
        return seen.at(k, row) == seen.at(c, row) && filled.at(k, row) == filled.at(c, row);
      };
      for (end = c + 1; end < seen.columns && same(end);) ++end;
      const double u0 = static_cast<double>(c) * seen.cell, u1 = static_cast<double>(end) * seen.cell;
      const double v0 = static_cast<double>(row) * seen.cell, v1 = v0 + seen.cell;
      const std::vector<Place2> ring{{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
      layer.features.push_back(
          {placed(ring), {std::string(name_of_cell(seen.at(c, row))), std::string(name_of_cell(filled.at(c, row)))}});
    }
  return layer;
}

void add_rectangles(const std::vector<FoundRectangle>& found, const char* search, Layer& layer) {
  for (const FoundRectangle& r : found) {
    std::string unseen;
    constexpr const char* kNames[] = {"bottom", "right", "top", "left"};
    double error = 0;
    for (const Side side : kSides) {
      error = std::max(error, r.error(side));
      if (r.side(side).status != DrawnStatus::seen)
        unseen += (unseen.empty() ? "" : ", ") + std::string(kNames[static_cast<int>(side)]);
    }
    layer.features.push_back(
        {placed(ring_of(r), r.depth),
         {std::string(search), r.depth, r.fill, whole(r.points), error, unseen, r.arc.has_value()}});
  }
}

Layer search_layer(const FacadeReplay& r) {
  Layer layer{"searches",
              LayerShape::polygon,
              false,
              {"search", "depth_m", "fill", "points", "largest_error_m", "unseen_sides", "arched"},
              {}};
  add_rectangles(r.steps.openings, "opening", layer);
  add_rectangles(r.steps.relief, "relief", layer);
  add_rectangles(r.steps.stones, "stone", layer);
  add_rectangles(r.steps.large, "large", layer);
  return layer;
}

Layer thing_layer(const char* name, const std::vector<ElementCandidate>& things) {
  Layer layer{
      name, LayerShape::polygon, false, {"kind", "depth_m", "family", "row", "column", "moved_m", "reason"}, {}};
  for (const ElementCandidate& t : things) {
    double moved = 0;
    for (const LocatedEdge& edge : t.shape.sides) moved = std::max(moved, std::abs(edge.moved));
    layer.features.push_back({placed(ring_of(t.shape), t.shape.depth),
                              {std::string(name_of(t.kind)), t.shape.depth, whole(t.family), whole(t.row),
                               whole(t.column), moved, t.reason}});
  }
  return layer;
}

Layer irregularity_layer(const FacadeReplay& r) {
  Layer layer{"irregularities", LayerShape::polygon, true, {"rise_m", "density", "points"}, {}};
  for (const Irregularity& i : r.steps.irregular)
    layer.features.push_back({placed(i.ring), {i.rise, i.density, whole(i.points)}});
  return layer;
}

Layer element_layer(const FacadeReplay& r) {
  Layer layer{"elements",
              LayerShape::polygon,
              false,
              {"id", "kind", "status", "reason", "width_m", "height_m", "depth_m", "points"},
              {}};
  for (const FacadeElement& e : r.facade.elements)
    if (e.ring.size() > 2)
      layer.features.push_back({{ring_on_wall(r, e.ring)},
                                {whole(e.id), e.kind, std::string(name_of(e.status)), e.reason, e.width_m, e.height_m,
                                 e.depth_m, whole(e.points)}});
  return layer;
}

}  // namespace

std::vector<Layer> layers_of(const FacadeReplay& r) {
  return {wall_layer(r),         ring_layer(r),
          point_layer(r),        cell_layer(r),
          search_layer(r),       thing_layer("found", r.steps.found),
          irregularity_layer(r), thing_layer("drawn", r.steps.drawn),
          element_layer(r)};
}

}  // namespace ilot
