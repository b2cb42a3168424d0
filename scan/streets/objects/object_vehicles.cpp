// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <initializer_list>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

void add_wheels(ObjectShape& s, std::initializer_list<double> axles, double half_width, double radius) {
  for (const double x : axles)
    for (const double side : {-1.0, 1.0})
      s.disc({x, side * (half_width - 0.14), radius}, {0, 1, 0}, 0.26, radius, Material::iron);
}

void add_mirrors(ObjectShape& s, double x, double half_width, double z, double size) {
  for (const double side : {-1.0, 1.0}) s.box({x, side * (half_width + 0.1), z}, {0.1, 0.2, size}, Material::car_paint);
}

}  // namespace

void make_any_car(ObjectShape& s, Rng& rng) {
  const auto variants = variants_of(ArtefactClass::car);
  const Artefact car = make_car(variants[rng.below(variants.size())], rng);
  s.solids = car.solids;
  const Box3<Vec3> box = bounds_of(car);
  add_mirrors(s, 0.16 * box.max.x, box.max.y, 0.62 * box.max.z, 0.14);
  if (rng.uniform() < 0.12) s.box({-0.3, 0, box.max.z + 0.2}, {1.9, 0.8, 0.36}, Material::iron);  // a roof box
}

// Tall vans: 5.3 to 7.4 m long, 2.3 to 2.8 m high.
void make_panel_van(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 5.3, 7.4), width = between(rng, 1.95, 2.08), height = between(rng, 2.3, 2.8);
  const double nose = length / 2;
  s.profile(std::array<FlatPoint, 7>{{{-nose, 0.3},
                                      {nose - 0.05, 0.3},
                                      {nose, 0.95},
                                      {nose - 0.65, 1.25},
                                      {nose - 1.35, height - 0.25},
                                      {nose - 1.8, height},
                                      {-nose, height}}},
            width, Material::car_paint);
  s.profile(std::array<FlatPoint, 4>{{{nose - 1.9, 1.3}, {nose - 0.64, 1.3}, {nose - 1.3, 2.1}, {nose - 1.9, 2.1}}},
            width + 0.01, Material::glass);
  add_wheels(s, {-nose + 1.05, nose - 0.95}, width / 2, 0.34);
  add_mirrors(s, nose - 1.0, width / 2, 1.55, 0.34);
}

// Rigid lorries of 7.5 to 18 t: box bodies 3.2 to 3.9 m high.
void make_lorry(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 6.5, 10), height = between(rng, 3.2, 3.9), nose = length / 2;
  s.profile(
      std::array<FlatPoint, 5>{{{nose - 1.9, 0.5}, {nose, 0.5}, {nose, 1.5}, {nose - 0.2, 2.7}, {nose - 1.9, 2.7}}},
      2.3, Material::car_paint);
  s.box({nose - 0.2, 0, 1.95}, {0.42, 2.1, 0.8}, Material::glass);
  const double body = length - 2.05;
  s.box({-nose + body / 2, 0, (height + 1.05) / 2}, {body, 2.5, height - 1.05}, Material::wood);
  s.box({-0.3, 0, 0.85}, {length - 1.5, 0.9, 0.25}, Material::iron);
  add_wheels(s, {-nose + 1.6, nose - 1.2}, 1.2, 0.46);
  add_mirrors(s, nose - 0.3, 1.2, 2.0, 0.6);
}

// The longest lorry without a permit is 16.5 m long, 2.55 m wide and 4 m high (directive 96/53/EC).
void make_articulated_lorry(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 14, 16.5), nose = length / 2;
  s.profile(
      std::array<FlatPoint, 5>{{{nose - 2.2, 0.4}, {nose, 0.4}, {nose, 2.2}, {nose - 0.3, 3.6}, {nose - 2.2, 3.7}}},
      2.5, Material::car_paint);
  s.box({-1.45, 0, 2.55}, {length - 2.9, 2.55, 2.9}, Material::cloth);
  s.box({-1.45, 0, 1.0}, {length - 2.9, 1.0, 0.25}, Material::iron);
  add_wheels(s, {-nose + 1.8, -nose + 3.1, -nose + 4.4, nose - 1.4, nose - 4.6}, 1.25, 0.5);
  add_mirrors(s, nose - 0.2, 1.25, 2.4, 0.6);
}

void make_bus(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 8.5, 12.2), height = between(rng, 2.9, 3.3), nose = length / 2;
  s.box({0, 0, 0.7}, {length, 2.55, 0.8}, Material::car_paint);
  s.box({0, 0, 1.72}, {length - 0.06, 2.5, 1.26}, Material::glass);
  s.box({0, 0, (height + 2.33) / 2}, {length, 2.55, height - 2.33}, Material::car_paint);
  for (double x = -nose + 0.05; x < nose; x += 1.45)
    for (const double y : {-1.26, 1.26}) s.box({x, y, 1.7}, {0.12, 0.03, 1.3}, Material::car_paint);
  s.box({-0.2 * length, 0, height + 0.12}, {2.4, 1.8, 0.24}, Material::car_paint);
  add_wheels(s, {-nose + 3.2, nose - 2.6}, 1.27, 0.48);
  add_mirrors(s, nose + 0.15, 1.2, 2.2, 0.45);
}

void make_caravan(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 4, 6.5), height = between(rng, 2.45, 2.65), nose = length / 2;
  s.profile(std::array<FlatPoint, 6>{{{-nose, 0.55},
                                      {nose - 0.25, 0.55},
                                      {nose, 1.2},
                                      {nose - 0.5, height - 0.1},
                                      {nose - 1, height},
                                      {-nose + 0.1, height}}},
            between(rng, 2.1, 2.5), Material::wood);
  s.rod({nose - 0.3, 0, 0.5}, {nose + 1.2, 0, 0.45}, 0.06, Material::iron);
  add_wheels(s, {-0.2}, 1.05, 0.31);
}

void make_trailer(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 1.8, 4), width = between(rng, 1.1, 1.9);
  s.box({0, 0, 0.55}, {length, width, 0.12}, Material::zinc);
  for (const double side : {-1.0, 1.0}) {
    s.box({0, side * (width / 2 - 0.02), 0.75}, {length, 0.04, 0.35}, Material::zinc);
    s.box({side * (length / 2 - 0.02), 0, 0.75}, {0.04, width, 0.35}, Material::zinc);
  }
  s.rod({length / 2, 0, 0.5}, {length / 2 + 1.1, 0, 0.45}, 0.04, Material::iron);
  add_wheels(s, {-0.1}, width / 2 + 0.2, 0.28);
}

// A car below a tarpaulin has neither windows nor wheels.
void make_covered_car(ObjectShape& s, Rng& rng) {
  const double length = between(rng, 3.6, 4.8), width = between(rng, 1.75, 2), height = between(rng, 1.4, 1.65);
  const double nose = length / 2;
  s.profile(std::array<FlatPoint, 8>{{{-nose - 0.05, 0.05},
                                      {nose + 0.05, 0.05},
                                      {nose, 0.65},
                                      {nose - 1.0, 0.95},
                                      {nose - 1.7, height},
                                      {-nose + 1.1, height},
                                      {-nose + 0.2, 1.0},
                                      {-nose - 0.02, 0.6}}},
            width, Material::cloth);
}

}  // namespace ilot::scan
