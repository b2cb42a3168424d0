// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/deliverables/drawings/drawing_sheet.h"
#include "engine/deliverables/drawings/element_pieces.h"
#include "engine/deliverables/drawings/facade_annotation.h"
#include "engine/deliverables/drawings/facade_marks.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/drawings/sheet_texts.h"
#include "engine/model/stated_errors.h"
#include "engine/version.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

FlatBox box_of(const std::vector<FlatElement>& flat) {
  FlatBox box = FlatBox::none();
  for (const FlatElement& e : flat)
    if (!e.corners.empty()) box.add_box(e.box);
  return box.is_empty() ? FlatBox{} : box;
}

void add_errors(const std::vector<FlatElement>& flat, const Facade& facade, Drawing& drawing) {
  for (std::size_t i = 0; i < flat.size(); ++i) {
    if (facade.elements[i].status == DrawnStatus::occluded) continue;
    DrawingLine line{DrawingRole::error, {}, true};
    for (const FlatPoint& p : widened_ring(flat[i])) line.corners.push_back({p.x, p.y, 0});
    if (!line.corners.empty()) drawing.lines.push_back(std::move(line));
  }
}

// Elements with the same outline, for example a stone that fills a course, are drawn once on a layer.
void drop_repeated_lines(Drawing& drawing) {
  std::set<std::pair<DrawingRole, std::vector<std::int64_t>>> known;
  std::erase_if(drawing.lines, [&](const DrawingLine& line) {
    return !known.emplace(line.role, place_key(line.corners, line.closed)).second;
  });
}

std::string either(const std::string& known, const std::string& otherwise) {
  return known.empty() ? otherwise : known;
}

std::vector<std::pair<DrawingRole, std::string>> legend_of(const Drawing& drawing, SheetLanguage language) {
  std::vector<std::pair<DrawingRole, std::string>> legend;
  for (std::size_t i = 0; i < kDrawingRoles; ++i) {
    const auto role = static_cast<DrawingRole>(i);
    const char* words = legend_text(role, language);
    if (words == nullptr) continue;
    const auto is_drawn = [&](const auto& piece) { return piece.role == role; };
    if (std::any_of(drawing.lines.begin(), drawing.lines.end(), is_drawn) ||
        std::any_of(drawing.arcs.begin(), drawing.arcs.end(), is_drawn))
      legend.emplace_back(role, words);
  }
  constexpr std::size_t kMostLines = 11;  // greatest number of lines in the title block
  if (legend.size() > kMostLines) legend.resize(kMostLines);
  return legend;
}

// All elements of a row in the axes of the whole row.
Facade whole_row(std::span<const Facade> houses, double metres_per_unit) {
  Facade row = houses.front();
  const auto end_of = [&](const Facade& f) {
    return dot(f.origin + (f.width_m / metres_per_unit) * f.right - row.origin, row.right);
  };
  const Facade& last = *std::max_element(houses.begin(), houses.end(),
                                         [&](const Facade& a, const Facade& b) { return end_of(a) < end_of(b); });
  const Vec3 across = last.origin + (last.width_m / metres_per_unit) * last.right - row.origin;
  const Vec3 level{across.x, across.y, 0};
  if (norm(level) > 0) row.right = (1 / norm(level)) * level;
  row.up = {0, 0, 1};
  row.out = cross(row.right, row.up);
  row.elements.clear();
  for (const Facade& house : houses) {
    row.elements.insert(row.elements.end(), house.elements.begin(), house.elements.end());
    const Vec3 end = house.origin + (house.width_m / metres_per_unit) * house.right - row.origin;
    row.width_m = std::max(row.width_m, metres_per_unit * dot(end, row.right));
  }
  return row;
}

double scale_of_row(double width_m, double scale) {
  constexpr double kWidest = 1;  // metres on paper
  for (const double times : {1.0, 2.0, 4.0, 10.0})
    if (width_m <= kWidest * scale * times) return scale * times;
  return 20 * scale;
}

// How far a house stands before (positive) or behind the one on its left where they meet, in metres.
double step_between(const Facade& left, const Facade& house, double metres_per_unit) {
  const Vec3 end = left.origin + (left.width_m / metres_per_unit) * left.right;
  return metres_per_unit * dot(house.origin - end, house.out);
}

void add_house_texts(std::span<const Facade> houses, const Facade& row, double metres_per_unit, double below,
                     SheetLanguage language, Drawing& drawing) {
  constexpr double kTextMm = 2.5, kLineMm = 4, kBesideMm = 25;
  double last_x = -INFINITY;
  std::size_t lower = 0;  // lines below which the text begins, so that houses before each other have theirs in turn
  for (std::size_t i = 0; i < houses.size(); ++i) {
    const Facade& house = houses[i];
    const FlatPoint at = flat_place(row, house.origin, metres_per_unit);
    lower = at.x < last_x + drawing.paper_mm(kBesideMm) ? lower + 4 : 0;
    last_x = at.x;
    std::vector<std::string> lines{phrase(language, SheetPhrase::facade, house.id),
                                   number_text(house.width_m, 2, drawing.decimal_comma) + " m"};
    if (i > 0) {
      const double step = step_between(houses[i - 1], house, metres_per_unit);
      lines.push_back(phrase(language, step < 0 ? SheetPhrase::behind : SheetPhrase::before,
                             number_text(std::abs(step), 3, drawing.decimal_comma)));
    }
    for (std::size_t k = 0; k < lines.size(); ++k) {
      DrawingText text;
      text.role = DrawingRole::dimension;
      text.x = at.x, text.y = below - drawing.paper_mm(kLineMm * static_cast<double>(lower + k + 1));
      text.height = drawing.paper_mm(kTextMm);
      text.text = lines[k];
      add_fitting_text(std::move(text), house.width_m, drawing);
    }
  }
}

}  // namespace

