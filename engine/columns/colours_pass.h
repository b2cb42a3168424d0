// SPDX-License-Identifier: Apache-2.0
// The colours of the points in the store, and their colour classes [Lorraine thesis, 2.2.1].
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

// Whether the format of the input has colours, and the input points.
bool has_colours(const PointReader& input);

// Writes the column "colour" of every block if an input has colours; returns whether one has. A store whose
// blocks all have the column keeps it, whatever the inputs are. Every input with colours is read once more, into files
// of 6 bytes per row. Each block gathers its colours from these files, so the memory is that of one block. A file whose
// channels never exceed 255 has 8 bits per channel. Other files have 16 bits, and the lower 8 are dropped.
bool colours_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                  const PassContext& context);

constexpr std::size_t kMostColourClasses = 16;

// The colour classes of a whole store: their centres in hundredths of CIELAB units, the largest class first.
struct ColourPalette {
  std::vector<std::array<double, 4>> centre;
  // The class of a colour: 1 to the number of classes, the one with the nearest centre (ties: the smaller number). It
  // is 0 for kNoColour, and when there are no classes.
  std::uint32_t class_of(StoredColour colour) const;
};

// Finds k classes by k-means on a sample of at most about 2^17 points. A hash of its place decides whether a point is
// in the sample, so the classes depend on the set of points alone. Call it after colours_pass.
ColourPalette colour_palette(const Store& store, std::uint32_t k, std::uint64_t seed);

}  // namespace ilot
