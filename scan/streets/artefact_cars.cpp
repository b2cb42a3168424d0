// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/artefact.h"

namespace ilot::scan {
namespace {

// Lengths in metres. The corners of the cabin are measured from the rear bumper.
struct CarSize {
  double length, width, height;
  double tail, rear, front, screen;  // cabin: bottom and top at the rear, top and bottom at the front
};

CarSize size_of(std::string_view variant) {
  if (variant == "city") return {3.5, 1.62, 1.5, 0.1, 0.4, 2.0, 2.8};
  if (variant == "hatchback") return {4.05, 1.75, 1.47, 0.15, 0.7, 2.3, 3.1};
  if (variant == "saloon") return {4.65, 1.82, 1.44, 0.75, 1.5, 2.7, 3.5};
  if (variant == "estate") return {4.7, 1.83, 1.5, 0.1, 0.35, 2.7, 3.55};
  if (variant == "suv") return {4.5, 1.86, 1.7, 0.15, 0.5, 2.6, 3.4};
  if (variant == "van") return {5.1, 1.95, 2.1, 0.05, 0.15, 3.7, 4.5};
  return {5.2, 1.88, 1.78, 2.0, 2.2, 3.3, 4.0};  // pickup
}

}  // namespace

Artefact make_car(std::string_view variant, Rng& rng) {
  CarSize size = size_of(variant);
  const double stretch = 0.96 + 0.08 * rng.uniform();
  size.length *= stretch;
  const double tail = -size.length / 2, nose = size.length / 2, waist = 0.5 * size.height + 0.14;
  const double floor = 0.22, bonnet = waist - 0.1;
  Artefact car;
  car.profile(std::array<FlatPoint, 7>{{{tail + 0.05, floor},
                                        {nose - 0.05, floor},
                                        {nose, floor + 0.25},
                                        {nose - 0.12, bonnet - 0.06},
                                        {nose - 0.3, bonnet},
                                        {tail + 0.05, waist},
                                        {tail, floor + 0.2}}},
              size.width, Material::car_paint);
  Solid& cabin = car.profile(std::array<FlatPoint, 4>{{{tail + stretch * size.tail, waist - 0.12},
                                                       {tail + stretch * size.screen, waist - 0.12},
                                                       {tail + stretch * size.front, size.height},
                                                       {tail + stretch * size.rear, size.height}}},
                             0.86 * size.width, Material::glass);
  cabin.surfaces[2] = static_cast<SurfaceId>(Material::car_paint);  // the roof
  if (variant == "van")
    for (std::size_t side : {3, 4, 5}) cabin.surfaces[side] = static_cast<SurfaceId>(Material::car_paint);
  for (double x : {tail + 0.75, nose - 0.8})
    for (double side : {-1.0, 1.0})
      car.disc({x, side * (size.width / 2 - 0.1), 0.31}, {0, 1, 0}, 0.2, 0.31, Material::iron);
  return car;
}

}  // namespace ilot::scan
