// SPDX-License-Identifier: Apache-2.0
// Paper about a drawing: a frame of a standard size, a title block, a scale bar, what the pens mean.
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

struct SheetText {
  std::string title;
  std::vector<std::string> subject;    // under the title, largest first
  std::vector<std::string> reference;  // place, heights, date, accuracy, source: one line each
  std::vector<std::pair<DrawingRole, std::string>> legend;
};

// Sets the drawing on the smallest of A4 to A0, upright or lying, that holds it at its scale with the title block, or
// on paper of its own size beyond A0; fills drawing.sheet and adds frame and title block. Texts that do not fit their
// column are set smaller, then cut.
void add_sheet(const SheetText& text, Drawing& drawing);

// Adds a text, smaller down to 0.7 of the height where it is longer than `room`, cut with "..." where that is not
// enough.
void add_fitting_text(DrawingText text, double room, Drawing& drawing);

}  // namespace ilot
