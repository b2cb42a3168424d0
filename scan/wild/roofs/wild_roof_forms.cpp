// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/roofs/wild_roof_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan/roofs/roof_styles.h"
#include "scan/roofs/roof_wings.h"

namespace ilot::scan {
namespace {

Integer whole(Rng& rng, Integer from, Integer to, Integer step) {
  return from + step * static_cast<Integer>(rng.below(static_cast<std::uint64_t>((to - from) / step + 1)));
}

// Returns the plane that touches a sphere or, where one slope is 0 in all of them, a cylinder of this radius from
// above.
RoofPlane tangent_plane(double u, double v, double z, double radius, Integer a, Integer b) {
  const double unit = static_cast<double>(kSlopeUnit);
  const double length = std::sqrt(unit * unit + static_cast<double>(a * a + b * b));
  const double c = unit * z + radius * length - static_cast<double>(a) * u - static_cast<double>(b) * v;
  return {a, b, static_cast<Integer>(std::ceil(c))};
}

GridRect around(Integer u, Integer v, Integer half_u, Integer half_v) {
  return {u - half_u, v - half_v, u + half_u, v + half_v};
}

WildRoof usual(Rng& rng, RoofKind kind, BuiltForm built_form) {
  RoofDesign design = draw_roof(rng, kind, built_form, 0);
  return {name_of(kind), "houses", std::move(design.wings), {}, {}, 0};
}
WildRoof gable(Rng& rng) {
  return usual(rng, RoofKind::gable, BuiltForm::detached);
}
WildRoof hip(Rng& rng) {
  return usual(rng, RoofKind::hip, BuiltForm::detached);
}
WildRoof complex(Rng& rng) {
  return usual(rng, RoofKind::complex, BuiltForm::detached);
}

WildRoof flat_house(Rng& rng) {
  const GridRect rect{0, 0, whole(rng, 6000, 24000, 500), whole(rng, 6000, 16000, 500)};
  return {"flat", "houses", {flat_wing(rect, whole(rng, 2600, 15000, 100))}, {}, {}, 0};
}

WildRoof shed_house(Rng& rng) {
  const GridRect rect{0, 0, whole(rng, 5000, 14000, 500), whole(rng, 4000, 10000, 500)};
  return {"shed", "houses", {shed_wing(rect, whole(rng, 2400, 7000, 100), whole(rng, 1, 9, 1), Uphill::north)},
          {},     {},       0};
}

// A garden shed or garage: 4 to 20 m2.
WildRoof hut(Rng& rng) {
  const GridRect rect{0, 0, whole(rng, 2000, 6000, 100), whole(rng, 1800, 3500, 100)};
  const Integer eave = whole(rng, 1800, 2600, 50);
  const Wing wing = rng.uniform() < 0.5 ? flat_wing(rect, eave) : gable_wing(rect, Axis::u, eave, whole(rng, 3, 9, 1));
  return {"hut", "houses", {wing}, {}, {}, 0};
}

// A nave, a choir and a tower under a spire with four or eight sides.
WildRoof church(Rng& rng) {
  const Integer length = whole(rng, 14000, 36000, 500), width = whole(rng, 8000, 16000, 500);
  const Integer eave = whole(rng, 5000, 11000, 250), slope = whole(rng, 14, 26, 1);
  WildRoof roof{"spire", "spires", {gable_wing({0, 0, length, width}, Axis::u, eave, slope)}, {}, {}, 0};
  if (rng.uniform() < 0.6) {
    const GridRect arm{length / 2, -3000, length / 2 + whole(rng, 5000, 8000, 500), width + 3000};
    roof.wings.push_back(gable_wing(arm, Axis::v, eave - 250, slope));
  }
  const Integer half = whole(rng, 1600, 3600, 100), top = eave + whole(rng, 4000, 12000, 500);
  const GridRect tower = around(-half + 800, width / 2 + whole(rng, -1000, 1000, 500), half, half);
  const Integer u = (tower.u0 + tower.u1) / 2, v = (tower.v0 + tower.v1) / 2, steep = whole(rng, 30, 90, 2);
  roof.wings.push_back(flat_wing(tower, top));
  Wing spire{around(u, v, half, half), {}};
  const Integer apex = top + steep * half / kSlopeUnit;
  for (const auto& [a, b] : {std::pair<Integer, Integer>{steep, 0}, {-steep, 0}, {0, steep}, {0, -steep}})
    spire.planes.push_back({a, b, kSlopeUnit * apex - a * u - b * v});
  if (rng.uniform() < 0.6) {
    const Integer diagonal = steep * 7 / 10;
    for (const auto& [a, b] : {std::pair<Integer, Integer>{diagonal, diagonal},
                               {-diagonal, diagonal},
                               {diagonal, -diagonal},
                               {-diagonal, -diagonal}})
      spire.planes.push_back({a, b, kSlopeUnit * apex - a * u - b * v});
  }
  roof.wings.push_back(std::move(spire));
  return roof;
}

// A dome on a square hall.
WildRoof dome(Rng& rng) {
  const Integer half = whole(rng, 3500, 9000, 250), eave = whole(rng, 4000, 11000, 250);
  const Integer drum = half - whole(rng, 300, 1500, 100);
  const double radius = static_cast<double>(drum) * (1.0 + (1.35 - 1.0) * rng.uniform());
  const double low = static_cast<double>(eave) - std::sqrt(radius * radius - static_cast<double>(drum * drum)) + 300;
  WildRoof roof{"dome", "domes", {flat_wing(around(0, 0, half, half), eave)}, {}, {}, 0};
  Wing cap{around(0, 0, drum, drum), {tangent_plane(0, 0, low, radius, 0, 0)}};
  for (const Integer steep : {5, 13, 34})
    for (const auto& [x, y] : {std::pair<double, double>{1, 0},
                               {0.7071, 0.7071},
                               {0, 1},
                               {-0.7071, 0.7071},
                               {-1, 0},
                               {-0.7071, -0.7071},
                               {0, -1},
                               {0.7071, -0.7071}}) {
      const Integer a = -std::lround(x * static_cast<double>(steep)), b = -std::lround(y * static_cast<double>(steep));
      cap.planes.push_back(tangent_plane(0, 0, low, radius, a, b));
    }
  roof.curved.push_back({1, {Quadric::Kind::sphere, {0, 0, 0.001 * low}, {0, 0, 1}, 0.001 * radius, 0}});
  roof.wings.push_back(std::move(cap));
  return roof;
}

// One to four barrel vaults beside each other.
WildRoof barrels(Rng& rng) {
  const Integer length = whole(rng, 12000, 45000, 500), half = whole(rng, 2500, 9000, 250);
  const Integer eave = whole(rng, 2800, 8000, 100);
  const auto count = 1 + rng.below(4);
  const double radius = static_cast<double>(half) * (1.02 + (1.8 - 1.02) * rng.uniform());
  const double low = static_cast<double>(eave) - std::sqrt(radius * radius - static_cast<double>(half * half));
  WildRoof roof{"barrel", "barrels", {}, {}, {}, 0};
  for (std::uint64_t i = 0; i < count; ++i) {
    const Integer middle = static_cast<Integer>(2 * i + 1) * half;
    Wing vault{{0, middle - half, length, middle + half},
               {tangent_plane(0, static_cast<double>(middle), low, radius, 0, 0)}};
    for (const Integer steep : {4, 9, 16, 32})
      for (const Integer side : {-1, 1})
        if (static_cast<double>(steep) * radius <
            1.15 * std::sqrt(256.0 + static_cast<double>(steep * steep)) * static_cast<double>(half))
          vault.planes.push_back(tangent_plane(0, static_cast<double>(middle), low, radius, 0, side * steep));
    roof.curved.push_back({roof.wings.size(),
                           {Quadric::Kind::cylinder,
                            {0, 0.001 * static_cast<double>(middle), 0.001 * low},
                            {1, 0, 0},
                            0.001 * radius,
                            0}});
    roof.wings.push_back(std::move(vault));
  }
  return roof;
}

// Pyramids of cloth on masts.
WildRoof tents(Rng& rng) {
  const auto columns = 1 + rng.below(3), rows = 1 + rng.below(2);
  const Integer side = whole(rng, 4000, 14000, 500), eave = whole(rng, 2300, 4500, 100), slope = whole(rng, 7, 18, 1);
  WildRoof roof{"tent", "tents", {}, {}, {}, 0};
  for (std::uint64_t c = 0; c < columns; ++c)
    for (std::uint64_t r = 0; r < rows; ++r) {
      const Integer u = static_cast<Integer>(c) * side, v = static_cast<Integer>(r) * side;
      roof.wings.push_back(hip_wing({u, v, u + side, v + side}, eave, slope, slope));
    }
  return roof;
}

// A hall whose roof has three to nine teeth.
WildRoof saw_tooth(Rng& rng) {
  const auto teeth = 3 + rng.below(7);
  const Integer pitch = whole(rng, 4000, 9000, 500), depth = whole(rng, 12000, 45000, 500);
  const Integer eave = whole(rng, 4000, 7500, 250), slope = whole(rng, 5, 12, 1);
  WildRoof roof{"saw_tooth", "saw_teeth", {}, {}, {}, 0};
  for (std::uint64_t i = 0; i < teeth; ++i) {
    const Integer u = static_cast<Integer>(i) * pitch;
    roof.wings.push_back(shed_wing({u, 0, u + pitch, depth}, eave, slope, Uphill::east));
  }
  return roof;
}

// A block whose upper storeys stand back, with terraces on the lower ones.
WildRoof terraces(Rng& rng) {
  GridRect rect{0, 0, whole(rng, 10000, 30000, 500), whole(rng, 9000, 16000, 500)};
  Integer height = whole(rng, 3000, 12000, 250);
  WildRoof roof{"terraces", "terraces", {flat_wing(rect, height)}, {}, {}, 0};
  const auto levels = 1 + rng.below(3);
  for (std::uint64_t i = 0; i < levels; ++i) {
    rect.u0 += whole(rng, 0, 3000, 250), rect.u1 -= whole(rng, 500, 3000, 250), rect.v1 -= whole(rng, 500, 2500, 250);
    if (rect.u1 - rect.u0 < 3000 || rect.v1 - rect.v0 < 3000) break;
    height += whole(rng, 2700, 3300, 100);
    roof.wings.push_back(flat_wing(rect, height));
  }
  return roof;
}

// A wide hall with skylights; some are 50 m long.
WildRoof hall(Rng& rng) {
  const GridRect rect{0, 0, whole(rng, 20000, 60000, 1000), whole(rng, 14000, 40000, 1000)};
  const Integer eave = whole(rng, 4000, 11000, 250);
  const bool flat = rng.uniform() < 0.6;
  WildRoof roof{"hall", "halls", {flat ? flat_wing(rect, eave) : gable_wing(rect, Axis::u, eave, whole(rng, 1, 4, 1))},
                {},     {},      0};
  const auto lights = rng.below(7);
  for (std::uint64_t i = 0; i < lights; ++i) {
    const Integer u = whole(rng, 2000, rect.u1 - 5000, 500), v = whole(rng, 2000, rect.v1 - 6000, 500);
    const GridRect light{u, v, u + whole(rng, 1000, 3000, 500), v + whole(rng, 1000, 4000, 500)};
    const auto base = static_cast<Integer>(height_mm(roof.wings[0], static_cast<double>(u), static_cast<double>(v)));
    roof.wings.push_back(flat_wing(light, base + whole(rng, 500, 1800, 100)));
  }
  return roof;
}

// A block around a court under glass, or a canopy of glass before a hall.
WildRoof atrium(Rng& rng) {
  const Integer length = whole(rng, 18000, 40000, 500), depth = whole(rng, 16000, 30000, 500),
                eave = whole(rng, 6000, 15000, 250);
  WildRoof roof{"atrium", "glass", {flat_wing({0, 0, length, depth}, eave)}, {}, {}, 0};
  const Integer edge = whole(rng, 4000, 6500, 250);
  const GridRect court{edge, edge, length - edge, depth - edge};
  roof.wings.push_back(gable_wing(court, Axis::u, eave + whole(rng, 200, 1200, 100), whole(rng, 2, 9, 1)));
  roof.glass.push_back(1);
  roof.below = whole(rng, 0, 4000, 500);
  return roof;
}

WildRoof canopy(Rng& rng) {
  const Integer length = whole(rng, 8000, 30000, 500), depth = whole(rng, 7000, 16000, 500),
                eave = whole(rng, 4000, 10000, 250);
  WildRoof roof{"canopy", "glass", {flat_wing({0, 0, length, depth}, eave)}, {}, {}, 0};
  const Integer reach = whole(rng, 2500, 7000, 250);
  roof.wings.push_back(
      shed_wing({0, -reach, length, 0}, whole(rng, 2300, 3400, 100), whole(rng, 0, 3, 1), Uphill::north));
  roof.glass.push_back(1);
  roof.below = 20;
  return roof;
}

}  // namespace

std::span<const WildRoofForm> wild_roof_forms() {
  static const std::array kForms{WildRoofForm{"gable", "houses", 4, gable},
                                 WildRoofForm{"hip", "houses", 1.5, hip},
                                 WildRoofForm{"complex", "houses", 4, complex},
                                 WildRoofForm{"flat", "houses", 2, flat_house},
                                 WildRoofForm{"shed", "houses", 0.8, shed_house},
                                 WildRoofForm{"hut", "houses", 3, hut},
                                 WildRoofForm{"church", "spires", 0.5, church},
                                 WildRoofForm{"dome", "domes", 0.4, dome},
                                 WildRoofForm{"barrel", "barrels", 0.6, barrels},
                                 WildRoofForm{"tent", "tents", 0.6, tents},
                                 WildRoofForm{"saw_tooth", "saw_teeth", 0.5, saw_tooth},
                                 WildRoofForm{"terraces", "terraces", 1, terraces},
                                 WildRoofForm{"hall", "halls", 0.8, hall},
                                 WildRoofForm{"atrium", "glass", 0.4, atrium},
                                 WildRoofForm{"canopy", "glass", 0.5, canopy}};
  return kForms;
}

}  // namespace ilot::scan
