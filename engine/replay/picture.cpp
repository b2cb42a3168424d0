// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/picture.h"

#include <algorithm>
#include <cmath>

namespace ilot {

PictureColour colour_of_number(std::uint64_t number) {
  constexpr double kGolden = 0.618034;  // of the hue circle: consecutive numbers never have similar colours
  if (number == 0) return {170, 170, 170};
  const double turns = kGolden * static_cast<double>(number % 4096);
  const double hue = 6 * (turns - std::floor(turns)), value = number % 3 == 0 ? 150 : number % 3 == 1 ? 220 : 190;
  PictureColour colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double turn = std::fmod(hue + 6 - 2 * static_cast<double>(c), 6.0);
    const double pure = std::clamp(std::abs(turn - 3) - 1, 0.0, 1.0);
    colour[c] = static_cast<std::uint8_t>(value * (0.12 + 0.88 * pure));
  }
  return colour;
}

PictureColour light(PictureColour colour) {
  for (std::uint8_t& c : colour) c = static_cast<std::uint8_t>(255 - (255 - c) * 45 / 100);
  return colour;
}

}  // namespace ilot
