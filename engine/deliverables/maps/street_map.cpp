// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/street_map.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/deliverables/drawings/pdf_file.h"
#include "engine/deliverables/maps/street_shapes.h"
#include "engine/model/street_areas.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr double kMargin = 5;        // metres around the drawn content
constexpr double kScaleBar = 20;     // metres
constexpr double kNumberText = 0.7;  // metres; 3.5 mm on paper at 1:200
// Choice: legible where the sheet is printed on one page, and no larger than a house on it.
constexpr double kLeastText = 0.8, kMostText = 4;  // metres; of the legend
constexpr double kLeastLegendWidth = 19;           // times the height of its text
// Choice: a line of DejaVu Sans, which is wider than most sans-serif faces; a wider one may be cut off.
constexpr double kLetterWidth = 0.62;    // mean width of a letter, times the height of the text
constexpr double kRowsOfText = 1.5;      // from row to row, times the height of the text
constexpr double kRowsBesideLegend = 4;  // for the arrow, the note and a margin

std::string hex(MapColour c) {
  return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
}

// The place of the shapes on the sheet, y down.
struct SheetPlace {
  FlatPoint corner;  // the upper left one
  double x(FlatPoint p) const { return p.x - corner.x; }
  double y(FlatPoint p) const { return corner.y - p.y; }
};

SheetPlace place_with_margin(const FlatBox& box) {
  return {{box.min.x - kMargin, box.max.y + kMargin}};
}

std::string geometry(const MapShape& shape, const SheetPlace& at) {
  if (shape.lines.empty())
    return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"", at.x(shape.centre), at.y(shape.centre),
                       shape.radius);
  if (shape.lines.size() == 1) {
    std::string points;
    for (const FlatPoint& p : shape.lines[0])
      points += fmt::format("{}{:.2f},{:.2f}", points.empty() ? "" : " ", at.x(p), at.y(p));
    return fmt::format("<{} points=\"{}\"", shape.closed ? "polygon" : "polyline", points);
  }
  std::string path;
  for (const std::vector<FlatPoint>& line : shape.lines) {
    for (std::size_t i = 0; i < line.size(); ++i)
      path += fmt::format("{}{:.2f},{:.2f}", i == 0 ? "M" : "L", at.x(line[i]), at.y(line[i]));
    path += "Z";
  }
  return fmt::format("<path d=\"{}\" fill-rule=\"evenodd\"", path);
}

std::string shape_svg(const MapShape& shape, const SheetPlace& at) {
  std::string svg = geometry(shape, at) + fmt::format(" fill=\"{}\"", shape.fill ? hex(*shape.fill) : "none");
  if (shape.clear) svg += fmt::format(" fill-opacity=\"{}\"", kClearOpacity);
  if (shape.stroke) svg += fmt::format(" stroke=\"{}\" stroke-width=\"{:.3g}\"", hex(*shape.stroke), shape.width);
  if (shape.dash > 0) svg += fmt::format(" stroke-dasharray=\"{0} {0}\"", shape.dash);
  return svg + (shape.title.empty() ? "/>\n"
                                    : fmt::format("><title>{}</title>{}\n", shape.title,
                                                  shape.lines.empty()      ? "</circle>"
                                                  : shape.lines.size() > 1 ? "</path>"
                                                  : shape.closed           ? "</polygon>"
                                                                           : "</polyline>"));
}

std::string shapes_svg(const std::vector<MapShape>& shapes, const SheetPlace& at) {
  std::string svg;
  for (const MapShape& shape : shapes) svg += shape_svg(shape, at);
  return svg;
}

std::string opened_svg(double width, double height) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2f} {1:.2f}\">\n"
      "<rect width=\"{0:.2f}\" height=\"{1:.2f}\" fill=\"#fbfaf7\"/>\n",
      width, height);
}

std::string scale_bar(double y, const std::string& length) {
  const std::string bar =
      fmt::format("<path d=\"M2 {:.2f}h{}\" stroke=\"#333\" stroke-width=\"0.4\"/>\n", y, kScaleBar);
  return length.empty() ? bar : bar + fmt::format("<text x=\"2\" y=\"{:.2f}\">{}</text>\n", y - 0.6, length);
}

// The width of the legend, times the height of its text.
double legend_width(const std::vector<LegendRow>& rows, std::span<const std::string> notes) {
  double width = kLeastLegendWidth;
  // As legend_svg has them: rows begin 3.5 letters' heights from the map, notes one, with letters of 0.8; one is left.
  for (const LegendRow& row : rows) width = std::max(width, 4.5 + kLetterWidth * static_cast<double>(row.name.size()));
  for (const std::string& note : notes)
    width = std::max(width, 2 + 0.8 * kLetterWidth * static_cast<double>(note.size()));
  return width;
}

