// SPDX-License-Identifier: Apache-2.0
// The roof of a wild house as it is seen from the street, and the sides of the house.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/optics/exact_math.h"
#include "scan/wild/facade/wild_front.h"

namespace ilot::scan {
namespace {

// Heights and places of the slope towards the street: from (eave_out, eave) back to (-run, eave + rise).
struct Slope {
  double out = 0, foot = 0, run = 0, rise = 0;
};

Slope slope_of(Draws& draws, const WildFront& front) {
  const std::uint64_t house = front.plot.house;
  const double pitch = draws.number("roof_pitch", house), eaves = draws.number("eaves", house);
  Slope s{eaves, front.eave() + 0.1, front.depth / 2, tan_deg(pitch) * (front.depth / 2 + eaves)};
  if (draws.is("roof_form", "mansard", house)) s = {0.05, front.eave() + 0.1, 1.1, 2.6};
  if (draws.is("roof_form", "flat", house)) s = {0.02, front.eave() + 0.05, 0.25, 0.5};  // a parapet
  s.rise = std::min(s.rise, 7.0);
  return s;
}

// A box on the slope, from its front at `out` back into the roof.
void box_on_roof(FacadeBuilder& facade, const Block& b, const Finish& finish) {
  facade.block(b, finish, Faces::unnamed);
}

void add_dormers(FacadeBuilder& facade, Draws& draws, const WildFront& front, const Slope& slope) {
  if (draws.is("roof_form", "flat", front.plot.house) || slope.rise < 1.6) return;
  const int dormers = std::min(draws.whole("dormers", front.plot.house), static_cast<int>(front.plot.width / 2.5));
  Rng rng = draws.random("dormers", front.plot.house);
  for (int i = 0; i < dormers; ++i) {
    const double x = front.plot.width * (i + 0.5) / dormers, half = 0.45 + 0.3 * rng.uniform();
    const double z = slope.foot + 0.35 + 0.2 * rng.uniform(), high = 1 + 0.3 * rng.uniform();
    const double out = slope.out - (slope.run + slope.out) * (z - slope.foot) / slope.rise;
    const std::uint32_t id = add_thing(facade, "dormer", {x - half, x + half, 0, out, z, z + high});
    box_on_roof(facade, {x - half, x + half, -slope.run, out, z - 0.3, z + high},
                wild_finish(WildClass::roof, Material::zinc, id, front.tone));
    facade.wall(x - half + 0.1, x + half - 0.1, z + 0.1, z + high - 0.1, out + 0.005, {},
                wild_finish(WildClass::other, Material::glass, id));
  }
}

void add_chimneys(FacadeBuilder& facade, Draws& draws, const WildFront& front, const Slope& slope) {
  const int chimneys = draws.whole("chimneys", front.plot.house);
  Rng rng = draws.random("chimneys", front.plot.house);
  for (int i = 0; i < chimneys; ++i) {
    const double x = 0.2 + (front.plot.width - 1.4) * rng.uniform(), back = -slope.run * (0.4 + 0.5 * rng.uniform());
    const double wide = 0.4 + 0.7 * rng.uniform(), top = slope.foot + slope.rise + 0.4 + rng.uniform();
    box_on_roof(
        facade, {x, x + wide, back - 0.5, back, front.eave() - 0.5, top},
        wild_finish(WildClass::roof, Material::brick,
                    add_thing(facade, "chimney", {x, x + wide, back - 0.5, back, front.eave(), top}), front.tone));
  }
}

// The sides are seen above and before lower or receding neighbours.
void add_sides(FacadeBuilder& facade, const WildFront& front, const Slope& slope) {
  const Finish side = wild_finish(WildClass::wall, Material::render, 0, front.tone);
  const double back = -front.depth, foot = front.foot(), top = front.eave();
  for (double x : {0.0, front.plot.width}) {
    facade.plate({{x, 0, foot}, {x, back, foot}, {x, back, top}, {x, 0, top}}, side, Faces::unnamed);
    facade.plate({{x, 0, top}, {x, back, top}, {x, -slope.run, slope.foot + slope.rise}}, side, Faces::unnamed);
  }
  if (front.plot.gate) return;
  facade.plate({{0, back, foot}, {front.plot.width, back, foot}, {front.plot.width, back, top}, {0, back, top}}, side,
               Faces::unnamed);
}

}  // namespace

void add_roof(FacadeBuilder& facade, Draws& draws, const WildFront& front) {
  const Slope slope = slope_of(draws, front);
  constexpr std::array kCovers{Material::tile, Material::slate, Material::zinc};
  const Material cover = kCovers[draws.random("cover", front.plot.house).below(kCovers.size())];
  const double width = front.plot.width, top = slope.foot + slope.rise;
  const Finish roof = wild_finish(WildClass::roof, cover, 0, front.tone);
  facade.plate(
      {{0, slope.out, slope.foot}, {width, slope.out, slope.foot}, {width, -slope.run, top}, {0, -slope.run, top}},
      roof);
  facade.plate({{0, -front.depth, front.eave()},
                {0, -slope.run, top},
                {width, -slope.run, top},
                {width, -front.depth, front.eave()}},
               roof, Faces::unnamed);
  // Boards below the eaves.
  facade.plate({{0, -0.2, front.eave()},
                {width, -0.2, front.eave()},
                {width, slope.out, slope.foot},
                {0, slope.out, slope.foot}},
               wild_finish(WildClass::moulding, Material::wood), Faces::unnamed);
  add_dormers(facade, draws, front, slope);
  add_chimneys(facade, draws, front, slope);
  add_sides(facade, front, slope);
}

}  // namespace ilot::scan
