// SPDX-License-Identifier: Apache-2.0
// What surfaces are made of: how much laser light they give back, and their colour, both pure functions of the
// material and the place. Elements share materials, so that colour alone gives no label away.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot::scan {

enum class Material : std::uint8_t {
  limestone,  // ashlar: beige, mottled in spots of 30 cm, dust in the grain
  render,     // painted wall: pale, hardly mottled, streaks of rain
  brick,      // rows of 6.5 cm with pale mortar
  mortar,
  slate,
  zinc,
  tile,
  glass,  // gives little back; see reflectance
  wood,   // painted
  iron,   // black paint
  asphalt,
  paving,
  grass,
  foliage,
  cloth,        // clothes, curtains: one colour per half metre
  car_paint,    // one colour per five metres
  interior,     // rooms seen through windows
  white_target  // even, half of the light
};

constexpr std::size_t kMaterials = 18;

// "limestone", as in the truth.
const char* name_of(Material material);

using Rgb16 = std::array<std::uint16_t, 3>;

// Share of the light that a perpendicular surface sends back, in (0, 1].
double reflectance(Material material);

// Colour at a place, metres in the scene. Continuous noise of several sizes over the material's own colour; no libm, so
// the same on every machine.
Rgb16 colour(Material material, Vec3 place);

}  // namespace ilot::scan
