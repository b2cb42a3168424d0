// SPDX-License-Identifier: Apache-2.0
// The colours of street objects by class, in maps, styles and pictures. viewer/src/colours.js has the same (`ofLabel`).
#pragma once
#include <array>
#include <cstdint>

#include "engine/model/point_label.h"

namespace ilot {

// Red, green, blue. A class of one's own has one of the colours, in turn. Labels that are no class of objects have that
// of `other`.
inline std::array<std::uint8_t, 3> object_colour(PointLabel label) {
  constexpr std::array<std::array<std::uint8_t, 3>, 13> kColours{{{43, 108, 176},
                                                                  {230, 159, 0},
                                                                  {197, 48, 48},
                                                                  {90, 122, 60},
                                                                  {26, 54, 110},
                                                                  {0, 150, 170},
                                                                  {214, 51, 132},
                                                                  {120, 84, 50},
                                                                  {106, 61, 154},
                                                                  {196, 148, 100},
                                                                  {124, 190, 60},
                                                                  {112, 114, 122},
                                                                  {176, 160, 40}}};  // from `car` to `cabinet`
  const auto first = static_cast<std::size_t>(PointLabel::car), place = static_cast<std::size_t>(label);
  if (is_own_class(label)) return kColours[(place - kFirstOwnLabel) % kColours.size()];
  if (place < first || place - first >= kColours.size())
    return kColours[static_cast<std::size_t>(PointLabel::other) - first];
  return kColours[place - first];
}

}  // namespace ilot
