// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/street_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/model/object_colours.h"
#include "engine/model/point_label.h"
#include "engine/model/street_areas.h"
#include "engine/model/street_geometry.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr double kMargin = 5;         // metres around the drawn content
constexpr double kLeastSymbol = 0.3;  // metres; smaller objects are drawn with this size
constexpr double kScaleBar = 20;      // metres
constexpr double kNumberText = 0.7;   // metres; 3.5 mm on paper at 1:200
// Choice: legible where the sheet is printed on one page, and no larger than a house on it.
constexpr double kLeastText = 0.8, kMostText = 4;  // metres; of the legend
constexpr double kLegendWidth = 19;                // times the height of its text
constexpr double kRowsOfText = 1.5;                // from row to row, times the height of the text
constexpr double kRowsBesideLegend = 4;            // for the arrow, the note and a margin
constexpr double kTreeDot = 0.3;                   // metres; radius of the dot at the trunk
constexpr const char *kTree = "#2f7d32", *kTrunk = "#5d4037", *kKerb = "#b22260", *kPavement = "#e6dfd0",
                     *kRoad = "#dfe1e5";

std::string colour_of(PointLabel label) {
  const auto [red, green, blue] = object_colour(label);
  return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue);
}

// Converts CRS coordinates to metres from the lower left corner of the drawn content, y down.
class Sheet {
 public:
  Sheet(const StreetPlan& plan, double metres_per_unit) : metres_(metres_per_unit) {
    for (const StreetObject& o : plan.objects) add(o.middle);
    for (const auto* parts : {&plan.blocks, &plan.gaps})
      for (const FacadePart& part : *parts) add(part.from), add(part.to);
    for (const StreetKerb& kerb : plan.kerbs)
      for (const Vec3& p : kerb.line) add(p);
    for (const Pavement& pavement : plan.pavements)
      for (const Vec3& p : pavement.ring) add(p);
    for (const Carriageway& road : plan.carriageways)
      for (const Vec3& p : road.ring) add(p);
    for (const StreetTree& tree : plan.trees)
      for (const Vec3& p : crown_of(tree, metres_per_unit)) add(p);
    if (min_.x > max_.x) min_ = max_ = {};
  }
  double x(Vec3 p) const { return (p.x - min_.x) * metres_ + kMargin; }
  double y(Vec3 p) const { return (max_.y - p.y) * metres_ + kMargin; }
  double width() const { return (max_.x - min_.x) * metres_ + 2 * kMargin; }
  double height() const { return (max_.y - min_.y) * metres_ + 2 * kMargin; }

 private:
  void add(Vec3 p) {
    min_.x = std::min(min_.x, p.x), min_.y = std::min(min_.y, p.y);
    max_.x = std::max(max_.x, p.x), max_.y = std::max(max_.y, p.y);
  }
  double metres_;
  Vec3 min_{INFINITY, INFINITY, 0}, max_{-INFINITY, -INFINITY, 0};
};

std::string line(const Sheet& sheet, const FacadePart& part, const char* look, const std::string& title) {
  return fmt::format("<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}><title>{}</title></line>\n",
                     sheet.x(part.from), sheet.y(part.from), sheet.x(part.to), sheet.y(part.to), look, title);
}

std::string symbol(const Sheet& sheet, const StreetObject& o, double metres_per_unit) {
  StreetObject drawn = o;
  drawn.length_m = std::max(o.length_m, kLeastSymbol);
  drawn.width_m = std::max(o.width_m, kLeastSymbol);
  std::string points;
  for (const Vec3& corner : extent_of(drawn, metres_per_unit))
    points += fmt::format("{:.2f},{:.2f} ", sheet.x(corner), sheet.y(corner));
  points.pop_back();
  return fmt::format("<polygon points=\"{}\" fill=\"{}\"><title>{} {}: {}, {:.2f} m high</title></polygon>\n", points,
                     colour_of(o.label), o.class_name, o.id,
                     o.by_hand ? "by hand" : fmt::format("{:.0f} %", 100 * o.probability), o.height_m);
}

