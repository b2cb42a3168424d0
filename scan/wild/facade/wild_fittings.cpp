// SPDX-License-Identifier: Apache-2.0
// What is fixed to a wild front or stands before it: rain pipes, signs, awnings, cables, boxes, scaffolds, plants.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/optics/exact_math.h"
#include "scan/wild/facade/wild_front.h"

namespace ilot::scan {
namespace {

void rod(FacadeBuilder& facade, Vec3 from, Vec3 to, double radius, const Finish& finish) {
  const Vec3 a = facade.frame().place(from.x, from.y, from.z), way = facade.frame().place(to.x, to.y, to.z) - a;
  const double length = norm(way);
  if (length > 0.01) facade.add(cylinder(a, (1 / length) * way, length, radius, facade.surface(finish)));
}

void add_pipes(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const int pipes = draws.whole("downpipes", front.plot.house);
  if (pipes == 0) return;
  Rng rng = draws.random("downpipes", front.plot.house);
  const double cornice = draws.number("cornice", front.plot.house), top = front.eave();
  const std::array places{0.15, front.plot.width - 0.15, front.plot.width / 2};
  for (int i = 0; i < std::min(pipes, 3); ++i) {
    const double x = places[static_cast<std::size_t>(i)], radius = 0.03 + 0.03 * rng.uniform();
    const double out = radius + 0.02 + 0.05 * rng.uniform();
    const Finish zinc = wild_finish(WildClass::object, Material::zinc,
                                    add_thing(facade, "pipe", {x - radius, x + radius, 0, out + radius, 0, top}));
    rod(facade, {x, out, front.foot()}, {x, out, top - 0.3}, radius, zinc);
    rod(facade, {x, out, top - 0.3}, {x, cornice + 0.08, top + 0.02}, radius, zinc);
  }
  const Finish zinc =
      wild_finish(WildClass::object, Material::zinc,
                  add_thing(facade, "gutter", {0, front.plot.width, 0, cornice + 0.14, top, top + 0.12}));
  rod(facade, {0, cornice + 0.08, top + 0.06}, {front.plot.width, cornice + 0.08, top + 0.06}, 0.06, zinc);
}

void add_signs(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const int signs = draws.whole("signs", front.plot.house);
  for (int i = 0; i < signs; ++i) {
    Rng rng = draws.random("sign", element_index(front.plot.house, static_cast<std::uint64_t>(i)));
    const double high = front.floors[1], x = 0.3 + (front.plot.width - 0.6) * rng.uniform();
    const bool stands_out = rng.uniform() < 0.5;
    const double z = 0.65 * high + 0.4 * high * rng.uniform();
    Block b{x, x + 0.06, 0.08, 0.4 + 0.6 * rng.uniform(), z, z + 0.3 + 0.8 * rng.uniform()};
    if (!stands_out) {
      const double wide = std::min(0.5 + 2.5 * rng.uniform(), front.plot.width - x - 0.1);
      b = {x, x + std::max(0.2, wide), 0, 0.02 + 0.15 * rng.uniform(), z, z + 0.25 + 0.4 * rng.uniform()};
    }
    const auto tone = static_cast<std::uint8_t>(rng.below(256));
    facade.block(b, wild_finish(WildClass::object, Material::car_paint, add_thing(facade, "sign", b), tone),
                 Faces::unnamed);
    if (stands_out)
      rod(facade, {x + 0.03, 0, b.z1 - 0.05}, {x + 0.03, b.out1, b.z1 - 0.05}, 0.012,
          wild_finish(WildClass::object, Material::iron));
  }
}

void add_awnings(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  for (const WildOpening& o : front.openings) {
    if (o.use == WildUse::door || o.use == WildUse::arcade) continue;
    if (!draws.happens("awnings", o.element, front.plot.house)) continue;
    Rng rng = draws.random("awning", o.element);
    const double out = 0.3 + 1.2 * rng.uniform(), fall = 0.15 + 0.5 * rng.uniform(), z = top_of(o.hole) + 0.1;
    const double x0 = o.hole.left - 0.1, x1 = o.hole.right + 0.1;
    const Finish cloth = wild_finish(WildClass::object, Material::cloth,
                                     add_thing(facade, "awning", {x0, x1, 0, out, z - fall - 0.2, z}),
                                     static_cast<std::uint8_t>(rng.below(256)));
    facade.plate({{x0, out, z - fall}, {x1, out, z - fall}, {x1, 0, z}, {x0, 0, z}}, cloth, Faces::unnamed);
    facade.plate({{x0, out, z - fall - 0.2}, {x1, out, z - fall - 0.2}, {x1, out, z - fall}, {x0, out, z - fall}},
                 cloth, Faces::unnamed);
  }
}

void add_wall_cables(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const int cables = draws.whole("wall_cables", front.plot.house);
  for (int i = 0; i < cables; ++i) {
    Rng rng = draws.random("wall cable", element_index(front.plot.house, static_cast<std::uint64_t>(i)));
    const double radius = 0.004 + 0.012 * rng.uniform(), out = radius + 0.05 * rng.uniform();
    const bool upright = rng.uniform() < 0.3;
    const double x = front.plot.width * rng.uniform(),
                 z = front.floors[1] + (front.eave() - front.floors[1]) * rng.uniform();
    const Finish black = wild_finish(WildClass::object, Material::iron,
                                     add_thing(facade, "cable", {0, front.plot.width, 0, out, z - 0.05, z + 0.05}));
    constexpr int kPieces = 8;
    for (int k = 0; k < kPieces; ++k) {
      const double s0 = static_cast<double>(k) / kPieces, s1 = static_cast<double>(k + 1) / kPieces;
      const double sag0 = 0.1 * s0 * (1 - s0), sag1 = 0.1 * s1 * (1 - s1);
      if (upright)
        rod(facade, {x, out, s0 * front.eave()}, {x, out, s1 * front.eave()}, radius, black);
      else
        rod(facade, {s0 * front.plot.width, out, z - sag0}, {s1 * front.plot.width, out, z - sag1}, radius, black);
    }
  }
}

bool before_opening(const WildFront& front, const Block& b) {
  return std::any_of(front.openings.begin(), front.openings.end(), [&](const WildOpening& o) {
    return b.x1 > o.hole.left - 0.05 && b.x0 < o.hole.right + 0.05 && b.z1 > o.hole.bottom && b.z0 < top_of(o.hole);
  });
}

enum class Fixture { air_conditioner, box, lamp, dish };

Block draw_fixture(const WildFront& front, Fixture kind, Rng& rng) {
  const double x = 0.3 + (front.plot.width - 1) * rng.uniform(), z = 0.4 + (front.eave() - 1.2) * rng.uniform();
  const double across = rng.uniform(), up = rng.uniform(), out = rng.uniform();
  if (kind == Fixture::air_conditioner) return {x, x + 0.75, 0, 0.35, z, z + 0.55};
  const double depth = kind == Fixture::box ? 0.06 + 0.1 * out : 0.25 + 0.3 * out;
  return {x, x + 0.12 + 0.4 * across, 0, depth, z, z + 0.12 + 0.5 * up};
}

void add_fixture(FacadeBuilder& facade, Fixture kind, const Block& b, const Finish& finish) {
  const Vec3 head = facade.frame().place(b.x0, b.out1, b.z0);
  if (kind == Fixture::lamp) {
    rod(facade, {b.x0, 0, b.z0}, {b.x0, b.out1, b.z0 + 0.1}, 0.015, finish);
    facade.add(sphere(head, 0.12, facade.surface(finish)));
  } else if (kind == Fixture::dish) {
    const Vec3 way = facade.frame().place(b.x0 + 0.3, b.out1 + 1, b.z0 + 0.6) - head;
    facade.add(cylinder(head, (1 / norm(way)) * way, 0.04, 0.3, facade.surface(finish)));
    rod(facade, {b.x0, 0, b.z0}, {b.x0, b.out1, b.z0}, 0.02, finish);
  } else {
    facade.block(b, finish, Faces::unnamed);
  }
}

void add_fixtures(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const int things = draws.whole("fixtures", front.plot.house);
  for (int i = 0; i < things; ++i) {
    Rng rng = draws.random("fixture", element_index(front.plot.house, static_cast<std::uint64_t>(i)));
    const auto kind = static_cast<Fixture>(rng.below(4));
    Block b = draw_fixture(front, kind, rng);
    for (int attempt = 0; attempt < 6 && before_opening(front, b); ++attempt) b = draw_fixture(front, kind, rng);
    if (before_opening(front, b)) continue;
    const auto tone = static_cast<std::uint8_t>(rng.below(256));
    add_fixture(facade, kind, b, wild_finish(WildClass::object, Material::wood, add_thing(facade, "fixture", b), tone));
  }
}

// Standards two metres apart in two rows, ledgers and decks every two metres, a net before some of it.
void add_scaffold(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  if (!draws.is("scaffold", "scaffold", front.plot.house)) return;
  Rng rng = draws.random("scaffold", front.plot.house);
  const double width = front.plot.width, top = front.eave() * (0.5 + 0.5 * rng.uniform()), near = 0.25, far = 1;
  const Finish steel =
      wild_finish(WildClass::object, Material::zinc, add_thing(facade, "scaffold", {0, width, near, far, 0, top}));
  Finish boards = steel, net = steel;
  boards.material = Material::wood;
  net.material = Material::foliage;  // lets nearly half of the light through
  const int bays = std::max(1, static_cast<int>(std::lround(width / 2.2)));
  for (int i = 0; i <= bays; ++i)
    for (double out : {near, far})
      rod(facade, {width * i / bays, out, front.foot()}, {width * i / bays, out, top}, 0.024, steel);
  for (double z = 2; z <= top; z += 2) {
    for (double out : {near, far})
      for (double up : {0.0, 0.5, 1.0}) rod(facade, {0, out, z + up}, {width, out, z + up}, 0.024, steel);
    facade.block({0, width, near, far, z - 0.04, z}, boards, Faces::unnamed);
  }
  if (rng.uniform() < 0.4)
    facade.plate({{0, far + 0.05, 2}, {width / 2, far + 0.05, 2}, {width / 2, far + 0.05, top}, {0, far + 0.05, top}},
                 net, Faces::unnamed);
}

}  // namespace

void add_fittings(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  add_pipes(facade, draws, front);
  add_signs(facade, draws, front);
  add_awnings(facade, draws, front);
  add_wall_cables(facade, draws, front);
  add_fixtures(facade, draws, front);
  add_scaffold(facade, draws, front);
}

void add_leaves(FacadeBuilder& facade, const Block& box, Tuft shape, const Leaves& of, const Finish& finish, Rng& rng) {
  const double volume = (box.x1 - box.x0) * (box.out1 - box.out0) * (box.z1 - box.z0);
  const auto leaves = static_cast<std::uint64_t>(std::clamp(of.per_m3 * volume, 8.0, 1500.0));
  const SurfaceId surface = facade.surface(finish);
  for (std::uint64_t i = 0; i < leaves; ++i) {
    const double x = rng.uniform(), out = rng.uniform(), z = rng.uniform();
    const double dx = 2 * x - 1, dout = 2 * out - 1, dz = 2 * z - 1;
    if (shape == Tuft::round && dx * dx + dout * dout + dz * dz > 1) continue;
    const SinCos turn = sin_cos_deg(360 * rng.uniform() - 180), tilt = sin_cos_deg(160 * rng.uniform() - 80);
    const double s = of.size * (0.5 + rng.uniform());
    Panel leaf{facade.frame().place(box.x0 + (box.x1 - box.x0) * x, box.out0 + (box.out1 - box.out0) * out,
                                    box.z0 + (box.z1 - box.z0) * z),
               {turn.cos, turn.sin, 0},
               {-turn.sin * tilt.sin, turn.cos * tilt.sin, tilt.cos},
               {{-s, 0}, {0, -0.6 * s}, {s, 0}, {0, 0.6 * s}},
               {},
               surface};
    facade.add(std::move(leaf));
  }
}

// A plant is wide at its top and narrow at its foot; it covers wall and windows.
void add_climbing_plants(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const int plants = draws.whole("plants", front.plot.house);
  for (int i = 0; i < plants; ++i) {
    const std::uint64_t index = element_index(front.plot.house, static_cast<std::uint64_t>(i));
    Rng rng = draws.random("plant", index);
    const double area = draws.number("plant_area", index),
                 high = std::min(front.eave(), std::sqrt(area * (1 + 2 * rng.uniform())));
    const double wide = std::min(area / high, front.plot.width), x = (front.plot.width - wide) * rng.uniform();
    const double thick = 0.05 + 0.3 * rng.uniform();
    const Finish green = wild_finish(WildClass::vegetation, Material::foliage,
                                     add_thing(facade, "plant", {x, x + wide, 0, thick, 0, high}));
    constexpr int kTufts = 9;
    for (int k = 0; k < kTufts; ++k) {
      const double z = high * (k + 0.5) / kTufts,
                   spread = wide * (0.25 + 0.75 * z / high) * (0.6 + 0.4 * rng.uniform());
      const double left = x + (wide - spread) * rng.uniform();
      const Block tuft{left,
                       left + spread,
                       0.01,
                       thick * (0.5 + 0.5 * rng.uniform()),
                       z - 0.6 * high / kTufts,
                       z + 0.6 * high / kTufts};
      add_leaves(facade, tuft, Tuft::round, {700, 0.06}, green, rng);
    }
  }
}

}  // namespace ilot::scan
