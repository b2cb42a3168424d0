// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "scan/facades/window.h"
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr std::array kOptions = with_beam_options(std::array{
    SceneOption{"scene.step", 0.0286479, "deg", 0.002, 1, "angular step (0.5 mrad), both ways; --points scales it"},
    SceneOption{"scene.length", 24, "m", 12, 80, "of the house"},
    SceneOption{"scene.width", 14, "m", 9, 60, "of the house"},
    SceneOption{"scene.storeys", 3, "storeys", 1, 8, "of 3.1 m each"},
    SceneOption{"scene.heading", 17, "deg", -90, 90, "of its long side, anticlockwise from east"},
    SceneOption{"scene.distance", 5.85, "m", 4, 60,
                "of the stations at the corners; the two before the long sides stand twice as far"},
    SceneOption{"scene.bulges", 12, "bulges", 0, 60, "irregularities of the render, shared out over the facades"},
    SceneOption{"scene.bulge_min", 0.02, "m", 0.005, 0.2, "least height of a bulge"},
    SceneOption{"scene.bulge_max", 0.06, "m", 0.005, 0.2, "greatest height of a bulge"},
    SceneOption{"scene.ground", 3, "m", 0.1, 30, "strip of ground kept around the house"},
});

constexpr double kStorey = 3.1, kEaves = 0.45, kPitchOfWindows = 3.0, kWindowWidth = 1.1;
constexpr double kSillHeight = 0.9, kHeadHeight = 2.45;  // heights of a window above its floor
constexpr double kRoofPitchDeg = 42;

Finish finish(BuildingClass surface_class, Material material, std::uint32_t element = 0) {
  return {static_cast<std::uint8_t>(surface_class), element, material};
}

WindowStyle window_style() {
  WindowStyle style;
  style.classes = {static_cast<std::uint8_t>(BuildingClass::reveal), static_cast<std::uint8_t>(BuildingClass::sill),
                   static_cast<std::uint8_t>(BuildingClass::lintel), static_cast<std::uint8_t>(BuildingClass::other)};
  style.wall = Material::limestone;
  style.recess = 0.2;
  style.sill_out = 0.08;
  style.lintel_out = 0.04;
  return style;
}

struct House {
  double length, width, height;
  SinCos heading;

  explicit House(const SceneValues& values)
      : length(values.get("scene.length")),
        width(values.get("scene.width")),
        height(kStorey * std::round(values.get("scene.storeys"))),
        heading(sin_cos_deg(values.get("scene.heading"))) {}

  // Returns a position from the middle of the house, along its length and across it.
  Vec3 place(double along, double across, double z) const {
    return {along * heading.cos - across * heading.sin, along * heading.sin + across * heading.cos, z};
  }

  // Facades 0 and 2 are the long ones. Each facade begins where the previous one ends.
  FacadeFrame frame(int side) const {
    const Vec3 u = place(1, 0, 0), v = place(0, 1, 0);
    const double l = length / 2, w = width / 2;
    const std::array<FacadeFrame, 4> frames{{{place(-l, -w, 0), u, -1.0 * v},
                                             {place(l, -w, 0), v, u},
                                             {place(l, w, 0), -1.0 * u, v},
                                             {place(-l, w, 0), -1.0 * v, -1.0 * u}}};
    return frames[static_cast<std::size_t>(side)];
  }
  double facade_length(int side) const { return side % 2 == 0 ? length : width; }
};

// Adds a cap of a sphere to the wall.
void add_cap(FacadeBuilder& facade, double x, double z, double radius, double height, const Finish& finish) {
  const double sphere_radius = (radius * radius + height * height) / (2 * height);
  const Vec3 centre = facade.frame().place(x, height - sphere_radius, z);
  Solid cap = sphere(centre, sphere_radius, facade.surface(finish));
  const Vec3 out = facade.frame().out, foot = facade.frame().place(x, -kOverlap, z);
  cut(cap, {-1.0 * out, dot(out, foot)}, facade.surface(finish));
  const Vec3 top = foot + (height + kOverlap) * out;
  const Vec3 side{std::abs(facade.frame().along.x) * radius, std::abs(facade.frame().along.y) * radius, radius};
  cap.bounds.min = {std::min(foot.x, top.x), std::min(foot.y, top.y), z};
  cap.bounds.max = {std::max(foot.x, top.x), std::max(foot.y, top.y), z};
  cap.bounds = {cap.bounds.min - side, cap.bounds.max + side};
  facade.add(cap);
}

bool clear_of(const std::vector<Opening>& openings, double x, double z, double reach) {
  return std::none_of(openings.begin(), openings.end(), [&](const Opening& o) {
    return x > o.left - reach && x < o.right + reach && z > o.bottom - reach && z < top_of(o) + reach;
  });
}

