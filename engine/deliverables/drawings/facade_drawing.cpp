// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/deliverables/drawings/drawing_sheet.h"
#include "engine/deliverables/drawings/facade_annotation.h"
#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/version.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/quantile.h"

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

std::string either(const std::string& known, const char* otherwise) {
  return known.empty() ? otherwise : known;
}

std::vector<std::pair<DrawingRole, std::string>> legend_of(const Drawing& drawing) {
  using R = DrawingRole;
  std::vector<std::pair<R, std::string>> legend;
  for (const auto& [role, words] :
       std::initializer_list<std::pair<R, const char*>>{{R::outline, "Outline"},
                                                        {R::opening, "Opening"},
                                                        {R::sill, "Sill"},
                                                        {R::lintel, "Lintel, surround"},
                                                        {R::balcony, "Balcony"},
                                                        {R::band, "Band, cornice"},
                                                        {R::stone, "Stone"},
                                                        {R::joint, "Joint"},
                                                        {R::bulge, "Irregularity"},
                                                        {R::detail, "Detail"},
                                                        {R::completed, "Completed"},
                                                        {R::occluded, "Not seen"},
                                                        {R::possible, "Possible opening, not seen"},
                                                        {R::error, "Error (layer frozen)"}}) {
    const auto is_drawn = [&, r = role](const auto& piece) { return piece.role == r; };
    if (std::any_of(drawing.lines.begin(), drawing.lines.end(), is_drawn) ||
        std::any_of(drawing.arcs.begin(), drawing.arcs.end(), is_drawn))
      legend.emplace_back(role, words);
  }
  constexpr std::size_t kMostLines = 11;  // greatest number of lines in the title block
  if (legend.size() > kMostLines) legend.resize(kMostLines);
  return legend;
}

}  // namespace

std::vector<std::string> facade_reference(const Facade& facade, const FacadeDrawingParams& params,
                                          const std::string& place) {
  const double error = edge_error_95(facade);
  // Degrees from grid north, clockwise.
  const double towards = direction_degrees(facade.right.y, facade.right.x);
  std::string crs = either(facade.crs, "not known");
  if (!params.crs_name.empty()) crs += " " + params.crs_name;
  return {
      "CRS: " + crs,
      "Heights: " + either(params.heights, "those of the points"),
      place,
      fmt::format("Facade runs towards {} deg from grid north", decimal(towards, 2)),
      "Metres, drawn 1:1 in model space",
      "Date of data: " + either(params.data_date, "not known"),
      "Accuracy: " + (error > 0 ? fmt::format("95 % of edges within {} mm", decimal(1000 * error, 1)) : "not known"),
      "Source: " + either(params.source, "not stated"),
      "Made with ilot " + version()};
}

double edge_error_95(const Facade& facade) {
  std::vector<double> errors;
  for (const FacadeElement& e : facade.elements)
    for (const FacadeEdge& edge : e.edges)
      if (edge.error_m > 0) errors.push_back(edge.error_m);
  return errors.empty() ? 0 : nth_smallest(errors, (errors.size() * 95 + 99) / 100 - 1);
}

Drawing facade_drawing(const Facade& facade, const FacadeDrawingParams& params) {
  Drawing drawing;
  drawing.scale = params.scale;
  drawing.title = either(params.title, "Elevation");
  const double m = params.metres_per_unit;
  std::vector<FlatElement> flat;
  for (const FacadeElement& e : facade.elements) flat.push_back(flat_element(facade, e, params.metres_per_unit));
  for (std::size_t i = 0; i < flat.size(); ++i) draw_element(facade.elements[i], flat[i], drawing);
  add_errors(flat, facade, drawing);
  drop_repeated_lines(drawing);
  const auto legend = legend_of(drawing);
  const FlatBox plan = box_of(flat);
  add_numbers(facade, flat, drawing);
  add_levels(facade, flat, plan, drawing);
  add_dimensions(facade, flat, plan, drawing);
  add_sheet({drawing.title,
             {fmt::format("Facade {}", facade.id), "Scale 1:" + decimal(params.scale, params.scale < 1 ? 2 : 0)},
             facade_reference(facade, params,
                              fmt::format("x = 0 at E {} N {}, y is the height", decimal(m * facade.origin.x, 3),
                                          decimal(m * facade.origin.y, 3))),
             legend},
            drawing);
  return drawing;
}

}  // namespace ilot
