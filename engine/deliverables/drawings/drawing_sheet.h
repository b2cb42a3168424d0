// SPDX-License-Identifier: Apache-2.0
// The paper around a drawing: a frame of a standard size, a title block, a scale bar and a legend of the pens.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

struct SheetText {
  std::string title;
  std::vector<std::string> subject;    // under the title, largest first
  std::vector<std::string> reference;  // place, heights, date, accuracy, source: one line each
  std::vector<std::pair<DrawingRole, std::string>> legend;
  std::optional<double> north_deg = {};  // where grid north is on the paper, from right towards up; none: no arrow
};

// Puts the drawing on the smallest sheet of A4 to A0, portrait or landscape, on which it fits at its scale with the
// title block. A larger drawing gets paper of its own size. Fills drawing.sheet and adds the frame and the title block.
// Texts that do not fit their column are set smaller, then cut.
void add_sheet(const SheetText& text, Drawing& drawing);

// Adds a text. A text longer than `room` is set smaller, down to 0.7 of its height. If that is not enough, it is cut
// with "...".
void add_fitting_text(DrawingText text, double room, Drawing& drawing);

}  // namespace ilot
