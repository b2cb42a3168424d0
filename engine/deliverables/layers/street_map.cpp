// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/street_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/model/object_colours.h"
#include "engine/model/point_label.h"
#include "engine/model/street_geometry.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr double kMargin = 5;         // metres around the drawn content
constexpr double kLeastSymbol = 0.3;  // metres; smaller objects are drawn with this size
constexpr double kScaleBar = 20;      // metres
constexpr double kTreeDot = 0.3;      // metres; radius of the dot at the trunk
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

}  // namespace

std::string street_map_svg(const StreetPlan& plan, double metres_per_unit) {
  const Sheet sheet(plan, metres_per_unit);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.2f} {1:.2f}\">\n"
      "<rect width=\"{0:.2f}\" height=\"{1:.2f}\" fill=\"#fbfaf7\"/>\n",
      sheet.width(), sheet.height());
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
  svg +=
      fmt::format("<path d=\"M2 {0:.2f}h{1}\" stroke=\"#333\" stroke-width=\"0.4\"/>\n", sheet.height() - 2, kScaleBar);
  return svg + "</svg>\n";
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
  return html +
         fmt::format(
             "</tbody></table>\n<p class=\"note\">{} blocks (grey) and {} gaps between them (dashed). Circles are "
             "crowns; the dot is the trunk, hollow where no trunk was seen. Dashed kerbs were not seen. The bar is "
             "{:.0f} m long. North is up.</p>\n",
             plan.blocks.size(), plan.gaps.size(), kScaleBar);
}

void write_street_map(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit) {
  write_whole_file(folder / "streets.svg", street_map_svg(plan, metres_per_unit));
}

}  // namespace ilot
