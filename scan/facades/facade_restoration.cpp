// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/facade_restoration.h"

#include <array>
#include <vector>

#include "scan/facades/window.h"

namespace ilot::scan {
namespace {

constexpr std::array kOptions = with_beam_options(std::array{
    SceneOption{"scene.step", 0.0481, "deg", 0.002, 1, "angular step, horizontal and vertical; --points scales it"},
    SceneOption{"scene.station_left", 5, "m", -40, 40, "how far the station stands to the left of the facade's end"},
    SceneOption{"scene.station_out", 13, "m", 3, 100, "how far it stands before the facade"},
    SceneOption{"scene.sill_out", 0.09, "m", 0.01, 0.5, "how far the sills project"},
    SceneOption{"scene.recess", 0.28, "m", 0.05, 1, "of the windows behind the facade"},
    SceneOption{"scene.return_right", 0.7, "m", 0.05, 5, "how far the right neighbour stands out"},
    SceneOption{"scene.return_left", 0.95, "m", 0.05, 5, "how far the left neighbour stands back"},
    SceneOption{"scene.obstacles", 1, "share", 0, 1, "of cars, posts and walkers in the street that throw shadows"},
});

// Heights and the grid of windows, in metres.
constexpr std::uint32_t kColumns = 5;
constexpr double kPitch = 2.9, kMargin = 0.3, kWidth = kColumns * kPitch + 2 * kMargin;
constexpr double kWindowWidth = 1.15, kGroundTop = 3.8, kCornice = 13.1, kRoofFoot = 13.45, kRoofTop = 14.35;
constexpr std::array<std::array<double, 2>, 3> kRows{{{4.45, 6.85}, {8.0, 9.95}, {10.9, 12.45}}};  // bottom, top

Finish finish(RestorationClass surface_class, Material material, std::uint32_t element = 0) {
  return {static_cast<std::uint8_t>(surface_class), element, material};
}

double middle_of_column(std::uint32_t column) {
  return kMargin + kPitch * (column + 0.5);
}

WindowStyle window_style(const SceneValues& values, std::uint32_t row) {
  WindowStyle style;
  style.classes = {static_cast<std::uint8_t>(RestorationClass::wall), static_cast<std::uint8_t>(RestorationClass::sill),
                   static_cast<std::uint8_t>(RestorationClass::other),
                   static_cast<std::uint8_t>(RestorationClass::other)};
  style.wall = Material::render;
  style.recess = values.get("scene.recess");
  style.panes_up = row == 0 ? 4 : 3;
  if (row == 0)
    style.railing = 0.85;  // tall windows on the main floor
  else
    style.sill_out = values.get("scene.sill_out");
  style.sill_height = 0.145;
  return style;
}

// Adds the upper floors: one wall with fifteen windows.
void add_floors(FacadeBuilder& facade, const SceneValues& values, Rng& rng) {
  std::vector<Opening> openings;
  for (const auto& [bottom, top] : kRows)
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const double x = middle_of_column(column);
      openings.push_back({x - kWindowWidth / 2, x + kWindowWidth / 2, bottom, top, 0});
    }
  facade.wall(0, kWidth, kGroundTop, kCornice, 0, openings, finish(RestorationClass::facade, Material::render));
  for (std::uint32_t i = 0; i < openings.size(); ++i) {
    const std::uint32_t row = i / kColumns;
    add_window(facade, openings[i], {row + 1, i % kColumns + 1}, window_style(values, row), rng);
  }
}

// Adds shops and the entrance, covered with stone.
void add_ground_floor(FacadeBuilder& facade, const SceneValues& values, Rng& rng) {
  const std::vector<Opening> openings{
      {1.1, 3.1, 0.05, 2.8, 0}, {4.8, 6.9, 0.05, 2.8, 0}, {8.9, 10.2, 0.05, 2.7, 0}, {11.6, 13.8, 0.05, 2.8, 0}};
  facade.wall(0, kWidth, 0, kGroundTop, 0, openings, finish(RestorationClass::facade, Material::limestone));
  WindowStyle style = window_style(values, 1);
  style.wall = Material::limestone;
  style.curtains = 0;
  for (std::uint32_t i = 0; i < openings.size(); ++i)
    add_door(facade, openings[i], {0, i + 1}, i == 2 ? DoorKind::door : DoorKind::shop, style, rng);
}

std::uint32_t band_element(FacadeBuilder& facade, const char* kind, double z0, double z1, double out) {
  TrueElement band;
  band.kind = kind;
  band.ring = facade.outline({0, kWidth, z0, z1, 0}, out);
  band.width = kWidth;
  band.height = z1 - z0;
  band.depth = out;
  return facade.add_element(band);
}

void add_mouldings_and_roof(FacadeBuilder& facade) {
  const auto other = [](Material m, std::uint32_t element) { return finish(RestorationClass::other, m, element); };
  const std::uint32_t band = band_element(facade, "band", kGroundTop, kGroundTop + 0.15, 0.06);
  facade.block({0, kWidth, -kOverlap, 0.06, kGroundTop, kGroundTop + 0.15}, other(Material::limestone, band));
  const std::uint32_t cornice = band_element(facade, "cornice", kCornice, kRoofFoot, 0.2);
  facade.moulding({{0, kCornice}, {0.08, kCornice}, {0.2, kCornice + 0.2}, {0.2, kRoofFoot}, {0, kRoofFoot}}, 0, kWidth,
                  other(Material::limestone, cornice));
  facade.plate({{0, -0.1, kRoofFoot}, {kWidth, -0.1, kRoofFoot}, {kWidth, -0.5, kRoofTop}, {0, -0.5, kRoofTop}},
               other(Material::zinc, 0));
  facade.post(kWidth - 0.3, 0.07, 0.1, kCornice, 0.05, other(Material::zinc, 0));  // rain pipe
}

// The neighbouring house at the right end projects farther and the one at the left end is set back, so that a wall is
// visible at both ends.
void add_returns(FacadeBuilder& facade, const SceneValues& values) {
  const Finish wall = finish(RestorationClass::wall, Material::render);
  const double right = values.get("scene.return_right"), left = -values.get("scene.return_left");
  facade.plate({{kWidth, 0, 0}, {kWidth, 0, kCornice}, {kWidth, right, kCornice}, {kWidth, right, 0}}, wall);
  facade.plate({{0, left, 0}, {0, 0, 0}, {0, 0, kRoofFoot}, {0, left, kRoofFoot}}, wall);
  // The fronts of the neighbours. They are removed after the scan.
  const double far = 12, top = kRoofTop + 3;
  facade.plate({{-far, left, 0}, {0, left, 0}, {0, left, top}, {-far, left, top}}, wall, Faces::unnamed);
  facade.plate({{kWidth, right, 0}, {kWidth + far, right, 0}, {kWidth + far, right, top}, {kWidth, right, top}}, wall,
               Faces::unnamed);
}

// Adds objects in the street between the station and the ground floor. They are removed after the scan, but their laser
// shadows remain.
void add_obstacles(FacadeBuilder& facade, double share) {
  const Finish van = finish(RestorationClass::other, Material::car_paint);
  const auto place = [&](double at) { return at < share; };
  if (place(0.1)) facade.block({3.4, 7.4, 2.4, 4.1, 0.2, 1.45}, van, Faces::unnamed);
  if (place(0.2)) facade.block({8.2, 11.6, 3.2, 5.0, 0.25, 2.1}, van, Faces::unnamed);
  if (place(0.3)) facade.post(8.3, 3.2, 0, 5.5, 0.07, finish(RestorationClass::other, Material::iron));
  if (place(0.5)) facade.post(7.2, 2.2, 0, 1.7, 0.22, finish(RestorationClass::other, Material::cloth));
  if (place(0.7)) facade.post(10.9, 2.6, 0, 1.75, 0.24, finish(RestorationClass::other, Material::cloth));
  if (place(0.9)) facade.post(13.0, 3.2, 0, 4.5, 0.06, finish(RestorationClass::other, Material::iron));
}

}  // namespace

