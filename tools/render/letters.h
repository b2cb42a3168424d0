// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

#include "tools/render/image.h"

namespace ilot::render {

constexpr int kLetterWidth = 6, kLetterHeight = 9;  // pixels, with the gap to the next letter; multiplied by the size

// Writes ASCII text with its upper left corner at (column, row), in letters of 5 by 7 squares of `size` pixels. Parts
// outside the image are left out. Other characters are drawn as boxes.
void write_text(Image& image, int column, int row, std::string_view text, Rgb colour, int size = 1);

}  // namespace ilot::render
