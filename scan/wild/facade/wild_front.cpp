// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_front.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr double kEdge = 0.2;         // metres of wall at both ends of a front, at least
constexpr double kBetween = 0.25;     // metres of wall between two openings, at least
constexpr double kBelowGround = 0.4;  // metres

std::uint64_t opening_index(const WildFront& front, std::uint32_t row, std::uint32_t column) {
  return element_index(front.plot.house, row, column);
}

// Returns the head of an opening of the given size, or a flat one where the form does not fit.
Opening headed(Opening o, std::string_view form, double share) {
  const double half = (o.right - o.left) / 2, height = o.springing - o.bottom;
  double rise = 0;
  if (form == "segmental") rise = half * (0.1 + 0.5 * share);
  if (form == "round") rise = half;
  if (form == "basket") rise = half * (0.45 + 0.35 * share);
  if (form == "pointed") rise = half * (1.05 + 0.9 * share);
  if (rise == 0 || rise > height - 0.35) return o;
  o.head = form == "basket" ? ArchHead::basket : form == "pointed" ? ArchHead::pointed : ArchHead::circular;
  o.rise = rise;
  o.springing -= rise;
  return o;
}

// The sizes of the windows of one storey.
struct StoreyStyle {
  std::uint32_t row = 1, bays = 1;
  double floor = 0, height = 3;
  double width = 1, tall = 1.5, sill = 0.9;
  std::string_view form;
  double rise = 0;
};

StoreyStyle draw_storey(Draws& draws, const WildFront& front, std::uint32_t row) {
  const std::uint64_t house = front.plot.house, storey = element_index(house, row);
  StoreyStyle style;
  style.row = row;
  style.floor = front.floors[row - 1];
  style.height = front.floors[row] - style.floor;
  style.bays = front.bays;
  if (row > 1 && draws.happens("own_bays", storey, house)) {
    const auto change = static_cast<std::uint32_t>(draws.random("bays of a storey", storey).below(3));
    style.bays = std::max<std::uint32_t>(1, front.bays + change - 1);
  }
  const double pitch = (front.plot.width - 2 * kEdge) / style.bays;
  style.width = std::min(draws.number("window_width", house) * draws.number("window_change", storey), pitch - kBetween);
  const double most = style.height - 0.35;
  style.sill = std::max(0.05, draws.number("window_sill", storey) * style.height);
  if (row == 1) style.sill = std::max(style.sill, 0.6);
  style.tall = std::clamp(draws.number("window_height", storey) * style.height, 0.45, most);
  style.sill = std::min(style.sill, most - style.tall + 0.05);
  style.form = draws.choice("arch_form", storey);
  style.rise = draws.number("arch_rise", storey);
  return style;
}

// A window whose place and size scatter.
Opening window_hole(Draws& draws, const WildFront& front, const StoreyStyle& style, std::uint32_t column) {
  const double pitch = (front.plot.width - 2 * kEdge) / style.bays, scatter = draws.number("scatter");
  Rng rng = draws.random("scatter", opening_index(front, style.row, column));
  const auto moved = [&](double v) { return v + scatter * gaussian(rng); };
  const double middle = moved(kEdge + pitch * (column - 0.5)), width = std::max(0.3, moved(style.width));
  const double left = std::max(middle - width / 2, kEdge / 2);
  const double right = std::min(middle + width / 2, front.plot.width - kEdge / 2);
  const double bottom = std::max(style.floor + 0.02, moved(style.floor + style.sill));
  const double top = std::min(style.floor + style.height - 0.12, std::max(bottom + 0.4, moved(bottom + style.tall)));
  return headed({left, right, bottom, top, 0}, style.form, style.rise);
}

// An opening of the ground floor that is neither a window nor a blank bay.
Opening ground_hole(Draws& draws, const WildFront& front, const StoreyStyle& style, std::uint32_t column, WildUse use) {
  Rng rng = draws.random("ground floor", opening_index(front, 1, column));
  const double pitch = (front.plot.width - 2 * kEdge) / style.bays, middle = kEdge + pitch * (column - 0.5);
  const double wide = use == WildUse::door     ? 0.85 + 0.7 * rng.uniform()
                      : use == WildUse::garage ? 2.2 + rng.uniform()
                                               : pitch;
  const double width = std::min(wide, pitch - kBetween - 0.2 * rng.uniform());
  const double high = style.height - 0.3;
  const double low = use == WildUse::door || use == WildUse::arcade ? 1.95 : 2.1;
  const double top = std::min(high, low + (high - low) * rng.uniform());
  const double bottom = use == WildUse::shop ? 0.02 + 0.4 * rng.uniform() : 0.01 + 0.12 * rng.uniform();
  return headed({middle - width / 2, middle + width / 2, bottom, std::max(top, bottom + 1.8), 0}, style.form,
                style.rise);
}

WildUse ground_use(std::string_view kind) {
  return kind == "shops"     ? WildUse::shop
         : kind == "garages" ? WildUse::garage
         : kind == "arcade"  ? WildUse::arcade
                             : WildUse::window;
}

