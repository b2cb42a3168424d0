// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

constexpr double kWheel = 0.34;  // metres, radius of a 28 inch wheel with its tyre

// Adds the rim of a wheel as a polygon of rods, with a hub and four spokes: rays pass between them.
void add_open_wheel(ObjectShape& s, Vec3 hub, double radius) {
  constexpr std::array<FlatPoint, 8> kTurn{
      {{1, 0}, {.7071, .7071}, {0, 1}, {-.7071, .7071}, {-1, 0}, {-.7071, -.7071}, {0, -1}, {.7071, -.7071}}};
  const double rim = radius - 0.02;
  const auto at = [&](std::size_t i) { return hub + Vec3{rim * kTurn[i % 8].x, 0, rim * kTurn[i % 8].y}; };
  for (std::size_t i = 0; i < 8; ++i) s.rod(at(i), at(i + 1), 0.022, Material::iron);
  s.rod(hub - Vec3{0, 0.04, 0}, hub + Vec3{0, 0.04, 0}, 0.05, Material::iron);
  for (std::size_t i = 0; i < 2; ++i) s.rod(at(i), at(i + 4), 0.006, Material::zinc);
}

// Adds a bicycle at a place, leaning to the side by a share of its height.
void add_bicycle(ObjectShape& s, Rng& rng, Vec3 at, double lean) {
  const double reach = between(rng, 0.48, 0.56);
  const auto p = [&](double x, double y, double z) { return at + Vec3{x, y + lean * z, z}; };
  add_open_wheel(s, p(-reach, 0, kWheel), kWheel);
  add_open_wheel(s, p(reach, 0, kWheel), kWheel);
  s.rod(p(-reach, 0, kWheel), p(-0.05, 0, 0.3), 0.02, Material::car_paint);
  s.rod(p(-0.05, 0, 0.3), p(-0.2, 0, 0.88), 0.022, Material::car_paint);
  s.rod(p(-0.05, 0, 0.3), p(reach - 0.14, 0, 0.8), 0.025, Material::car_paint);
  s.rod(p(-0.17, 0, 0.74), p(reach - 0.14, 0, 0.84), 0.022, Material::car_paint);
  s.rod(p(reach, 0, kWheel), p(reach - 0.16, 0, 1.02), 0.02, Material::car_paint);
  s.rod(p(reach - 0.18, -0.28, 1.03), p(reach - 0.18, 0.28, 1.03), 0.018, Material::iron);
  s.box(p(-0.22, 0, 0.95), {0.26, 0.15, 0.07}, Material::iron);
  if (rng.uniform() < 0.4) s.box(p(-reach - 0.05, 0, 0.75), {0.4, 0.3, 0.22}, Material::iron);  // a basket
}

}  // namespace

void make_motorcycle(ObjectShape& s, Rng& rng) {
  s.solids = make_furniture("motorbike", rng).solids;
  for (const double y : {-0.38, 0.38}) s.box({0.4, y, 1.12}, {0.06, 0.14, 0.1}, Material::iron);
  if (rng.uniform() < 0.3) s.box({-0.85, 0, 0.98}, {0.4, 0.42, 0.32}, Material::iron);  // a top case
}

void make_moped(ObjectShape& s, Rng& rng) {
  const double reach = between(rng, 0.58, 0.68);
  for (const double x : {-reach, reach}) s.disc({x, 0, 0.24}, {0, 1, 0}, 0.11, 0.24, Material::iron);
  s.profile(std::array<FlatPoint, 5>{{{-0.85, 0.42}, {-0.2, 0.35}, {-0.1, 0.72}, {-0.3, 0.8}, {-0.9, 0.76}}}, 0.42,
            Material::car_paint);
  s.box({0.05, 0, 0.28}, {0.6, 0.38, 0.08}, Material::car_paint);
  s.profile(std::array<FlatPoint, 4>{{{0.32, 0.28}, {0.42, 0.28}, {0.36, 0.98}, {0.28, 0.98}}}, 0.4,
            Material::car_paint);
  s.rod({reach, 0, 0.24}, {0.32, 0, 1.02}, 0.045, Material::iron);
  s.rod({0.3, -0.34, 1.05}, {0.3, 0.34, 1.05}, 0.03, Material::iron);
  if (rng.uniform() < 0.3) s.box({0.36, 0, 1.25}, {0.03, 0.4, 0.4}, Material::glass);
}

void make_kick_scooter(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 1.0, 1.2);
  s.box({0, 0, 0.13}, {length - 0.35, 0.15, 0.06}, Material::iron);
  for (const double x : {-0.45, 0.45}) s.disc({x * length, 0, 0.12}, {0, 1, 0}, 0.05, 0.12, Material::iron);
  s.rod({0.43 * length, 0, 0.15}, {0.36 * length, 0, 1.12}, 0.022, Material::iron);
  s.rod({0.36 * length, -0.24, 1.13}, {0.36 * length, 0.24, 1.13}, 0.018, Material::iron);
}

void make_single_bicycle(ObjectShape& s, Rng& rng) {
  add_bicycle(s, rng, {0, 0, 0}, between(rng, -0.18, 0.18));
}

// Bicycles at hoops, 35 to 70 cm apart; some places are empty.
void make_bicycle_rack(ObjectShape& s, Rng& rng) {
  const auto places = 3 + rng.below(7);
  const double pitch = between(rng, 0.35, 0.7);
  bool any = false;
  for (std::uint64_t i = 0; i < places; ++i) {
    const double y = pitch * (static_cast<double>(i) - 0.5 * static_cast<double>(places - 1));
    for (const double x : {-0.3, 0.3}) s.rod({x, y, 0}, {x, y, 0.78}, 0.025, Material::zinc);
    s.rod({-0.3, y, 0.78}, {0.3, y, 0.78}, 0.025, Material::zinc);
    if (any && rng.uniform() < 0.3) continue;
    add_bicycle(s, rng, {between(rng, -0.2, 0.2), y + 0.06, 0}, between(rng, -0.08, 0.08));
    any = true;
  }
}

void make_cargo_bicycle(ObjectShape& s, Rng& rng) {
  add_bicycle(s, rng, {-0.55, 0, 0}, 0);
  s.profile(std::array<FlatPoint, 4>{{{0.2, 0.25}, {1.1, 0.25}, {1.25, 0.85}, {0.1, 0.85}}}, 0.65, Material::wood);
  add_open_wheel(s, {1.35, 0, 0.25}, 0.25);
}

void make_cyclist(ObjectShape& s, Rng& rng) {
  add_bicycle(s, rng, {0, 0, 0}, 0);
  s.rod({-0.22, 0, 0.98}, {0.12, 0, 1.48}, 0.15, Material::cloth);
  s.ball({0.2, 0, 1.66}, 0.12, Material::wood);
  for (const double side : {-1.0, 1.0}) {
    s.rod({0.1, side * 0.16, 1.42}, {0.36, side * 0.24, 1.06}, 0.045, Material::cloth);
    s.rod({-0.2, side * 0.09, 0.95}, {0.16, side * 0.1, 0.7 + 0.1 * side}, 0.075, Material::cloth);
    s.rod({0.16, side * 0.1, 0.7 + 0.1 * side}, {-0.02, side * 0.12, 0.28 + 0.12 * side}, 0.055, Material::cloth);
  }
}

}  // namespace ilot::scan
