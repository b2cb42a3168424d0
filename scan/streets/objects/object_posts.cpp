// SPDX-License-Identifier: Apache-2.0
// Lamps, traffic lights, signs and poles.
#include <array>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

void add_lights(ObjectShape& s, Vec3 top) {
  s.box(top - Vec3{0, 0, 0.45}, {0.22, 0.3, 0.9}, Material::iron);
  for (const double z : {-0.15, -0.45, -0.75}) s.rod(top + Vec3{0.1, 0, z}, top + Vec3{0.3, 0, z}, 0.1, Material::iron);
  s.box(top + Vec3{-0.12, 0, -0.45}, {0.02, 0.6, 1.15}, Material::iron);
}

// Adds a post with a lower edge of its plate at 2.0 to 2.6 m, as signs above pavements have. Returns that height.
double add_sign_post(ObjectShape& s, Rng& rng, double plate) {
  const double h = between(rng, 2.0, 2.6);
  s.rod({0, 0, 0}, {between(rng, -0.05, 0.05), between(rng, -0.05, 0.05), h + plate + 0.05}, 0.03, Material::zinc);
  return h;
}

}  // namespace

void make_any_lamppost(ObjectShape& s, Rng& rng) {
  const auto variants = variants_of(ArtefactClass::lamppost);
  s.solids = make_lamppost(variants[rng.below(variants.size())], rng).solids;
  if (rng.uniform() < 0.3) s.box({0, 0.25, between(rng, 2.2, 3)}, {0.04, 0.42, 0.6}, Material::white_target);
  if (rng.uniform() < 0.2) s.taper({0, 0, between(rng, 2.4, 3)}, 0.3, 0.28, 0.2, Material::iron);  // flower basket
}

// A lamp on a cable across the street, between two brackets at y = -5.6 and 5.6 m.
void make_hung_lamp(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 5.5, 8), sag = between(rng, 0.2, 0.6);
  for (const double side : {-1.0, 1.0}) s.rod({0, side * 9.5, h + sag}, {0, 0, h}, 0.012, Material::iron);
  s.taper({0, 0, h - 0.35}, 0.3, 0.3, 0.08, Material::zinc);
}

void make_bollard_light(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.7, 1.2);
  s.rod({0, 0, 0}, {0, 0, h - 0.25}, 0.07, Material::iron);
  s.rod({0, 0, h - 0.25}, {0, 0, h - 0.05}, 0.06, Material::glass);
  s.disc({0, 0, h}, {0, 0, 1}, 0.1, 0.1, Material::iron);
}

void make_traffic_light(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 3.1, 3.6);
  s.rod({0, 0, 0}, {0, 0, h}, 0.055, Material::zinc);
  add_lights(s, {0.18, 0, h});
  if (rng.uniform() < 0.6) s.box({0, 0.2, 2.35}, {0.2, 0.24, 0.5}, Material::iron);  // for pedestrians
  s.box({0, -0.1, 1.05}, {0.1, 0.12, 0.22}, Material::car_paint);
}

void make_traffic_light_arm(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 5.8, 6.6), reach = between(rng, 3, 5.5);
  s.taper({0, 0, 0}, h, 0.14, 0.09, Material::zinc);
  s.rod({0, 0, h - 0.1}, {reach, 0, h + 0.2}, 0.06, Material::zinc);
  add_lights(s, {0.25, 0, 3.2});
  add_lights(s, {reach, 0, h + 0.3});
}

void make_round_sign(ObjectShape& s, Rng& rng) {
  const double d = between(rng, 0.42, 0.75), h = add_sign_post(s, rng, d);
  s.disc({0.05, 0, h + d / 2}, {1, 0, 0}, 0.01, d / 2, Material::white_target);
  if (rng.uniform() < 0.4) s.box({0.05, 0, h - 0.16}, {0.01, d, 0.26}, Material::white_target);
}

void make_triangle_sign(ObjectShape& s, Rng& rng) {
  const double side = between(rng, 0.7, 0.9), h = add_sign_post(s, rng, 0.87 * side);
  const std::array<Vec3, 3> ring{{{0.05, -side / 2, h}, {0.05, side / 2, h}, {0.05, 0, h + 0.87 * side}}};
  s.solids.push_back(prism(ring, {0.01, 0, 0}, static_cast<SurfaceId>(Material::white_target)));
}

// Boards on two posts, their lower edge at 0.6 to 2.3 m.
void make_direction_sign(ObjectShape& s, Rng& rng) {
  const double low = between(rng, 0.6, 2.3), width = between(rng, 1, 3), height = between(rng, 0.4, 1.6);
  for (const double side : {-1.0, 1.0})
    s.rod({0, side * 0.35 * width, 0}, {0, side * 0.35 * width, low + height}, 0.04, Material::zinc);
  s.box({0.05, 0, low + height / 2}, {0.02, width, height}, Material::white_target);
}

// A wooden pole with cross arms; its wires run 18 m to both sides along y and sag.
void make_wire_pole(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 6.5, 9);
  s.taper({0, 0, 0}, h, 0.14, 0.09, Material::wood);
  s.box({0, 0, h - 0.4}, {1.6, 0.1, 0.1}, Material::wood);
  for (const double x : {-0.7, 0.0, 0.7})
    for (const double side : {-1.0, 1.0}) {
      const Vec3 first{x, 0, h - 0.25}, low{x, side * 9, h - 0.65}, last{x, side * 18, h - 0.85};
      s.rod(first, low, 0.011, Material::iron);
      s.rod(low, last, 0.011, Material::iron);
    }
}

}  // namespace ilot::scan