std::string road_area(const Sheet& sheet, const Carriageway& road) {
  std::string path;
  const auto add = [&](const std::vector<Vec3>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      path += fmt::format("{}{:.2f},{:.2f}", i == 0 ? "M" : "L", sheet.x(ring[i]), sheet.y(ring[i]));
    path += "Z";
  };
  add(road.ring);
  for (const std::vector<Vec3>& hole : road.holes) add(hole);
  return fmt::format(
      "<path d=\"{}\" fill=\"{}\" fill-rule=\"evenodd\"><title>carriageway {}: {:.2f} m wide, {:.2f} m at its "
      "narrowest, {:.0f} m2</title></path>\n",
      path, kRoad, road.id, road.width_m, road.narrowest_m, road.area_m2);
}

std::string pavement_area(const Sheet& sheet, const Pavement& pavement) {
  std::string points;
  for (const Vec3& p : pavement.ring) points += fmt::format("{:.2f},{:.2f} ", sheet.x(p), sheet.y(p));
  points.pop_back();
  return fmt::format(
      "<polygon points=\"{}\" fill=\"{}\"><title>pavement {}: {:.2f} m wide, {:.2f} m free at its narrowest"
      "</title></polygon>\n",
      points, kPavement, pavement.id, pavement.width_m, pavement.passable_m);
}

std::string kerb_line(const Sheet& sheet, const StreetKerb& kerb) {
  std::string points;
  for (const Vec3& p : kerb.line) points += fmt::format("{:.2f},{:.2f} ", sheet.x(p), sheet.y(p));
  points.pop_back();
  return fmt::format(
      "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"0.2\"{}><title>kerb {}: {:.2f} m high{}"
      "</title></polyline>\n",
      points, kKerb, kerb.seen ? "" : " stroke-dasharray=\"0.6 0.6\"", kerb.id, kerb.height_m,
      kerb.seen ? "" : ", not seen");
}

std::string tree_symbol(const Sheet& sheet, const StreetTree& tree) {
  const double x = sheet.x(tree.position), y = sheet.y(tree.position);
  return fmt::format(
             "<circle cx=\"{0:.2f}\" cy=\"{1:.2f}\" r=\"{2:.2f}\" fill=\"{3}\" fill-opacity=\"0.25\" "
             "stroke=\"{3}\" stroke-width=\"0.1\"><title>tree {4}: {5:.1f} m high, crown {2:.1f} m in radius"
             "</title></circle>\n",
             x, y, tree.crown_radius_m, kTree, tree.id, tree.height_m) +
         fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", x, y, kTreeDot,
                     tree.trunk_seen ? fmt::format("fill=\"{}\"", kTrunk)
                                     : fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"0.1\"", kTrunk));
}

std::map<std::pair<PointLabel, std::string>, std::size_t> counts_of(const StreetPlan& plan) {
  std::map<std::pair<PointLabel, std::string>, std::size_t> counts;
  for (const StreetObject& o : plan.objects) ++counts[{o.label, o.class_name}];
  return counts;
}

