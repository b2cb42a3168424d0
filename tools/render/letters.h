// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

#include "tools/render/image.h"

namespace ilot::render {

constexpr int kLetterWidth = 6, kLetterHeight = 9;  // pixels, with the gap to the next one; times the size

// Writes ASCII with its upper left corner there, in letters of 5 by 7 squares of `size` pixels. What is beyond the
// image is left out, and other characters are boxes.
void write_text(Image& image, int column, int row, std::string_view text, Rgb colour, int size = 1);

}  // namespace ilot::render
