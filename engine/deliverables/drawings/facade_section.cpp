// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/drawings/drawing_sheet.h"
#include "engine/deliverables/drawings/facade_marks.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/drawings/sheet_texts.h"
#include "engine/deliverables/solids/facade_solids.h"
#include "engine/error.h"

namespace ilot {
namespace {

constexpr double kTouch = 1e-4;              // metres
constexpr std::size_t kUnsorted = 1u << 16;  // cells that are kept before they are sorted in

Vec3 on_wall(const Facade& facade, FlatPoint p, double metres) {
  return facade.origin + (p.x / metres) * facade.right + (p.y / metres - facade.origin.z) * facade.up;
}

std::vector<Vec3> wall_ring(const Facade& facade, const std::vector<FlatPoint>& ring, double metres) {
  std::vector<Vec3> places;
  for (const FlatPoint& p : ring) places.push_back(on_wall(facade, p, metres));
  return places;
}

// The even-odd rule applies: the outline and the openings in it are rings of one face.
SectionFace wall_face(const Facade& facade, double metres) {
  SectionFace wall;
  FlatBox box = FlatBox::none();
  for (const FacadeElement& e : facade.elements) {
    const FlatElement flat = flat_element(facade, e, metres);
    if (flat.corners.empty()) continue;
    if (e.kind == "outline") wall.rings.push_back(wall_ring(facade, chords_of(flat), metres));
    box.add_box(flat.box);
  }
  if (box.is_empty()) box = {};
  if (wall.rings.empty())
    wall.rings.push_back(wall_ring(facade, {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, metres));
  for (const FacadeElement& e : facade.elements)
    if (e.status != DrawnStatus::occluded && e.kind != "outline" && is_hole(facade, e, metres))
      wall.rings.push_back(wall_ring(facade, chords_of(flat_element(facade, e, metres)), metres));
  return wall;
}

// Returns the place of the drawing's origin and the direction of its y axis.
std::string place_of(const SectionPlane& plane, double metres, SheetLanguage language) {
  const bool upright = plane.v.z > 0.5, comma = has_decimal_comma(language);
  return phrase(language, upright ? SheetPhrase::origin : SheetPhrase::origin_above,
                number_text(metres * plane.origin.x, 3, comma), number_text(metres * plane.origin.y, 3, comma));
}

}  // namespace

SectionPlane level_section(const Facade& facade, double height) {
  const Vec3 along = (1 / std::sqrt(facade.right.x * facade.right.x + facade.right.y * facade.right.y)) *
                     Vec3{facade.right.x, facade.right.y, 0};
  return {{facade.origin.x, facade.origin.y, height}, along, {-along.y, along.x, 0}};
}

SectionPlane upright_section(Vec3 from, Vec3 to) {
  const Vec3 way{to.x - from.x, to.y - from.y, 0};
  const double length = norm(way);
  if (!(length > 1e-6)) throw Error("a section needs two different places in plan", ExitCode::usage);
  return {{from.x, from.y, 0}, (1 / length) * way, {0, 0, 1}};
}

std::vector<SectionFace> facade_faces(const Facade& facade, double metres_per_unit) {
  std::vector<SectionFace> faces{wall_face(facade, metres_per_unit)};
  for (const FacadeSolid& solid : facade_solids(facade, metres_per_unit)) {
    // The first face is oriented out of the wall, the second into it. The one at the wall is not a surface.
    const auto distance = [&](const std::vector<std::uint32_t>& face) {
      return std::abs(dot(solid.vertices[face[0]] - facade.origin, facade.out));
    };
    const std::size_t at_wall = distance(solid.faces[0]) < distance(solid.faces[1]) ? 0 : 1;
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
      if (i == at_wall) continue;
      SectionFace face{{{}}};
      for (const std::uint32_t corner : solid.faces[i]) face.rings[0].push_back(solid.vertices[corner]);
      faces.push_back(std::move(face));
    }
  }
  return faces;
}

SectionPoints::SectionPoints(const SectionPlane& plane, double half_m, double cell_m, double metres_per_unit)
    : plane_(plane), half_(half_m), cell_(cell_m), metres_(metres_per_unit) {}

void SectionPoints::add(std::span<const Vec3> points) {
  const Vec3 normal = cross(plane_.u, plane_.v);
  for (const Vec3& p : points) {
    const Vec3 away = p - plane_.origin;
    if (!(std::abs(metres_ * dot(away, normal)) <= half_)) continue;
    if (!(dot(away, plane_.u) >= plane_.from && dot(away, plane_.u) <= plane_.to)) continue;
    const double x = metres_ * dot(away, plane_.u) / cell_, y = metres_ * dot(away, plane_.v) / cell_;
    if (!(std::abs(x) < 1e9 && std::abs(y) < 1e9)) continue;
    cells_.emplace_back(static_cast<std::int64_t>(std::floor(y)), static_cast<std::int64_t>(std::floor(x)));
    if (cells_.size() - sorted_ > std::max(kUnsorted, sorted_)) sort_unique();
  }
}

void SectionPoints::sort_unique() {
  std::sort(cells_.begin(), cells_.end());
  cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
  sorted_ = cells_.size();
}

std::vector<FlatPoint> SectionPoints::places() const {
  SectionPoints whole = *this;
  whole.sort_unique();
  std::vector<FlatPoint> places;
  for (const auto& [row, column] : whole.cells_)
    places.push_back({(static_cast<double>(column) + 0.5) * cell_, (static_cast<double>(row) + 0.5) * cell_});
  return places;
}

Drawing section_drawing(const Facade& facade, const SectionPlane& plane, std::span<const SectionFace> faces,
                        std::span<const FlatPoint> points, const std::string& where,
                        const FacadeDrawingParams& params) {
  const double metres = params.metres_per_unit;
  Drawing drawing;
  drawing.scale = params.scale;
  drawing.title = params.title.empty() ? text_of(SheetPhrase::section, params.language) : params.title;
  drawing.decimal_comma = has_decimal_comma(params.language);
  std::vector<FlatEdge> cut = cut_faces(faces, plane);
  for (FlatEdge& e : cut) e = {{metres * e.a.x, metres * e.a.y}, {metres * e.b.x, metres * e.b.y}};
  for (std::vector<FlatPoint>& chain : join_stretches(cut, kTouch)) {
    DrawingLine line{DrawingRole::section, {}, false};
    for (const FlatPoint& p : chain) line.corners.push_back({p.x, p.y, 0});
    const DrawingCorner &first = line.corners.front(), &last = line.corners.back();
    line.closed = line.corners.size() > 3 && first.x == last.x && first.y == last.y;
    if (line.closed) line.corners.pop_back();
    drawing.lines.push_back(std::move(line));
  }
  for (const FlatPoint& p : points) drawing.points.push_back({DrawingRole::section_points, p.x, p.y});
  std::vector<std::pair<DrawingRole, std::string>> legend{
      {DrawingRole::section, text_of(SheetPhrase::cut, params.language)}};
  if (!points.empty())
    legend.emplace_back(DrawingRole::section_points, text_of(SheetPhrase::points_near, params.language));
  add_sheet({drawing.title,
             {phrase(params.language, SheetPhrase::facade, facade.id), where, scale_text(params)},
             facade_reference(facade, params, place_of(plane, metres, params.language)),
             legend,
             std::abs(plane.v.z) < 0.5 ? std::optional<double>(north_of(plane.u.x, plane.u.y)) : std::nullopt},
            drawing);
  return drawing;
}

}  // namespace ilot