// Everything that is drawn to scale.
std::string content_of(const Sheet& sheet, const StreetPlan& plan, double metres_per_unit) {
  std::string svg;
  for (const Carriageway& road : plan.carriageways) svg += road_area(sheet, road);
  for (const Pavement& pavement : plan.pavements) svg += pavement_area(sheet, pavement);
  for (const FacadePart& block : plan.blocks)
    svg += line(sheet, block, "stroke=\"#8a8478\" stroke-width=\"1\"",
                fmt::format("block {}.{}: {:.1f} m", block.stretch, block.number, block.length_m));
  for (const FacadePart& gap : plan.gaps)
    svg += line(sheet, gap, "stroke=\"#d8a48f\" stroke-width=\"0.4\" stroke-dasharray=\"1 1\"",
                fmt::format("gap {}.{}: {:.1f} m", gap.stretch, gap.number, gap.length_m));
  for (const StreetKerb& kerb : plan.kerbs) svg += kerb_line(sheet, kerb);
  for (const StreetTree& tree : plan.trees) svg += tree_symbol(sheet, tree);
  for (const StreetObject& o : plan.objects) svg += symbol(sheet, o, metres_per_unit);
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

// A kind of thing on the map: its symbol in a box of 2 by 1 around the origin, and its name.
struct LegendRow {
  std::string mark, name;
};

// The kinds that are on the map, with their numbers.
std::vector<LegendRow> legend_of(const StreetPlan& plan) {
  std::vector<LegendRow> rows;
  const auto area = [](const std::string& colour) {
    return fmt::format("<rect x=\"-0.9\" y=\"-0.4\" width=\"1.8\" height=\"0.8\" fill=\"{}\"/>", colour);
  };
  const auto stroke = [](const char* look) { return fmt::format("<path d=\"M-0.9 0h1.8\" {}/>", look); };
  const auto add = [&](const std::string& mark, const std::string& name, std::size_t count) {
    if (count > 0) rows.push_back({mark, fmt::format("{} ({})", name, count)});
  };
  for (const auto& [of, count] : counts_of(plan)) add(area(colour_of(of.first)), of.second, count);
  add(fmt::format("<circle r=\"0.45\" fill=\"{0}\" fill-opacity=\"0.25\" stroke=\"{0}\" stroke-width=\"0.06\"/>"
                  "<circle r=\"0.12\" fill=\"{1}\"/>",
                  kTree, kTrunk),
      "tree, its crown", plan.trees.size());
  add(stroke(fmt::format("stroke=\"{}\" stroke-width=\"0.12\"", kKerb).c_str()), "kerb, dashed where hidden",
      plan.kerbs.size());
  add(area(kPavement), "pavement", plan.pavements.size());
  add(area(kRoad), "carriageway", plan.carriageways.size());
  add(stroke("stroke=\"#8a8478\" stroke-width=\"0.5\""), "houses", plan.blocks.size());
  add(stroke("stroke=\"#d8a48f\" stroke-width=\"0.2\" stroke-dasharray=\"0.4 0.3\""), "gap between houses",
      plan.gaps.size());
  return rows;
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
    svg += fmt::format("<g transform=\"translate({:.2f} {:.2f}) scale({:.3f})\">{}</g>\n", x + text, y, text, row.mark);
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
  const Sheet sheet(plan, metres_per_unit);
  return opened_svg(sheet.width(), sheet.height()) + content_of(sheet, plan, metres_per_unit) +
         scale_bar(sheet.height() - 2, "") + "</svg>\n";
}

std::string street_sheet_svg(const StreetPlan& plan, double metres_per_unit, std::span<const std::string> notes) {
  const Sheet sheet(plan, metres_per_unit);
  const std::vector<LegendRow> rows = legend_of(plan);
  const double least = kRowsOfText * (static_cast<double>(rows.size() + notes.size()) + kRowsBesideLegend);
  const double text = std::clamp(sheet.height() / least, kLeastText, kMostText);
  const double strip = kLegendWidth * text, height = std::max(sheet.height(), text * least);
  std::string svg = opened_svg(sheet.width() + strip, height) + content_of(sheet, plan, metres_per_unit);
  svg += fmt::format(
      "<g font-family=\"sans-serif\" font-size=\"{:.2f}\" text-anchor=\"middle\" fill=\"#111\" "
      "stroke=\"#fff\" stroke-width=\"0.15\" paint-order=\"stroke\">\n",
      kNumberText);
  for (const StreetObject& o : plan.objects)
    svg += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", sheet.x(o.middle),
                       sheet.y(o.middle) + 0.35 * kNumberText, o.id);
  svg += fmt::format("</g>\n<g font-family=\"sans-serif\" font-size=\"{:.2f}\" fill=\"#222\">\n", text);
  svg += legend_svg(rows, notes, sheet.width() + text, text);
  svg += scale_bar(height - 2, fmt::format("{:.0f} m", kScaleBar));
  return svg + "</g>\n</svg>\n";
}

std::string street_legend_html(const StreetPlan& plan) {
  std::string html = "<table><thead><tr><th>class</th><th class=\"n\">objects</th></tr></thead><tbody>\n";
  for (const auto& [of, count] : counts_of(plan))
    html += fmt::format("<tr><td><i class=\"swatch\" style=\"background:{}\"></i>{}</td><td class=\"n\">{}</td></tr>\n",
                        colour_of(of.first), of.second, count);
  const auto row = [](const char* colour, const char* name, std::size_t count) {
    return fmt::format("<tr><td><i class=\"swatch\" style=\"background:{}\"></i>{}</td><td class=\"n\">{}</td></tr>\n",
                       colour, name, count);
  };
  html += row(kTree, "tree", plan.trees.size()) + row(kKerb, "kerb", plan.kerbs.size()) +
          row(kPavement, "pavement", plan.pavements.size()) + row(kRoad, "carriageway", plan.carriageways.size());
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
