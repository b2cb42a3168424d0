// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/street_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/model/object_colours.h"
#include "engine/model/point_label.h"
#include "engine/model/street_geometry.h"

namespace ilot {
namespace {

constexpr double kLeastSymbol = 0.3;  // metres; smaller objects are drawn with this size
constexpr double kTreeDot = 0.3;      // metres; radius of the dot at the trunk
constexpr double kThin = 0.1, kKerbWidth = 0.2, kGapWidth = 0.4, kHouseWidth = 1;  // metres; of lines
constexpr double kKerbDash = 0.6, kGapDash = 1;                                    // metres
constexpr MapColour kTree{47, 125, 50}, kTrunk{93, 64, 55}, kKerb{178, 34, 96}, kPavement{230, 223, 208},
    kRoad{223, 225, 229}, kHouse{138, 132, 120}, kGap{216, 164, 143};

MapColour colour_of(PointLabel label) {
  const auto [red, green, blue] = object_colour(label);
  return {red, green, blue};
}

MapShape area_of(std::vector<std::vector<FlatPoint>> rings, MapColour fill, std::string title) {
  MapShape shape;
  shape.lines = std::move(rings);
  shape.fill = fill;
  shape.title = std::move(title);
  return shape;
}

MapShape line_of(std::vector<FlatPoint> line, MapColour stroke, double width, double dash, std::string title) {
  MapShape shape;
  shape.lines = {std::move(line)};
  shape.closed = false;
  shape.stroke = stroke;
  shape.width = width, shape.dash = dash;
  shape.title = std::move(title);
  return shape;
}

MapShape circle_of(FlatPoint centre, double radius, std::string title) {
  MapShape shape;
  shape.centre = centre, shape.radius = radius;
  shape.title = std::move(title);
  return shape;
}

// The crown, and the dot at the trunk, which is hollow where no trunk was seen. Lengths are times `unit`.
void add_tree(FlatPoint at, double radius, double dot, double unit, bool trunk_seen, const std::string& title,
              std::vector<MapShape>& shapes) {
  MapShape crown = circle_of(at, radius, title), trunk = circle_of(at, dot, "");
  crown.fill = crown.stroke = kTree;
  crown.clear = true, crown.width = kThin * unit;
  if (trunk_seen)
    trunk.fill = kTrunk;
  else
    trunk.stroke = kTrunk, trunk.width = kThin * unit;
  shapes.push_back(crown), shapes.push_back(trunk);
}

// Converts places of a plan to metres from its lower left corner, and collects what is drawn.
class Shapes {
 public:
  Shapes(const StreetPlan& plan, double metres_per_unit) : plan_(plan), metres_(metres_per_unit) {
    out_.origin = corner();
    for (const Carriageway& road : plan.carriageways) add(road);
    for (const Pavement& pavement : plan.pavements) add(pavement);
    for (const FacadePart& block : plan.blocks) add(block, "block", kHouse, kHouseWidth, 0);
    for (const FacadePart& gap : plan.gaps) add(gap, "gap", kGap, kGapWidth, kGapDash);
    for (const StreetKerb& kerb : plan.kerbs) add(kerb);
    for (const StreetTree& tree : plan.trees)
      add_tree(
          at(tree.position), tree.crown_radius_m, kTreeDot, 1, tree.trunk_seen,
          fmt::format("tree {}: {:.1f} m high, crown {:.1f} m in radius", tree.id, tree.height_m, tree.crown_radius_m),
          out_.shapes);
    for (const StreetObject& o : plan.objects) add(o);
    out_.box = FlatBox::none();
    for (const MapShape& shape : out_.shapes) out_.box.add_box(shape.box());
    if (out_.box.is_empty()) out_.box = {};
  }
  StreetShapes take() { return std::move(out_); }

 private:
  // The least coordinates of the plan: places on the map are small numbers.
  Vec3 corner() const {
    Vec3 least{INFINITY, INFINITY, 0};
    const auto take = [&](Vec3 p) { least.x = std::min(least.x, p.x), least.y = std::min(least.y, p.y); };
    for (const StreetObject& o : plan_.objects) take(o.middle);
    for (const auto* parts : {&plan_.blocks, &plan_.gaps})
      for (const FacadePart& part : *parts) take(part.from), take(part.to);
    for (const StreetKerb& kerb : plan_.kerbs) std::ranges::for_each(kerb.line, take);
    for (const Pavement& pavement : plan_.pavements) std::ranges::for_each(pavement.ring, take);
    for (const Carriageway& road : plan_.carriageways) std::ranges::for_each(road.ring, take);
    for (const StreetTree& tree : plan_.trees) take(tree.position);
    return std::isfinite(least.x) ? least : Vec3{};
  }
  FlatPoint at(Vec3 p) const { return {(p.x - out_.origin.x) * metres_, (p.y - out_.origin.y) * metres_}; }
  std::vector<FlatPoint> at(std::span<const Vec3> line) const {
    std::vector<FlatPoint> places;
    for (const Vec3& p : line) places.push_back(at(p));
    return places;
  }