void plan_openings(Draws& draws, WildFront& front) {
  const std::uint64_t house = front.plot.house;
  const WildUse ground = ground_use(draws.choice("ground_floor", house));
  for (std::uint32_t row = 1; row < front.floors.size(); ++row) {
    const StoreyStyle style = draw_storey(draws, front, row);
    const auto door = static_cast<std::uint32_t>(1 + draws.random("door", house).below(style.bays));
    for (std::uint32_t column = 1; column <= style.bays; ++column) {
      const std::uint64_t element = opening_index(front, row, column);
      WildOpening o{{}, {row, column}, WildUse::window, element};
      if (row == 1) o.use = column == door ? front.plot.gate ? WildUse::arcade : WildUse::door : ground;
      if (o.use == WildUse::window && draws.happens("blank_bays", element, house)) continue;
      o.hole = o.use == WildUse::window ? window_hole(draws, front, style, column)
                                        : ground_hole(draws, front, style, column, o.use);
      front.openings.push_back(o);
    }
  }
}

void plan_wall(Draws& draws, WildFront& front) {
  const std::uint64_t house = front.plot.house;
  const auto of_house = [&](const char* name) { return draws.number(name, house); };
  const std::string_view kind = draws.choice("wall_kind", house);
  WallRelief& r = front.relief;
  r.roughness = of_house("roughness");
  r.grain = of_house("roughness_size");
  r.key = draws.random("relief", house).at(0);
  front.material = kind == "render" ? Material::render : kind == "brick" ? Material::brick : Material::limestone;
  front.tone = static_cast<std::uint8_t>(1 + draws.random("tone", house).below(255));
  if (kind == "rubble") {
    r.roughness = std::min(0.02, 3 * r.roughness);
    r.grain = std::max(r.grain, 0.1);
  }
  if (kind == "ashlar" || kind == "brick") {
    const bool brick = kind == "brick";
    r.roughness *= 0.3;
    r.stone_width = brick ? 0.22 : of_house("stone_width");
    r.stone_height = brick ? 0.065 : of_house("stone_height");
    r.joint = brick ? 0.01 : of_house("joint_width");
    r.joint_depth = of_house("joint_depth") * (brick ? 0.3 : 1);
    r.stone_out = of_house("stone_out") * (brick ? 0.3 : 1);
  }
}

// Adds the wall with its openings; the plane's area counts what is wall.
void add_wall(FacadeBuilder& facade, const WildFront& front) {
  std::vector<Opening> holes;
  double area = front.plot.width * front.eave();
  for (const WildOpening& o : front.openings) {
    holes.push_back(o.hole);
    area -= (o.hole.right - o.hole.left) * (o.hole.springing - o.hole.bottom + 0.7 * o.hole.rise);
  }
  Finish joint = wild_finish(WildClass::joint, Material::mortar, 0, front.tone);
  if (front.relief.joint > 0)
    joint.element = add_thing(facade, "joint", {0, front.plot.width, -front.relief.joint_depth, 0, 0, front.eave()});
  facade.wall(0, front.plot.width, front.foot(), front.eave(), 0, holes,
              wild_finish(WildClass::facade, front.material, 0, front.tone), front.relief, joint);
  facade.scene().planes.back().area = area;
}

}  // namespace

std::map<int, std::string> wild_classes() {
  return {{0, "mixed"},    {1, "facade"},      {2, "joint"},   {3, "reveal"}, {4, "sill"},    {5, "surround"},
          {6, "moulding"}, {7, "shutter"},     {8, "balcony"}, {9, "roof"},   {10, "ground"}, {11, "wall"},
          {12, "object"},  {13, "vegetation"}, {14, "other"},  {15, "stray"}};
}

double WildFront::foot() const {
  return std::min({0.0, plot.ground_left, plot.ground_right}) - kBelowGround;
}

double bay_of(const WildFront& front) {
  return (front.plot.width - 2 * kEdge) / front.bays;
}

std::uint32_t add_thing(FacadeBuilder& facade, const char* kind, const Block& box) {
  TrueElement e;
  e.kind = kind;
  e.ring = facade.outline({box.x0, box.x1, box.z0, box.z1, 0}, box.out1);
  e.width = box.x1 - box.x0;
  e.height = box.z1 - box.z0;
  e.depth = box.out1;
  return facade.add_element(e);
}

WildFront plan_front(Draws& draws, const WildPlot& plot) {
  const std::uint64_t house = plot.house;
  WildFront front;
  front.plot = plot;
  front.frame = plot.frame;
  const auto storeys =
      std::min<std::uint32_t>(plot.most_storeys, static_cast<std::uint32_t>(draws.whole("storeys", house)));
  front.floors = {0, draws.number("ground_storey", house)};
  for (std::uint32_t row = 2; row <= storeys; ++row)
    front.floors.push_back(front.floors.back() + draws.number("storey_height", element_index(house, row)));
  front.bays = std::max<std::uint32_t>(
      1, static_cast<std::uint32_t>(std::floor((plot.width - 2 * kEdge) / draws.number("bay", house))));
  front.frame.form = {plot.width, front.eave(), draws.number("wall_lean", house), draws.number("bow_across", house),
                      draws.number("bow_up", house)};
  front.reveal = draws.number("reveal", house);
  front.depth = draws.number("house_depth", house);
  plan_wall(draws, front);
  plan_openings(draws, front);
  return front;
}

void build_front(TerrestrialScene& scene, Draws& draws, const WildFront& front) {
  FacadeBuilder facade(scene, front.frame, front.plot.facade);
  add_wall(facade, front);
  add_openings(facade, draws, front);
  add_mouldings(facade, draws, front);
  add_fittings(facade, draws, front);
  add_climbing_plants(facade, draws, front);
  add_roof(facade, draws, front);
}

}  // namespace ilot::scan