std::span<const SceneOption> facade_restoration_options() {
  return kOptions;
}

TerrestrialScan plan_facade_restoration(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan = empty_scan(values, seed);
  scan.scene.classes = {{0, "mixed"}, {1, "facade"}, {2, "sill"}, {3, "wall"}, {4, "other"}};
  FacadeBuilder facade(scan.scene, {}, 1);
  Rng rng(seed, 0x726573746full);
  add_floors(facade, values, rng);
  add_ground_floor(facade, values, rng);
  add_mouldings_and_roof(facade);
  add_returns(facade, values);
  add_obstacles(facade, values.get("scene.obstacles"));
  const FacadeFrame& frame = facade.frame();
  const Vec3 low = frame.place(0, -4.5, 0.02), high = frame.place(kWidth, 0.9, kRoofTop + 0.2);
  scan.scene.keep = {{low.x - 0.05, high.y, low.z}, {high.x + 0.05, low.y, high.z}};
  const Vec3 eye = frame.place(-values.get("scene.station_left"), values.get("scene.station_out"), 1.65);
  const Vec3 front_low = frame.place(0, 0.5, 0), front_high = frame.place(kWidth, -1, kRoofTop);
  const Box3<Vec3> target{{front_low.x, front_low.y, front_low.z}, {front_high.x, front_high.y, front_high.z}};
  scan.scene.stations = {station_towards(1, eye, target, values.get("scene.step"))};
  return scan;
}

}  // namespace ilot::scan
