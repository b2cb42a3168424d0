// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/facade_haussmann.h"

#include <array>
#include <cmath>
#include <vector>

#include "scan/facades/banded_wall.h"
#include "scan/facades/window.h"

namespace ilot::scan {
namespace {

constexpr std::array kOptions = with_beam_options(std::array{
    SceneOption{"scene.step", 0.0195, "deg", 0.002, 1, "angular step, horizontal and vertical; --points scales it"},
    SceneOption{"scene.bays", 7, "bays", 1, 21, "of 3 m each"},
    SceneOption{"scene.street", 13, "m", 5, 60, "from the facade to the two stations"},
    SceneOption{"scene.groove_depth", 0.02, "m", 0.005, 0.1, "of the grooves between the bands of stone"},
    SceneOption{"scene.groove_height", 0.035, "m", 0.005, 0.2, "of the grooves"},
    SceneOption{"scene.band", 0.42, "m", 0.2, 1, "from one groove to the next"},
    SceneOption{"scene.balcony", 0.8, "m", 0.3, 2, "how far the balconies project"},
});

constexpr double kBay = 3, kEnd = 0.7;  // width of a bay; width of the pilaster at each end
// Heights of the floors of the storeys, the cornice, the foot of the roof and its top.
constexpr double kMezzanine = 4.6, kNoble = 8.3, kThird = 12.1, kFourth = 15.3, kCornice = 18.2, kRoof = 18.95,
                 kRoofTop = 22.4;
constexpr double kRoofSetback = 0.15, kRoofLean = 0.36;  // `out` of the foot of the roof; lean per metre of height

std::uint8_t value(HaussmannClass c) {
  return static_cast<std::uint8_t>(c);
}

Finish finish(HaussmannClass surface_class, Material material, std::uint32_t element = 0) {
  return {value(surface_class), element, material};
}

Finish stone(HaussmannClass surface_class, std::uint32_t element = 0) {
  return finish(surface_class, Material::limestone, element);
}

WindowStyle window_style() {
  WindowStyle style;
  style.classes = {value(HaussmannClass::reveal), value(HaussmannClass::sill), value(HaussmannClass::surround),
                   value(HaussmannClass::other)};
  style.recess = 0.32;
  return style;
}

// The facade with its measures. There is one function for each storey.
class Front {
 public:
  Front(FacadeBuilder& facade, const SceneValues& values, Rng& rng)
      : facade_(facade),
        rng_(rng),
        bays_(static_cast<std::uint32_t>(values.get("scene.bays"))),
        width_(bays_ * kBay + 2 * kEnd),
        balcony_(values.get("scene.balcony")),
        bands_{values.get("scene.band"), values.get("scene.groove_height"), values.get("scene.groove_depth")} {}

  double width() const { return width_; }

  // Adds shops under round arches, with the carriage entrance in the middle.
  void ground_floor() {
    const std::vector<Opening> arches = openings(2.1, 0.1, 2.55, 1.05);
    add_banded_wall(facade_, 0, width_, 0, kMezzanine, arches, bands_, stone(HaussmannClass::facade),
                    finish(HaussmannClass::joint, Material::mortar));
    WindowStyle style = window_style();
    style.recess = 0.45;
    style.curtains = 0;
    for (std::uint32_t bay = 0; bay < bays_; ++bay) {
      const DoorKind kind = bay == bays_ / 2 ? DoorKind::door : DoorKind::shop;
      add_door(facade_, arches[bay], {1, bay + 1}, kind, style, rng_);
      keystone(middle(bay), top_of(arches[bay]));
    }
    band("band", kMezzanine - 0.05, 0.12, 0.3);
  }

  // Adds low windows under flat arches, in banded stone, with brick below them.
  void mezzanine() {
    const std::vector<Opening> windows = openings(1.25, 5.65, 7.35, 0.18);
    add_banded_wall(facade_, 0, width_, kMezzanine, kNoble, windows, bands_, stone(HaussmannClass::facade),
                    finish(HaussmannClass::joint, Material::mortar));
    WindowStyle style = window_style();
    style.sill_out = 0.07;
    for (std::uint32_t bay = 0; bay < bays_; ++bay) add_window(facade_, windows[bay], {2, bay + 1}, style, rng_);
  }