// Adds a main cap with two or three smaller caps on its sides. The result is not a simple shape.
void add_bulge(FacadeBuilder& facade, std::vector<Opening>& taken, double length, double height, double rise,
               Rng& rng) {
  const double radius = 0.35 + 0.3 * rng.uniform(), reach = 1.25 * radius;
  for (int attempt = 0; attempt < 400; ++attempt) {
    const double x = reach + (length - 2 * reach) * rng.uniform(), z = reach + (height - 2 * reach) * rng.uniform();
    if (!clear_of(taken, x, z, reach)) continue;
    TrueElement bulge;
    bulge.kind = "bulge";
    const Opening box{x - reach, x + reach, z - reach, z + reach, 0};
    bulge.ring = facade.outline(box, 0);
    bulge.width = bulge.height = 2 * reach;
    bulge.depth = rise;
    const Finish render = finish(BuildingClass::bulge, Material::render, facade.add_element(bulge));
    add_cap(facade, x, z, radius, rise, render);
    const std::uint64_t lumps = 2 + rng.below(2);
    for (std::uint64_t i = 0; i < lumps; ++i) {
      const SinCos way = sin_cos_deg(360 * rng.uniform() - 180);
      const double away = 0.65 * radius, size = (0.35 + 0.2 * rng.uniform()) * radius;
      add_cap(facade, x + away * way.cos, z + away * way.sin, size, (0.4 + 0.3 * rng.uniform()) * rise, render);
    }
    taken.push_back(box);
    return;
  }
}

// Adds a band of stone around the house below each storey except the first.
void add_bands(FacadeBuilder& facade, double length, int storeys, std::vector<Opening>& taken) {
  constexpr double kOut = 0.04, kHeight = 0.16;
  for (int storey = 1; storey < storeys; ++storey) {
    const Opening strip{0, length, storey * kStorey, storey * kStorey + kHeight, 0};
    TrueElement band;
    band.kind = "band";
    band.ring = facade.outline(strip, kOut);
    band.width = length;
    band.height = kHeight;
    band.depth = kOut;
    facade.block({strip.left, strip.right, -kOverlap, kOut, strip.bottom, strip.springing},
                 finish(BuildingClass::other, Material::limestone, facade.add_element(band)));
    taken.push_back(strip);
  }
}

// Adds one facade: a wall with a regular grid of windows. The long sides have a door in the middle. Returns the areas
// where nothing else may be placed.
std::vector<Opening> add_facade(FacadeBuilder& facade, double length, double height, int side, Rng& rng) {
  const int columns = std::max(1, static_cast<int>((length - 1) / kPitchOfWindows));
  const int storeys = static_cast<int>(height / kStorey + 0.5);
  const double first = (length - (columns - 1) * kPitchOfWindows) / 2;
  std::vector<Opening> openings;
  for (int row = 0; row < storeys; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = first + column * kPitchOfWindows, floor = row * kStorey + 0.3;
      const bool door = row == 0 && side % 2 == 0 && column == columns / 2;
      openings.push_back(
          {x - kWindowWidth / 2, x + kWindowWidth / 2, door ? 0.15 : floor + kSillHeight, floor + kHeadHeight, 0});
    }
  facade.wall(0, length, 0, height, 0, openings, finish(BuildingClass::facade, Material::render));
  std::vector<Opening> taken = openings;
  for (std::size_t i = 0; i < openings.size(); ++i) {
    const auto row = static_cast<std::uint32_t>(i) / static_cast<std::uint32_t>(columns);
    const auto column = static_cast<std::uint32_t>(i) % static_cast<std::uint32_t>(columns);
    if (openings[i].bottom < 0.5)
      add_door(facade, openings[i], {row + 1, column + 1}, DoorKind::door, window_style(), rng);
    else
      add_window(facade, openings[i], {row + 1, column + 1}, window_style(), rng);
    taken[i].bottom -= 0.15;  // space for sill and lintel
    taken[i].springing += 0.25;
  }
  add_bands(facade, length, storeys, taken);
  return taken;
}

