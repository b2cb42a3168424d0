// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/replay/facade_shapes.h"

namespace ilot {
namespace {

constexpr PictureColour kOrange{230, 130, 30}, kViolet{130, 60, 170}, kWall{225, 220, 205};

Picture begin(const FacadeReplay& r, const char* name, const std::string& title) {
  return {name, "facade " + std::to_string(r.facade.id) + ": " + title, {}, {}, {}, {}, {}, true};
}

void add_ring(Picture& picture, std::span<const Place2> ring, PictureColour colour, bool dashed = false) {
  PictureLine line{{}, colour, dashed};
  for (const Place2 p : ring) line.points.push_back({p.u, p.v});
  if (line.points.empty()) return;
  line.points.push_back(line.points[0]);
  picture.lines.push_back(std::move(line));
}

// Grey on the wall; redder the farther in front of it, bluer the farther behind it.
PictureColour colour_by_depth(const WallPoint& p) {
  if (p.on_wall) return {190, 185, 175};
  constexpr double kFull = 0.5;  // metres
  const double share = std::min(1.0, std::abs(p.at.z) / kFull);
  const auto faded = static_cast<std::uint8_t>(190 - 150 * share);
  return p.at.z > 0 ? PictureColour{210, faded, faded} : PictureColour{faded, faded, 220};
}

Picture point_picture(const FacadeReplay& r) {
  Picture picture = begin(r, "1-points", "points by their depth, planes' rings and the wall's outline");
  for (const WallPoint& p : r.points) picture.points.push_back({{p.at.x, p.at.y}, colour_by_depth(p)});
  for (const OutlineRing& ring : r.site.rings) add_ring(picture, ring, kOrange);
  add_ring(picture, r.steps.outline.ring, kInk);
  picture.legend = {{{190, 185, 175}, "on the wall"},
                    {{210, 40, 40}, "before it, half a metre and more"},
                    {{40, 40, 220}, "behind it, half a metre and more"},
                    {kOrange, "outlines of the planes that make up the wall"},
                    {kInk, "the wall's outline"}};
  return picture;
}

PictureColour colour_of_cell(std::uint8_t what) {
  constexpr PictureColour kColours[] = {{255, 255, 255}, kWall,           {90, 130, 220},
                                        {230, 150, 130}, {150, 190, 150}, {215, 195, 140}};
  return kColours[what];
}

PictureRaster raster_of(const WallCells& cells) {
  PictureRaster raster{{0, static_cast<double>(cells.rows) * cells.cell},
                       cells.cell,
                       static_cast<std::uint32_t>(cells.columns),
                       static_cast<std::uint32_t>(cells.rows),
                       {},
                       {}};
  for (std::int64_t row = cells.rows; row-- > 0;)
    for (std::int64_t c = 0; c < cells.columns; ++c) raster.colours.push_back(colour_of_cell(cells.at(c, row)));
  raster.shown.assign(raster.colours.size(), 1);
  return raster;
}

Picture cell_picture(const FacadeReplay& r, const char* name, const std::string& title, const WallCells& cells) {
  Picture picture = begin(r, name, title);
  picture.rasters.push_back(raster_of(cells));
  add_ring(picture, r.steps.outline.ring, kInk);
  picture.legend = {{colour_of_cell(WallCells::kSolid), "wall"},
                    {colour_of_cell(WallCells::kThrough), "open: rays go through"},
                    {colour_of_cell(WallCells::kBlocked), "something before the wall"},
                    {colour_of_cell(WallCells::kRelief), "something flat on the wall"},
                    {colour_of_cell(WallCells::kShallow), "too little behind it to be an opening"},
                    {colour_of_cell(WallCells::kUnknown), "unknown: no ray came here"}};
  return picture;
}

Picture search_picture(const FacadeReplay& r) {
  Picture picture = begin(r, "4-searches", "what the four searches found");
  add_ring(picture, r.steps.outline.ring, kInk);
  const auto add = [&](const std::vector<FoundRectangle>& found, PictureColour colour, const char* text) {
    for (const FoundRectangle& rectangle : found) add_ring(picture, ring_of(rectangle), colour);
    picture.legend.push_back({colour, std::to_string(found.size()) + text});
  };
  add(r.steps.stones, kGrey, " stones");
  add(r.steps.large, kOrange, " large parts before or behind the wall");
  add(r.steps.relief, kGreen, " planes before the wall");
  add(r.steps.openings, kBlue, " openings");
  return picture;
}

PictureColour colour_of(ElementKind kind) {
  if (kind == ElementKind::window) return kBlue;
  if (kind == ElementKind::door) return kViolet;
  if (kind == ElementKind::stone) return kGrey;
  return kind == ElementKind::protrusion || kind == ElementKind::recess ? kOrange : kGreen;
}

Picture regular_picture(const FacadeReplay& r) {
  Picture picture = begin(r, "5-regular", "elements before and after regularisation");
  add_ring(picture, r.steps.outline.ring, kInk);
  for (const ElementCandidate& t : r.steps.drawn) add_ring(picture, ring_of(t.shape), colour_of(t.kind));
  for (const ElementCandidate& t : r.steps.found) add_ring(picture, ring_of(t.shape), kRed, true);
  picture.legend = {{kBlue, "windows"},
                    {kViolet, "doors"},
                    {kOrange, "protrusions and recesses"},
                    {kGreen, "sills, bands, balconies and others"},
                    {kGrey, "stones"},
                    {kRed, "dashed: before regularisation"}};
  return picture;
}

Picture element_picture(const FacadeReplay& r) {
  Picture picture = begin(r, "6-elements", "the elements as they are drawn");
  for (const FacadeElement& e : r.facade.elements) {
    PictureArea area;
    auto& ring = area.rings.emplace_back();
    for (const Vec3& p : ring_on_wall(r, e.ring)) ring.push_back({p.x, p.y});
    const bool wall = e.region == FacadeRegion::facade;
    area.colour = wall ? kWall : light(e.opening ? kBlue : e.region == FacadeRegion::element ? kGreen : kOrange);
    area.edge = kInk;
    for (std::size_t i = 0; i < std::min(ring.size(), e.edges.size()); ++i)
      if (e.edges[i].status != DrawnStatus::seen)
        picture.lines.push_back({{ring[i], ring[(i + 1) % ring.size()]}, kRed, false});
    picture.areas.push_back(std::move(area));
  }
  picture.legend = {{light(kBlue), "openings"},
                    {light(kGreen), "other elements"},
                    {light(kOrange), "irregularities"},
                    {kRed, "edges that were not seen: completed or occluded"}};
  return picture;
}

}  // namespace

std::vector<Picture> pictures_of(const FacadeReplay& r) {
  return {point_picture(r),
          cell_picture(r, "2-cells", "what the rays show of each cell", r.steps.cells.seen),
          cell_picture(r, "3-filled", "cells joined over what nothing was seen in", r.steps.cells.filled),
          search_picture(r),
          regular_picture(r),
          element_picture(r)};
}

}  // namespace ilot