  // Adds tall windows with pediments behind a stone balcony.
  void noble_floor() {
    const std::vector<Opening> windows = openings(1.3, kNoble + 0.2, 11.0, 0);
    facade_.wall(0, width_, kNoble, kThird, 0, windows, stone(HaussmannClass::facade));
    WindowStyle style = window_style();
    style.panes_up = 4;
    style.surround_out = 0.06;
    style.surround_width = 0.2;
    for (std::uint32_t bay = 0; bay < bays_; ++bay) {
      add_window(facade_, windows[bay], {3, bay + 1}, style, rng_);
      pediment(middle(bay), 11.25);
    }
    const std::uint32_t element = balcony_element(kNoble - 0.1, kNoble + 1.15);
    slab_and_consoles(kNoble, element);
    balustrade(kNoble + 0.1, element);
  }

  // Adds windows with sills and iron railings, with brick panels between them.
  void third_floor() {
    const std::vector<Opening> windows = openings(1.2, kThird + 0.55, 14.5, 0);
    facade_.wall(0, width_, kThird, kFourth, 0, windows, stone(HaussmannClass::facade));
    WindowStyle style = window_style();
    style.sill_out = 0.1;
    style.surround_out = 0.05;
    style.lintel_out = 0;
    for (std::uint32_t bay = 0; bay < bays_; ++bay) {
      add_window(facade_, windows[bay], {4, bay + 1}, style, rng_);
      add_railing(facade_, windows[bay].left, windows[bay].right, 0.05, windows[bay].bottom, 0.9,
                  finish(HaussmannClass::balcony, Material::iron));
      facade_.block({middle(bay) - 0.5, middle(bay) + 0.5, -kOverlap, 0.02, kThird + 0.12, kThird + 0.4},
                    finish(HaussmannClass::moulding, Material::brick));
    }
    band("band", kThird - 0.12, 0.08, 0.2);
  }

  // Adds round-headed windows behind an iron balcony.
  void fourth_floor() {
    const std::vector<Opening> windows = openings(1.2, kFourth + 0.15, 16.7, 0.6);
    facade_.wall(0, width_, kFourth, kCornice, 0, windows, stone(HaussmannClass::facade));
    WindowStyle style = window_style();
    for (std::uint32_t bay = 0; bay < bays_; ++bay) {
      add_window(facade_, windows[bay], {5, bay + 1}, style, rng_);
      keystone(middle(bay), top_of(windows[bay]));
    }
    const std::uint32_t element = balcony_element(kFourth - 0.1, kFourth + 1.1);
    slab_and_consoles(kFourth, element);
    add_railing(facade_, 0.1, width_ - 0.1, balcony_ - 0.06, kFourth + 0.1, 1.0,
                finish(HaussmannClass::balcony, Material::iron, element));
  }

  void cornice() {
    const std::uint32_t element = strip_element("cornice", kCornice, kRoof, 0.55);
    const Finish moulding = stone(HaussmannClass::moulding, element);
    facade_.moulding({{0, kCornice}, {0.1, kCornice}, {0.16, kCornice + 0.25}, {0, kCornice + 0.25}}, 0, width_,
                     moulding);
    facade_.moulding({{0, kCornice + 0.25}, {0.3, kCornice + 0.45}, {0.55, kCornice + 0.55}, {0.55, kRoof}, {0, kRoof}},
                     0, width_, moulding);
    for (double x = 0.3; x < width_ - 0.3; x += 0.5)  // modillions
      facade_.block({x, x + 0.16, 0.14, 0.45, kCornice + 0.2, kCornice + 0.47}, moulding, Faces::unnamed);
  }

  void mansard() {
    facade_.plate({{0, roof_out(kRoof), kRoof},
                   {width_, roof_out(kRoof), kRoof},
                   {width_, roof_out(kRoofTop), kRoofTop},
                   {0, roof_out(kRoofTop), kRoofTop}},
                  finish(HaussmannClass::roof, Material::slate));
    facade_.moulding({{roof_out(kRoofTop) - 0.1, kRoofTop},
                      {roof_out(kRoofTop) + 0.12, kRoofTop},
                      {roof_out(kRoofTop) + 0.12, kRoofTop + 0.14},
                      {roof_out(kRoofTop) - 0.1, kRoofTop + 0.14}},
                     0, width_, finish(HaussmannClass::moulding, Material::zinc));
    FacadeFrame frame = facade_.frame();
    frame.origin = frame.place(0, -0.3, 0);
    FacadeBuilder dormers(facade_.scene(), frame, facade_.facade());
    for (std::uint32_t bay = 0; bay < bays_; ++bay) dormer(dormers, bay);
  }

