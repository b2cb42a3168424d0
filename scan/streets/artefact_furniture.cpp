// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/artefact.h"

namespace ilot::scan {
namespace {

void make_dustbin(Artefact& a, Rng& rng) {
  const double h = 0.8 + 0.25 * rng.uniform(), r = 0.2 + 0.08 * rng.uniform();
  a.rod({0, 0, 0}, {0, 0, h}, r, Material::iron);
  a.taper({0, 0, h}, 0.12, r + 0.03, 0.08, Material::iron);
}

void make_wheelie_bin(Artefact& a, Rng& rng) {
  const double h = 0.95 + 0.2 * rng.uniform();
  a.profile(std::array<FlatPoint, 4>{{{-0.24, 0.08}, {0.22, 0.08}, {0.32, h}, {-0.28, h}}}, 0.56, Material::wood);
  a.box({0.02, 0, h + 0.03}, {0.66, 0.58, 0.06}, Material::wood);
  for (double y : {-0.22, 0.22}) a.disc({-0.22, y, 0.1}, {0, 1, 0}, 0.05, 0.1, Material::iron);
}

void make_motorbike(Artefact& a, Rng& rng) {
  const double reach = 0.65 + 0.1 * rng.uniform();
  for (double x : {-reach, reach}) a.disc({x, 0, 0.3}, {0, 1, 0}, 0.12, 0.3, Material::iron);
  a.profile(
      std::array<FlatPoint, 6>{{{-0.5, 0.35}, {0.35, 0.3}, {0.45, 0.7}, {0.25, 0.95}, {-0.1, 0.8}, {-0.75, 0.85}}}, 0.3,
      Material::car_paint);
  a.box({-0.4, 0, 0.84}, {0.7, 0.28, 0.1}, Material::cloth);
  a.rod({reach, 0, 0.3}, {0.42, 0, 1.0}, 0.05, Material::zinc);
  a.rod({0.42, -0.35, 1.02}, {0.42, 0.35, 1.02}, 0.025, Material::iron);
}

void make_bicycle(Artefact& a, Rng& rng) {
  const double reach = 0.5 + 0.05 * rng.uniform();
  for (double x : {-reach, reach}) a.disc({x, 0, 0.34}, {0, 1, 0}, 0.04, 0.34, Material::iron);
  a.rod({-reach, 0, 0.34}, {-0.15, 0, 0.9}, 0.025, Material::car_paint);
  a.rod({-0.18, 0, 0.8}, {reach - 0.1, 0, 0.85}, 0.025, Material::car_paint);
  a.rod({-0.1, 0, 0.35}, {reach - 0.1, 0, 0.8}, 0.025, Material::car_paint);
  a.rod({reach, 0, 0.34}, {reach - 0.12, 0, 1.02}, 0.025, Material::car_paint);
  a.rod({reach - 0.1, -0.28, 1.02}, {reach - 0.1, 0.28, 1.02}, 0.02, Material::iron);
  a.box({-0.18, 0, 0.95}, {0.26, 0.16, 0.07}, Material::iron);
}

// A parking meter is as tall as a person.
void make_parking_meter(Artefact& a, Rng& rng) {
  const double h = 1.45 + 0.3 * rng.uniform();
  a.rod({0, 0, 0}, {0, 0, h - 0.5}, 0.1, Material::iron);
  a.column(std::array<FlatPoint, 4>{{{-0.14, -0.17}, {0.14, -0.17}, {0.14, 0.17}, {-0.14, 0.17}}}, h - 0.55, h,
           Material::zinc);
}

void make_pay_station(Artefact& a, Rng& rng) {
  const double h = 1.5 + 0.3 * rng.uniform();
  a.box({0, 0, h / 2}, {0.32, 0.42, h}, Material::zinc);
  a.profile(std::array<FlatPoint, 3>{{{-0.16, h}, {0.22, h}, {-0.16, h + 0.12}}}, 0.44, Material::iron);
}

void make_bus_shelter(Artefact& a, Rng& rng) {
  const double length = 3.4 + 1.2 * rng.uniform();
  a.box({0, 0, 2.42}, {1.5, length + 0.3, 0.1}, Material::zinc);
  // The panes let the light through, so the back has only their rails. There is a poster at the end.
  for (double z : {0.3, 1.2, 2.2}) a.box({-0.62, 0, z}, {0.04, length, 0.06}, Material::zinc);
  a.box({-0.1, -length / 2, 1.25}, {1.0, 0.12, 1.9}, Material::white_target);
  for (double y : {-length / 2, length / 2})
    for (double x : {-0.62, 0.45}) a.rod({x, y, 0}, {x, y, 2.4}, 0.05, Material::iron);
  a.box({-0.4, 0, 0.45}, {0.35, 0.6 * length, 0.05}, Material::wood);
  for (double y : {-0.25 * length, 0.25 * length}) a.rod({-0.4, y, 0}, {-0.4, y, 0.44}, 0.04, Material::iron);
}

void make_bench(Artefact& a, Rng& rng) {
  const double length = 1.5 + 0.5 * rng.uniform();
  a.box({0, 0, 0.45}, {0.45, length, 0.06}, Material::wood);
  a.box({-0.24, 0, 0.7}, {0.05, length, 0.35}, Material::wood);
  for (double y : {-0.4 * length, 0.4 * length}) a.box({0, y, 0.21}, {0.4, 0.06, 0.42}, Material::iron);
}

void make_sign(Artefact& a, Rng& rng) {
  const double h = 2.3 + 0.5 * rng.uniform();
  a.rod({0, 0, 0}, {0, 0, h + 0.3}, 0.04, Material::zinc);
  a.disc({0.06, 0, h}, {1, 0, 0}, 0.02, 0.32, Material::white_target);
}

void make_advert_column(Artefact& a, Rng& rng) {
  const double h = 2.9 + 0.6 * rng.uniform();
  a.rod({0, 0, 0}, {0, 0, h}, 0.65, Material::wood);
  a.disc({0, 0, h + 0.05}, {0, 0, 1}, 0.1, 0.8, Material::iron);
  a.taper({0, 0, h + 0.1}, 0.6, 0.7, 0.05, Material::iron);
}

void make_post_box(Artefact& a, Rng& rng) {
  const double h = 1.1 + 0.25 * rng.uniform();
  a.box({0, 0, 0.2}, {0.12, 0.3, 0.4}, Material::iron);
  a.box({0, 0, 0.4 + (h - 0.4) / 2}, {0.4, 0.55, h - 0.4}, Material::car_paint);
}

}  // namespace

Artefact make_furniture(std::string_view variant, Rng& rng) {
  struct Maker {
    std::string_view variant;
    void (*make)(Artefact&, Rng&);
  };
  constexpr std::array<Maker, 11> kMakers{{{"dustbin", make_dustbin},
                                           {"wheelie_bin", make_wheelie_bin},
                                           {"motorbike", make_motorbike},
                                           {"bicycle", make_bicycle},
                                           {"parking_meter", make_parking_meter},
                                           {"pay_station", make_pay_station},
                                           {"bus_shelter", make_bus_shelter},
                                           {"bench", make_bench},
                                           {"sign", make_sign},
                                           {"advert_column", make_advert_column},
                                           {"post_box", make_post_box}}};
  Artefact artefact;
  for (const Maker& maker : kMakers)
    if (maker.variant == variant) maker.make(artefact, rng);
  if (variant == "bollard") artefact.rod({0, 0, 0}, {0, 0, 0.8 + 0.3 * rng.uniform()}, 0.09, Material::iron);
  return artefact;
}

}  // namespace ilot::scan
