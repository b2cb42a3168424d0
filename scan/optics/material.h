// SPDX-License-Identifier: Apache-2.0
// The materials of surfaces: how much laser light they reflect, and their colour. Both are pure functions of the
// material and the position. Different elements share materials, so colour alone does not reveal a label.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "kernels/core/types.h"

namespace ilot::scan {

enum class Material : std::uint8_t {
  limestone,  // ashlar: beige, mottled in spots of 30 cm, dust in the grain
  render,     // painted wall: pale, hardly mottled, streaks of rain
  brick,      // brick rows of 6.5 cm with pale mortar
  mortar,
  slate,
  zinc,
  tile,
  glass,  // reflects little; see reflectance
  wood,   // painted
  iron,   // black paint
  asphalt,
  paving,
  grass,
  foliage,
  cloth,         // clothes, curtains: one colour per half metre
  car_paint,     // one colour per five metres
  interior,      // rooms seen through windows
  white_target,  // uniform; reflects half of the light
  dark_glass,    // no echo at all
  clear_glass,   // most of the light goes through
  mirror_glass,  // shows what it mirrors, behind itself
  dusty_glass    // dim echoes in patches, fewer the flatter the light falls
};

constexpr std::size_t kMaterials = 22;

// Returns a name such as "limestone", as in the truth.
const char* name_of(Material material);

using Rgb16 = std::array<std::uint16_t, 3>;

// Returns the share of the light that a perpendicular surface sends back, in (0, 1].
double reflectance(Material material);

// Returns the colour at a position, in metres in the scene. Continuous noise of several sizes is added to the colour of
// the material. No function of libm is used, so the colour is the same on every machine.
Rgb16 colour(Material material, Vec3 place);

}  // namespace ilot::scan
