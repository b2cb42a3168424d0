// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_scenes.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/exact_math.h"
#include "scan/wild/facade/wild_front.h"
#include "scan/wild/facade/wild_site.h"

namespace ilot::scan {
namespace {

constexpr double kStoreyGuess = 3.2;           // metres, to guess the area of walls before they are drawn
constexpr double kShareOfWalls = 0.6;          // of the most points
constexpr std::uint64_t kOppositeHouse = 100;  // the draws of houses on the other side begin here
constexpr Vec3 kZenith{0, 0, 1};

FacadeFrame turned(const FacadeFrame& frame, double degrees) {
  const SinCos turn = sin_cos_deg(degrees);
  FacadeFrame result = frame;
  result.along = turn.cos * frame.along - turn.sin * frame.out;
  result.out = cross(result.along, kZenith);
  return result;
}

FacadeFrame draw_heading(Draws& draws) {
  return turned({}, draws.number("heading"));
}

WildScan begin_scan(Draws& draws, std::uint64_t seed) {
  WildScan scan = draw_scanner(draws, seed);
  scan.scene.classes = wild_classes();
  scan.stray_class = static_cast<std::uint8_t>(WildClass::stray);
  return scan;
}

// Returns the area of wall that the density leaves room for.
double wall_budget(const WildScan& scan) {
  return kShareOfWalls * static_cast<double>(kMostWildPoints) / scan.density;
}

std::uint32_t storeys_for(const WildScan& scan, double width) {
  return static_cast<std::uint32_t>(std::clamp(wall_budget(scan) / (width * kStoreyGuess), 1.0, 6.0));
}

WildSite draw_street(Draws& draws, const FacadeFrame& frame) {
  WildSite site;
  site.frame = frame;
  site.slope = draws.number("street_slope");
  site.pavement = draws.number("pavement_width");
  site.road = draws.number("road_width");
  site.kerb = draws.number("kerb");
  site.width = 2 * site.pavement + site.road;
  return site;
}

// Puts the threshold of a house at the higher end of its ground.
void set_on_ground(WildPlot& plot, const WildSite& site, double x0, double x1) {
  const double left = site.ground(x0, 0), right = site.ground(x1, 0), level = std::max(left, right);
  plot.frame.origin.z = level;
  plot.ground_left = left - level;
  plot.ground_right = right - level;
}

// Cuts off what floats above the roofs, and ends the scene.
void finish_scene(WildScan& scan, double reach) {
  scan.crop.z1 = reach + 6;
  scan.beam.mirrored =
      scan.scene.model.add_surface({static_cast<std::uint8_t>(WildClass::stray), 0, 0, Material::glass, 0});
  drop_cropped(scan.scene, scan.crop);
}

// Everything that is on a street besides the houses; the crop is that of an office.
void finish_street(WildScan& scan, Draws& draws, const WildSite& site, double reach) {
  const double front = std::min(draws.number("crop_front"), std::max(0.2, wall_budget(scan) / site.length));
  const double beside = draws.number("crop_beside"), behind = draws.number("crop_behind");
  scan.crop = {site.frame.origin,
               site.frame.along,
               site.frame.out,
               -beside,
               site.length + beside,
               -behind - 1,
               site.opposite ? site.width + behind : front};
  place_scanner(scan, draws, site, reach);
  add_ground(scan.scene, site);
  add_street_things(scan.scene, draws, site);
  finish_scene(scan, reach);
}

void build_house(WildScan& scan, Draws& draws, const WildPlot& plot, bool counts, double& reach) {
  const std::size_t first = scan.scene.planes.size();
  const WildFront front = plan_front(draws, plot);
  build_front(scan.scene, draws, front);
  if (!counts) scan.scene.planes[first].area = 0;
  reach = std::max(reach, plot.frame.origin.z + front.eave() + 4);
}

// Builds houses from left to right, each standing back or forth and turned a little from the one before.
double build_row(WildScan& scan, Draws& draws, const WildSite& site, FacadeFrame start, std::uint64_t first_house,
                 int houses, std::uint32_t first_facade, double most_length) {
  double reach = 0, length = 0;
  FacadeFrame frame = start;
  for (int i = 0; i < houses; ++i) {
    const std::uint64_t house = first_house + static_cast<std::uint64_t>(i);
    WildPlot plot;
    plot.house = house;
    plot.facade = first_facade + static_cast<std::uint32_t>(i);
    plot.width = std::min(draws.number("house_width", house), most_length - length);
    if (plot.width < 3) break;
    if (i > 0) {
      frame = turned(frame, draws.number("row_bend", house));
      // Where a front has turned or moved far from the line of the street it comes back.
      const double off = dot(site.frame.out, frame.origin - start.origin) * dot(site.frame.out, start.out);
      const double side = off < -1.5                                            ? 1
                          : off > 0.3                                           ? -1
                          : draws.random("setback side", house).uniform() < 0.5 ? -1
                                                                                : 1;
      if (draws.happens("setbacks", house))
        frame.origin = frame.origin + (side * draws.number("setback", house)) * frame.out;
    }
    plot.frame = frame;
    plot.most_storeys = storeys_for(scan, most_length);
    const double x = dot(site.frame.along, frame.origin - site.frame.origin);
    const double step = plot.width * dot(site.frame.along, frame.along);
    set_on_ground(plot, site, x, x + step);
    build_house(scan, draws, plot, true, reach);
    frame.origin = frame.origin + plot.width * frame.along;
    length += plot.width;
  }
  return reach;
}

// Returns the number of houses of a row and the length of their fronts.
std::pair<int, double> plan_row_length(WildScan& scan, Draws& draws) {
  int houses = draws.whole("houses");
  const auto length_of = [&](int count) {
    double length = 0;
    for (int i = 0; i < count; ++i) length += draws.number("house_width", static_cast<std::uint64_t>(i));
    return length;
  };
  while (houses > 3 && length_of(houses) * kStoreyGuess > wall_budget(scan)) --houses;
  return {houses, length_of(houses)};
}

}  // namespace

WildScan plan_facade_wild(const SceneValues& values, std::uint64_t seed) {
  Draws draws(values, kFacadeWildGroups, seed);
  WildScan scan = begin_scan(draws, seed);
  WildSite site = draw_street(draws, draw_heading(draws));
  double reach = 0, ignored = 0;
  WildPlot plot;
  plot.frame = site.frame;
  plot.width = site.length = draws.number("house_width", 0);
  plot.most_storeys = storeys_for(scan, plot.width);
  set_on_ground(plot, site, 0, plot.width);
  build_house(scan, draws, plot, true, reach);
  const std::string_view neighbours = draws.choice("neighbours");
  for (const bool right : {false, true}) {
    if (neighbours == "none" || neighbours == (right ? "left" : "right")) continue;
    WildPlot other;
    other.house = other.facade = right ? 3 : 2;
    other.width = draws.number("house_width", other.house);
    const double x0 = right ? plot.width : -other.width;
    other.frame = site.frame;
    other.frame.origin = site.frame.place(x0, -draws.number("neighbour_setback", other.house), 0);
    set_on_ground(other, site, x0, x0 + other.width);
    build_house(scan, draws, other, false, ignored);
  }
  finish_street(scan, draws, site, reach);
  scan.drawn = draws.drawn();
  return scan;
}

WildScan plan_row_wild(const SceneValues& values, std::uint64_t seed) {
  Draws draws(values, kRowWildGroups, seed);
  WildScan scan = begin_scan(draws, seed);
  WildSite site = draw_street(draws, draw_heading(draws));
  const auto [houses, length] = plan_row_length(scan, draws);
  site.length = length;
  site.opposite = draws.is("opposite", "houses");
  const double most = site.opposite ? 2 * length : length;
  double reach = build_row(scan, draws, site, site.frame, 0, houses, 1, length);
  if (site.opposite) {
    FacadeFrame across = site.frame;
    across.origin = site.frame.place(length, site.width, 0);
    across.along = -1.0 * site.frame.along;
    across.out = -1.0 * site.frame.out;
    const auto first = static_cast<std::uint32_t>(houses + 1);
    reach = std::max(reach, build_row(scan, draws, site, across, kOppositeHouse, 12, first, most - length));
  }
  finish_street(scan, draws, site, reach);
  scan.drawn = draws.drawn();
  return scan;
}

WildScan plan_court_wild(const SceneValues& values, std::uint64_t seed) {
  Draws draws(values, kCourtWildGroups, seed);
  WildScan scan = begin_scan(draws, seed);
  WildSite site;
  site.frame = draw_heading(draws);
  site.frame.out = -1.0 * site.frame.out;  // the first wall faces the middle of the court
  site.frame.along = -1.0 * site.frame.along;
  site.length = draws.number("court_width");
  site.width = draws.number("court_depth");
  site.kerb = 0;
  site.court = true;
  const double skew = tan_deg(draws.number("court_turn")) * site.width;
  const std::array<Vec3, 4> corners{site.frame.place(0, 0, 0), site.frame.place(site.length, 0, 0),
                                    site.frame.place(site.length + skew, site.width, 0),
                                    site.frame.place(skew, site.width, 0)};
  double reach = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    // The walls run clockwise seen from above, so that each faces the middle.
    const Vec3 from = corners[i], way = corners[(i + 1) % 4] - from;
    WildPlot plot;
    plot.frame.origin = from;
    plot.frame.along = (1 / norm(way)) * way;
    plot.frame.out = cross(plot.frame.along, kZenith);
    plot.facade = static_cast<std::uint32_t>(i + 1);
    plot.house = i;
    plot.width = norm(way);
    plot.most_storeys = storeys_for(scan, 2 * (site.length + site.width));
    plot.gate = i == 0 && draws.is("court_gate", "gate");
    build_house(scan, draws, plot, true, reach);
  }
  const double behind = draws.number("crop_behind");
  scan.crop = {site.frame.origin,
               site.frame.along,
               site.frame.out,
               -behind + std::min(0.0, skew),
               site.length + std::max(0.0, skew) + behind,
               -behind,
               site.width + behind};
  place_scanner(scan, draws, site, reach);
  add_ground(scan.scene, site);
  add_street_things(scan.scene, draws, site);
  finish_scene(scan, reach);
  scan.drawn = draws.drawn();
  return scan;
}

}  // namespace ilot::scan