std::vector<std::string> facade_reference(const Facade& facade, const FacadeDrawingParams& params,
                                          const std::string& place) {
  const double error = seen_error_95(facade);
  // Degrees from grid north, clockwise.
  const double towards = direction_degrees(facade.right.y, facade.right.x);
  const SheetLanguage in = params.language;
  const bool comma = has_decimal_comma(in);
  const std::string unknown = text_of(SheetPhrase::not_known, in);
  std::string crs = either(facade.crs, unknown);
  if (!params.crs_name.empty()) crs += " " + params.crs_name;
  const std::string accuracy =
      error > 0 ? phrase(in, SheetPhrase::edges_within, number_text(1000 * error, 1, comma)) : unknown;
  return {phrase(in, SheetPhrase::crs, crs),
          phrase(in, SheetPhrase::heights, either(params.heights, text_of(SheetPhrase::of_points, in))),
          place,
          phrase(in, SheetPhrase::runs_towards, number_text(towards, 2, comma)),
          text_of(SheetPhrase::metres, in),
          phrase(in, SheetPhrase::date, either(params.data_date, unknown)),
          phrase(in, SheetPhrase::accuracy, accuracy),
          phrase(in, SheetPhrase::source, either(params.source, text_of(SheetPhrase::not_stated, in))),
          phrase(in, SheetPhrase::made_with, version())};
}

std::string scale_text(const FacadeDrawingParams& params) {
  return phrase(params.language, SheetPhrase::scale, decimal(params.scale, params.scale < 1 ? 2 : 0));
}

namespace {

// The reference of a drawing in front view: x runs from the origin of the facade, y is the height.
std::vector<std::string> placed_reference(const Facade& facade, const FacadeDrawingParams& params, double metres) {
  const bool comma = has_decimal_comma(params.language);
  return facade_reference(facade, params,
                          phrase(params.language, SheetPhrase::origin, number_text(metres * facade.origin.x, 3, comma),
                                 number_text(metres * facade.origin.y, 3, comma)));
}

}  // namespace

Drawing facade_drawing(const Facade& facade, const FacadeDrawingParams& params) {
  Drawing drawing;
  drawing.scale = params.scale;
  drawing.title = either(params.title, text_of(SheetPhrase::elevation, params.language));
  drawing.decimal_comma = has_decimal_comma(params.language);
  const double m = params.metres_per_unit;
  std::vector<FlatElement> flat;
  for (const FacadeElement& e : facade.elements) flat.push_back(flat_element(facade, e, params.metres_per_unit));
  draw_elements(facade, flat, m, drawing);
  add_errors(flat, facade, drawing);
  drop_repeated_lines(drawing);
  add_ground(facade, flat, drawing);
  const auto legend = legend_of(flattened(drawing), params.language);
  const FlatBox plan = box_of(flat);
  add_numbers(facade, flat, drawing);
  add_levels(facade, flat, plan, drawing);
  add_dimensions(facade, flat, plan, drawing);
  add_section_marks(facade, named_sections(facade, params.sections, m, params.language), plan, m, drawing);
  add_sheet({drawing.title,
             {phrase(params.language, SheetPhrase::facade, facade.id), scale_text(params)},
             placed_reference(facade, params, m),
             legend,
             north_of(facade.right.x, facade.right.y)},
            drawing);
  return drawing;
}

Drawing row_drawing(std::span<const Facade> houses, const FacadeDrawingParams& params) {
  const double m = params.metres_per_unit;
  const Facade row = whole_row(houses, m);
  FacadeDrawingParams own = params;
  own.scale = scale_of_row(row.width_m, params.scale);
  Drawing drawing;
  drawing.scale = own.scale;
  drawing.title = either(params.title, text_of(SheetPhrase::row_of_facades, params.language));
  drawing.decimal_comma = has_decimal_comma(params.language);
  std::vector<FlatElement> flat;
  for (const FacadeElement& e : row.elements) flat.push_back(flat_element(row, e, m));
  draw_elements(row, flat, m, drawing);
  add_ground(row, flat, drawing);
  drop_repeated_lines(drawing);
  const auto legend = legend_of(flattened(drawing), params.language);
  const FlatBox plan = box_of(flat);
  add_levels(row, flat, plan, drawing);
  add_house_texts(houses, row, m, plan.min.y, params.language, drawing);
  add_sheet({drawing.title,
             {phrase(params.language, SheetPhrase::facades, houses.size()), scale_text(own)},
             placed_reference(row, own, m),
             legend,
             north_of(row.right.x, row.right.y)},
            drawing);
  return drawing;
}

}  // namespace ilot
