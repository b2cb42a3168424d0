// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {

void make_walker(ObjectShape& s, Rng& rng) {
  constexpr std::array<std::string_view, 5> kVariants{"walking", "walking", "bag", "backpack", "child"};
  s.solids = make_pedestrian(kVariants[rng.below(kVariants.size())], rng).solids;
}

void make_standing_person(ObjectShape& s, Rng& rng) {
  constexpr std::array<std::string_view, 4> kVariants{"standing", "phone", "umbrella", "backpack"};
  s.solids = make_pedestrian(kVariants[rng.below(kVariants.size())], rng).solids;
}

void make_sitting_person(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.93, 1.08);
  for (const double side : {-1.0, 1.0}) {
    s.rod({0.42 * h, side * 0.1, 0.03}, {0.4 * h, side * 0.1, 0.46}, 0.055, Material::cloth);
    s.rod({0.4 * h, side * 0.1, 0.48}, {-0.02, side * 0.1, 0.5}, 0.075, Material::cloth);
    s.rod({0.04, side * 0.21, 0.95 * h}, {0.3, side * 0.16, 0.6 * h}, 0.045, Material::cloth);
  }
  s.rod({-0.04, 0, 0.45}, {0.02, 0, 1.02 * h}, 0.17, Material::cloth);
  s.ball({0.05, 0, 1.2 * h}, 0.115, Material::wood);
  s.box({0, 0, 0.42}, {0.42, 0.42, 0.04}, Material::wood);
  for (const double x : {-0.18, 0.18})
    for (const double y : {-0.18, 0.18}) s.rod({x, y, 0}, {x, y, 0.42}, 0.015, Material::iron);
}

void make_pram(ObjectShape& s, Rng& rng) {
  const double bar = between(rng, 0.95, 1.1);
  s.box({0.1, 0, 0.62}, {0.75, 0.4, 0.28}, Material::cloth);
  s.disc({0.28, 0, 0.78}, {0, 1, 0}, 0.42, 0.24, Material::cloth);  // the hood
  s.rod({-0.25, 0, 0.5}, {-0.6, 0, bar}, 0.02, Material::iron);
  s.rod({-0.6, -0.25, bar}, {-0.6, 0.25, bar}, 0.018, Material::iron);
  for (const double x : {-0.3, 0.38})
    for (const double y : {-0.26, 0.26}) {
      s.disc({x, y, 0.13}, {0, 1, 0}, 0.05, 0.13, Material::iron);
      s.rod({x, y, 0.13}, {0.05, 0.7 * y, 0.5}, 0.015, Material::iron);
    }
}

void make_wheelchair(ObjectShape& s, Rng& rng) {
  make_sitting_person(s, rng);
  for (const double y : {-0.3, 0.3}) s.disc({-0.05, y, 0.3}, {0, 1, 0}, 0.04, 0.3, Material::iron);
  s.box({-0.25, 0, 0.72}, {0.05, 0.44, 0.55}, Material::cloth);
}

// Withers of 25 to 70 cm.
void make_dog(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.25, 0.7);
  s.rod({-0.5 * h, 0, 0.85 * h}, {0.5 * h, 0, 0.88 * h}, 0.17 * h, Material::cloth);
  s.ball({0.72 * h, 0, 1.12 * h}, 0.16 * h, Material::cloth);
  s.rod({0.72 * h, 0, 1.1 * h}, {0.98 * h, 0, 1.04 * h}, 0.08 * h, Material::cloth);
  s.rod({-0.55 * h, 0, 0.9 * h}, {-0.85 * h, 0, 1.1 * h}, 0.03 * h, Material::cloth);
  for (const double x : {-0.4, 0.42})
    for (const double y : {-0.1, 0.1}) s.rod({x * h, y * h, 0}, {x * h, y * h, 0.8 * h}, 0.05 * h, Material::cloth);
}

}  // namespace ilot::scan
