// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/cloud/record.h"
#include "tools/render/image.h"

namespace ilot::render {

// Returns the colour of one record.
using Colouring = std::function<Rgb(std::span<const std::byte>)>;

// Statistics of the points that are drawn.
struct ColourRange {
  double low = 0, high = 0;     // heights in world units that "height" spreads its colours over
  std::uint16_t brightest = 0;  // largest channel of all colours: up to 255 the colours have 8 bits, else 16
  std::vector<std::uint64_t> intensities = std::vector<std::uint64_t>(65536);  // number of points by intensity
};

// Adds the colour and the intensity of the record to the range.
void note_colour(std::span<const std::byte> record, const RecordLayout& layout, ColourRange& range);

// Returns a colouring. `by` is "class" (or "classification"), "height", "intensity" (the lightest colour is the value
// that 98 % of the points do not exceed), "rgb", or the name of an extra-byte field of integers. The values of such a
// field get very different colours (0 = dark grey). Throws Error (usage) when the cloud has no such field.
Colouring colouring(const std::string& by, const RecordLayout& layout, const ColourRange& range);

}  // namespace ilot::render