  // Adds blocks of two alternating lengths at both ends.
  void quoins() {
    for (const bool left : {true, false}) {
      const std::uint32_t element = strip_element("quoins", kMezzanine, kCornice, 0.04);
      int course = 0;
      for (double z = kMezzanine + 0.3; z + bands_.pitch < kCornice; z += bands_.pitch, ++course) {
        if (z + bands_.pitch > kNoble - 0.35 && z < kNoble + 0.35) continue;  // space of the balconies
        if (z + bands_.pitch > kFourth - 0.35 && z < kFourth + 0.35) continue;
        const double length = course % 2 == 0 ? kEnd : 0.45;
        const double x0 = left ? 0 : width_ - length;
        facade_.block({x0, x0 + length, -kOverlap, 0.04, z, z + bands_.pitch - 0.02},
                      stone(HaussmannClass::moulding, element));
      }
    }
  }

 private:
  double middle(std::uint32_t bay) const { return kEnd + kBay * (bay + 0.5); }

  static double roof_out(double z) { return -kRoofSetback - kRoofLean * (z - kRoof); }

  std::vector<Opening> openings(double width, double bottom, double springing, double rise) const {
    std::vector<Opening> row;
    for (std::uint32_t bay = 0; bay < bays_; ++bay)
      row.push_back({middle(bay) - width / 2, middle(bay) + width / 2, bottom, springing, rise});
    return row;
  }

  std::uint32_t strip_element(const char* kind, double z0, double z1, double out) {
    TrueElement e;
    e.kind = kind;
    e.ring = facade_.outline({0, width_, z0, z1, 0}, out);
    e.width = width_;
    e.height = z1 - z0;
    e.depth = out;
    return facade_.add_element(e);
  }
  std::uint32_t balcony_element(double z0, double z1) { return strip_element("balcony", z0, z1, balcony_); }

  // Adds a band along the whole facade: a flat course under a sloping one.
  void band(const char* kind, double z, double out, double height) {
    const std::uint32_t element = strip_element(kind, z, z + height, out);
    facade_.moulding(
        {{-kOverlap, z}, {out * 0.6, z}, {out, z + 0.4 * height}, {out, z + height}, {-kOverlap, z + height}}, 0,
        width_, stone(HaussmannClass::moulding, element));
  }

  void keystone(double x, double crown) {
    facade_.relief(
        {{x - 0.1, crown - 0.02}, {x + 0.1, crown - 0.02}, {x + 0.16, crown + 0.36}, {x - 0.16, crown + 0.36}},
        -kOverlap, 0.07, stone(HaussmannClass::surround));
  }

  void pediment(double x, double z) {
    TrueElement e;
    e.kind = "pediment";
    e.ring = facade_.outline({x - 1, x + 1, z, z + 0.5, 0}, 0.2);
    e.width = 2;
    e.height = 0.5;
    e.depth = 0.2;
    const Finish carved = stone(HaussmannClass::surround, facade_.add_element(e));
    facade_.block({x - 1, x + 1, -kOverlap, 0.2, z, z + 0.12}, carved);
    facade_.relief({{x - 1, z + 0.12}, {x + 1, z + 0.12}, {x, z + 0.5}}, -kOverlap, 0.14, carved);
    for (const double side : {-1.0, 1.0})
      facade_.moulding({{-kOverlap, z - 0.35}, {0.05, z - 0.35}, {0.16, z}, {-kOverlap, z}}, x + side * 0.9 - 0.07,
                       x + side * 0.9 + 0.07, carved);
  }

  void slab_and_consoles(double z, std::uint32_t element) {
    const Finish slab = stone(HaussmannClass::balcony, element);
    facade_.block({0, width_, -kOverlap, balcony_, z - 0.1, z + 0.1}, slab);
    const double reach = 0.8 * balcony_;
    for (std::uint32_t i = 0; i <= 2 * bays_; ++i) {
      const double x = kEnd + 0.5 * kBay * i;
      const bool over_window = i % 2 == 1;
      if (over_window) continue;
      for (const double side : {-0.28, 0.28})
        facade_.moulding(
            {{-kOverlap, z - 0.75}, {0.12, z - 0.75}, {reach, z - 0.3}, {reach, z - 0.1}, {-kOverlap, z - 0.1}},
            x + side - 0.1, x + side + 0.1, slab);
    }
  }

  // Adds turned balusters between pedestals, under a handrail.
  void balustrade(double z, std::uint32_t element) {
    const Finish carved = stone(HaussmannClass::balcony, element);
    const double out = balcony_ - 0.12;
    facade_.block({0, width_, out - 0.1, out + 0.1, z, z + 0.12}, carved);
    facade_.block({0, width_, out - 0.11, out + 0.11, z + 0.88, z + 1.02}, carved);
    facade_.block({0, kEnd - 0.17, out - 0.1, out + 0.1, z + 0.12, z + 0.88}, carved);
    facade_.block({width_ - kEnd + 0.17, width_, out - 0.1, out + 0.1, z + 0.12, z + 0.88}, carved);
    for (std::uint32_t i = 0; i <= bays_; ++i) {
      const double x = kEnd + kBay * i;
      facade_.block({x - 0.17, x + 0.17, out - 0.1, out + 0.1, z + 0.12, z + 0.88}, carved);
      if (i == bays_) break;
      constexpr int kBalusters = 13;
      for (int b = 0; b < kBalusters; ++b)
        baluster(x + 0.17 + (kBay - 0.34) * (b + 0.5) / kBalusters, out, z + 0.12, carved);
    }
  }