// The legend with its left end at x: an arrow to the north, the kinds, what the numbers are, and the notes.
std::string legend_svg(const std::vector<LegendRow>& rows, std::span<const std::string> notes, double x, double text) {
  std::string svg = fmt::format(
      "<g transform=\"translate({:.2f} {:.2f}) scale({:.3f})\"><path d=\"M0 1.2V-1M-0.4 -0.3L0 -1L0.4 -0.3\" "
      "fill=\"none\" "
      "stroke=\"#222\" stroke-width=\"0.12\"/></g>\n<text x=\"{:.2f}\" y=\"{:.2f}\">North</text>\n",
      x + text, 2 * text, text, x + 2.5 * text, 2.35 * text);
  double y = (kRowsBesideLegend - 1) * kRowsOfText * text;
  for (const LegendRow& row : rows) {
    svg += fmt::format("<g transform=\"translate({:.2f} {:.2f}) scale({:.3f})\">{}</g>\n", x + text, y, text,
                       shapes_svg(row.sample, {}));
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", x + 2.5 * text, y + 0.35 * text, row.name);
    y += kRowsOfText * text;
  }
  const auto small = [&](const std::string& line) {
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\">{}</text>\n", x, y + 0.35 * text,
                       0.8 * text, line);
    y += kRowsOfText * text;
  };
  small("Numbers are object_id.");
  for (const std::string& note : notes) small(note);
  return svg;
}

}  // namespace

std::string street_map_svg(const StreetPlan& plan, double metres_per_unit) {
  const StreetShapes map = street_shapes(plan, metres_per_unit);
  const double height = map.box.height() + 2 * kMargin;
  return opened_svg(map.box.width() + 2 * kMargin, height) + shapes_svg(map.shapes, place_with_margin(map.box)) +
         scale_bar(height - 2, "") + "</svg>\n";
}

std::string street_sheet_svg(const StreetPlan& plan, double metres_per_unit, std::span<const std::string> notes) {
  const StreetShapes map = street_shapes(plan, metres_per_unit);
  const SheetPlace at = place_with_margin(map.box);
  const std::vector<LegendRow> rows = street_legend(plan);
  const double map_width = map.box.width() + 2 * kMargin, map_height = map.box.height() + 2 * kMargin;
  const double least = kRowsOfText * (static_cast<double>(rows.size() + notes.size()) + kRowsBesideLegend);
  const double text = std::clamp(map_height / least, kLeastText, kMostText);
  const double strip = legend_width(rows, notes) * text, height = std::max(map_height, text * least);
  std::string svg = opened_svg(map_width + strip, height) + shapes_svg(map.shapes, at);
  svg += fmt::format(
      "<g font-family=\"sans-serif\" font-size=\"{:.2f}\" text-anchor=\"middle\" fill=\"#111\" "
      "stroke=\"#fff\" stroke-width=\"0.15\" paint-order=\"stroke\">\n",
      kNumberText);
  for (const MapNumber& number : map.numbers)
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", at.x(number.place),
                       at.y(number.place) + 0.35 * kNumberText, number.id);
  svg += fmt::format("</g>\n<g font-family=\"sans-serif\" font-size=\"{:.2f}\" fill=\"#222\">\n", text);
  svg += legend_svg(rows, notes, map_width + text, text);
  svg += scale_bar(height - 2, fmt::format("{:.0f} m", kScaleBar));
  return svg + "</g>\n</svg>\n";
}

std::string street_legend_html(const StreetPlan& plan) {
  std::string html = "<table><thead><tr><th>class</th><th class=\"n\">objects</th></tr></thead><tbody>\n";
  for (const KindCount& kind : street_kinds(plan))
    html += fmt::format("<tr><td><i class=\"swatch\" style=\"background:{}\"></i>{}</td><td class=\"n\">{}</td></tr>\n",
                        hex(kind.colour), kind.name, kind.count);
  const std::string lines = plan.blocks.empty() ? ""
                                                : fmt::format("{} blocks (grey) and {} gaps between them (dashed). ",
                                                              plan.blocks.size(), plan.gaps.size());
  return html +
         fmt::format(
             "</tbody></table>\n<p class=\"note\">{}Circles are "
             "crowns; the dot is the trunk, hollow where no trunk was seen. Dashed kerbs were not seen. The bar is "
             "{:.0f} m long. North is up.</p>\n",
             lines, kScaleBar);
}

void write_street_map(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit,
                      std::span<const std::string> notes) {
  const std::vector<StreetPlan> areas = street_areas(plan, metres_per_unit);
  if (areas.size() == 1) {
    write_whole_file(folder / "streets.svg", street_sheet_svg(plan, metres_per_unit, notes));
    return;
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    std::vector<std::string> lines{fmt::format("Sheet {} of {}: the areas are far apart.", i + 1, areas.size())};
    lines.insert(lines.end(), notes.begin(), notes.end());
    write_whole_file(folder / fmt::format("streets_{}.svg", i + 1), street_sheet_svg(areas[i], metres_per_unit, lines));
  }
}

}  // namespace ilot