// Adds a hip roof over eaves, and the strip of boards below them. Returns the height of the ridge.
double add_roof(FacadeBuilder& facade, const House& house, TrueBuilding& building) {
  const double slope = tan_deg(kRoofPitchDeg), l = house.length / 2 + kEaves, w = house.width / 2 + kEaves;
  const double foot = house.height + 0.05, ridge = foot + slope * w;
  const Vec3 left = house.place(-(l - w), 0, ridge), right = house.place(l - w, 0, ridge);
  const std::array<Vec3, 4> eave{house.place(-l, -w, foot), house.place(l, -w, foot), house.place(l, w, foot),
                                 house.place(-l, w, foot)};
  const Vec3 o = facade.frame().origin;
  const auto local = [&](Vec3 p) {  // plates are given in the coordinates of the facade
    return Vec3{dot(p - o, facade.frame().along), dot(p - o, facade.frame().out), p.z};
  };
  const auto add = [&](const std::vector<Vec3>& ring) {
    std::vector<Vec3> own;
    for (Vec3 p : ring) own.push_back(local(p));
    facade.plate(own, finish(BuildingClass::roof, Material::tile));
    building.faces.push_back(facade.scene().planes.back().id);
  };
  add({eave[0], eave[1], right, left});
  add({eave[1], eave[2], right});
  add({eave[2], eave[3], left, right});
  add({eave[3], eave[0], left});
  const Finish boards = finish(BuildingClass::other, Material::wood);
  facade.plate({local(eave[3]), local(eave[2]), local(eave[1]), local(eave[0])}, boards);
  for (double along : {-0.3, 0.32}) {
    const Vec3 at = house.place(along * house.length, 0.8, ridge - 1.4);
    const std::array ring{at, at + house.place(1.1, 0, 0), at + house.place(1.1, 0.6, 0), at + house.place(0, 0.6, 0)};
    facade.add(prism(ring, 2.4 * kUp, facade.surface(finish(BuildingClass::other, Material::brick))));
  }
  return ridge;
}

void add_stations(TerrestrialScan& scan, const House& house, double distance, double step) {
  const double l = house.length / 2 + distance, w = house.width / 2 + distance, eye = 1.65;
  const double corner_l = house.length / 2 + 0.8 * distance, corner_w = house.width / 2 + 0.8 * distance;
  const std::array<Vec3, 6> eyes{house.place(-0.15 * l, -w - distance, eye), house.place(corner_l, -corner_w, eye),
                                 house.place(corner_l, corner_w, eye),       house.place(0.1 * l, w + distance, eye),
                                 house.place(-corner_l, corner_w, eye),      house.place(-corner_l, -corner_w, eye)};
  for (std::size_t i = 0; i < eyes.size(); ++i)
    scan.scene.stations.push_back(station_towards(static_cast<std::uint16_t>(i + 1), eyes[i], scan.scene.keep, step));
}

}  // namespace

std::span<const SceneOption> building_options() {
  return kOptions;
}

TerrestrialScan plan_building(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan = empty_scan(values, seed);
  scan.scene.classes = {{0, "mixed"}, {1, "facade"}, {2, "sill"},   {3, "lintel"}, {4, "reveal"},
                        {5, "bulge"}, {6, "roof"},   {7, "ground"}, {8, "other"}};
  const House house(values);
  Rng rng(seed, 0x6275696c64ull);
  std::vector<FacadeBuilder> facades;
  std::vector<std::vector<Opening>> taken;
  for (int side = 0; side < 4; ++side) {
    facades.emplace_back(scan.scene, house.frame(side), side + 1);
    taken.push_back(add_facade(facades.back(), house.facade_length(side), house.height, side, rng));
  }
  const auto bulges = static_cast<std::uint64_t>(values.get("scene.bulges"));
  const double low = values.get("scene.bulge_min"), high = std::max(low, values.get("scene.bulge_max"));
  for (std::uint64_t i = 0; i < bulges; ++i) {
    const std::size_t side = i % 4;
    const double rise =
        bulges > 1 ? low + (high - low) * static_cast<double>(i) / static_cast<double>(bulges - 1) : high;
    add_bulge(facades[side], taken[side], house.facade_length(static_cast<int>(side)), house.height, rise, rng);
  }
  TrueBuilding building{1, "hip", {}, {}, house.height, 0, 0};
  for (int side = 0; side < 4; ++side) building.footprint.push_back(house.frame(side).origin);
  building.ridge = add_roof(facades[0], house, building);
  scan.scene.buildings.push_back(building);

  const double strip = values.get("scene.ground"), far = 60;
  const double l = house.length, w = house.width;
  facades[0].plate({{-far, far, 0}, {l + far, far, 0}, {l + far, -w - far, 0}, {-far, -w - far, 0}},
                   finish(BuildingClass::ground, Material::grass));
  Box3<Vec3> box{house.frame(0).origin, house.frame(0).origin};
  for (int side = 0; side < 4; ++side) {
    const Vec3 p = house.frame(side).origin;
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), -0.1};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), building.ridge + 1.2};
  }
  scan.scene.keep = {box.min - Vec3{strip, strip, 0}, box.max + Vec3{strip, strip, 0}};
  add_stations(scan, house, values.get("scene.distance"), values.get("scene.step"));
  return scan;
}

}  // namespace ilot::scan