  void baluster(double x, double out, double z, const Finish& carved) {
    const SurfaceId surface = facade_.surface(carved);
    const auto at = [&](double height) { return facade_.frame().place(x, out, z + height); };
    const Vec3 up{0, 0, 1};
    facade_.add(cylinder(at(0), up, 0.07, 0.06, surface));
    facade_.add(sphere(at(0.22), 0.075, surface));
    facade_.add(cone(at(1.3), -1.0 * up, 0.6, 1.06, 0.058, surface));  // from the widest part up to the neck
    facade_.add(cylinder(at(0.69), up, 0.07, 0.06, surface));
  }

  void dormer(FacadeBuilder& dormers, std::uint32_t bay) {
    const double x = middle(bay), half = 0.8, low = kRoof + 0.1, high = 21.25;
    const Opening window{x - 0.5, x + 0.5, low + 0.35, 20.45, 0.3};
    dormers.wall(x - half, x + half, low, high, 0, {window}, stone(HaussmannClass::surround));
    const double setback = 0.3;
    for (const double side : {-1.0, 1.0}) {
      const double at = x + side * half;
      std::vector<Vec3> cheek{
          {at, roof_out(low) + setback - 0.05, low}, {at, 0, low}, {at, 0, high}, {at, roof_out(high) + setback, high}};
      if (side < 0) cheek = {cheek[0], cheek[3], cheek[2], cheek[1]};
      dormers.plate(cheek, finish(HaussmannClass::roof, Material::zinc));
    }
    WindowStyle style = window_style();
    style.recess = 0.15;
    style.room_beside = 0.25;
    add_window(dormers, window, {6, bay + 1}, style, rng_);
    dormers.relief({{x - half - 0.1, high}, {x + half + 0.1, high}, {x, high + 0.45}}, -1.1, 0.1,
                   finish(HaussmannClass::roof, Material::zinc));
  }

  FacadeBuilder& facade_;
  Rng& rng_;
  std::uint32_t bays_;
  double width_, balcony_;
  Bands bands_;
};

}  // namespace

std::span<const SceneOption> facade_haussmann_options() {
  return kOptions;
}

TerrestrialScan plan_facade_haussmann(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan = empty_scan(values, seed);
  scan.scene.classes = {{0, "mixed"},    {1, "facade"},  {2, "joint"},    {3, "reveal"}, {4, "sill"},
                        {5, "surround"}, {6, "balcony"}, {7, "moulding"}, {8, "roof"},   {9, "other"}};
  FacadeBuilder facade(scan.scene, {}, 1);
  Rng rng(seed, 0x68617573736dull);
  Front front(facade, values, rng);
  front.ground_floor();
  front.mezzanine();
  front.noble_floor();
  front.third_floor();
  front.fourth_floor();
  front.cornice();
  front.mansard();
  front.quoins();
  const double width = front.width(), street = values.get("scene.street"), step = values.get("scene.step");
  // The party walls close the rooms at both ends.
  for (const double x : {0.0, width})
    facade.plate({{x, -6, 0}, {x, 0, 0}, {x, 0, kRoof}, {x, -6, kRoof}},
                 finish(HaussmannClass::other, Material::render), Faces::unnamed);
  const FacadeFrame& frame = facade.frame();
  const Vec3 back = frame.place(-0.05, -4.2, 0.02), front_end = frame.place(width + 0.05, 1.5, kRoofTop + 0.5);
  scan.scene.keep = {{back.x, front_end.y, back.z}, {front_end.x, back.y, front_end.z}};
  const Vec3 low = frame.place(0, values.get("scene.balcony"), 0), high = frame.place(width, -1.6, kRoofTop + 0.2);
  const Box3<Vec3> target{{low.x, low.y, low.z}, {high.x, high.y, high.z}};
  scan.scene.stations = {station_towards(1, frame.place(0.18 * width, street, 1.7), target, step),
                         station_towards(2, frame.place(0.85 * width, street + 1.5, 1.7), target, step)};
  return scan;
}

}  // namespace ilot::scan
