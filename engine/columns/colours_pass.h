// SPDX-License-Identifier: Apache-2.0
// Colours of the points in the store, and the classes they fall into [Lorraine thesis, 2.2.1].
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

using StoredColour = std::uint32_t;  // 0xRRGGBB
constexpr StoredColour kNoColour = 0xff000000;

// Writes the column "colour" of every block, if an input has colours; returns whether one has. Reads every coloured
// input once more, into files of 6 bytes a row from which blocks gather theirs, so memory stays that of a block. Files
// whose channels never exceed 255 hold 8 bits a channel, the others 16 (the lower 8 are dropped).
bool colours_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                  const PassContext& context);

constexpr std::size_t kMostColourClasses = 16;

// Classes of colour of a whole store: centres in CIELAB, hundredths, the largest class first.
struct ColourPalette {
  std::vector<std::array<double, 4>> centre;
  // 1 to the number of classes, the nearest centre (ties: the smaller); 0 for kNoColour and without classes.
  std::uint32_t class_of(StoredColour colour) const;
};

// k classes by k-means from the share of points whose hashed place says so, at most about 2^17: they depend on the set
// of points alone. After colours_pass.
ColourPalette colour_palette(const Store& store, std::uint32_t k, std::uint64_t seed);

}  // namespace ilot