  void add(const Carriageway& road) {
    std::vector<std::vector<FlatPoint>> rings{at(road.ring)};
    for (const std::vector<Vec3>& hole : road.holes) rings.push_back(at(hole));
    out_.shapes.push_back(area_of(std::move(rings), kRoad,
                                  fmt::format("carriageway {}: {:.2f} m wide, {:.2f} m at its narrowest, {:.0f} m2",
                                              road.id, road.width_m, road.narrowest_m, road.area_m2)));
  }
  void add(const Pavement& pavement) {
    out_.shapes.push_back(area_of({at(pavement.ring)}, kPavement,
                                  fmt::format("pavement {}: {:.2f} m wide, {:.2f} m free at its narrowest", pavement.id,
                                              pavement.width_m, pavement.passable_m)));
  }
  void add(const FacadePart& part, const char* kind, MapColour colour, double width, double dash) {
    out_.shapes.push_back(line_of({at(part.from), at(part.to)}, colour, width, dash,
                                  fmt::format("{} {}.{}: {:.1f} m", kind, part.stretch, part.number, part.length_m)));
  }
  void add(const StreetKerb& kerb) {
    out_.shapes.push_back(
        line_of(at(kerb.line), kKerb, kKerbWidth, kerb.seen ? 0 : kKerbDash,
                fmt::format("kerb {}: {:.2f} m high{}", kerb.id, kerb.height_m, kerb.seen ? "" : ", not seen")));
  }
  void add(const StreetObject& o) {
    StreetObject drawn = o;
    drawn.length_m = std::max(o.length_m, kLeastSymbol);
    drawn.width_m = std::max(o.width_m, kLeastSymbol);
    out_.shapes.push_back(
        area_of({at(extent_of(drawn, metres_))}, colour_of(o.label),
                fmt::format("{} {}: {}, {:.2f} m high", o.class_name, o.id,
                            o.by_hand ? "by hand" : fmt::format("{:.0f} %", 100 * o.probability), o.height_m)));
    out_.numbers.push_back({at(o.middle), std::min(drawn.length_m, drawn.width_m) / 2, o.id});
  }

  const StreetPlan& plan_;
  double metres_;
  StreetShapes out_;
};

std::map<std::pair<PointLabel, std::string>, std::size_t> counts_of(const StreetPlan& plan) {
  std::map<std::pair<PointLabel, std::string>, std::size_t> counts;
  for (const StreetObject& o : plan.objects) ++counts[{o.label, o.class_name}];
  return counts;
}

}  // namespace

FlatBox MapShape::box() const {
  FlatBox box = FlatBox::none();
  for (const std::vector<FlatPoint>& line : lines)
    for (const FlatPoint& p : line) box.add(p);
  if (lines.empty()) box.add(centre), box = box.grown(radius);
  return box;
}

StreetShapes street_shapes(const StreetPlan& plan, double metres_per_unit) {
  return Shapes(plan, metres_per_unit).take();
}

std::vector<MapShape> area_sample(MapColour colour) {
  return {area_of({{{-0.9, -0.4}, {0.9, -0.4}, {0.9, 0.4}, {-0.9, 0.4}}}, colour, "")};
}

std::vector<LegendRow> street_legend(const StreetPlan& plan) {
  std::vector<LegendRow> rows;
  const auto add = [&](std::vector<MapShape> sample, const std::string& name, std::size_t count) {
    if (count > 0) rows.push_back({std::move(sample), fmt::format("{} ({})", name, count)});
  };
  const auto line = [](MapColour colour, double width, double dash) {
    return std::vector{line_of({{-0.9, 0}, {0.9, 0}}, colour, width, dash, "")};
  };
  for (const auto& [of, count] : counts_of(plan)) add(area_sample(colour_of(of.first)), of.second, count);
  std::vector<MapShape> tree;
  add_tree({0, 0}, 0.45, 0.12, 0.6, true, "", tree);
  add(tree, "tree, its crown", plan.trees.size());
  add(line(kKerb, 0.12, 0), "kerb, dashed where hidden", plan.kerbs.size());
  add(area_sample(kPavement), "pavement", plan.pavements.size());
  add(area_sample(kRoad), "carriageway", plan.carriageways.size());
  add(line(kHouse, 0.5, 0), "houses", plan.blocks.size());
  add(line(kGap, 0.2, 0.4), "gap between houses", plan.gaps.size());
  return rows;
}

std::vector<KindCount> street_kinds(const StreetPlan& plan) {
  std::vector<KindCount> kinds;
  for (const auto& [of, count] : counts_of(plan)) kinds.push_back({colour_of(of.first), of.second, count});
  kinds.push_back({kTree, "tree", plan.trees.size()});
  kinds.push_back({kKerb, "kerb", plan.kerbs.size()});
  kinds.push_back({kPavement, "pavement", plan.pavements.size()});
  kinds.push_back({kRoad, "carriageway", plan.carriageways.size()});
  return kinds;
}

}  // namespace ilot
