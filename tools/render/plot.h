// SPDX-License-Identifier: Apache-2.0
// Plans of the results of steps: areas, points and lines with a title, a legend and a scale bar.
#pragma once
#include "engine/replay/picture.h"
#include "tools/render/image.h"

namespace ilot::render {

// Draws the plan. `size` is the longer side of the drawing in pixels. The text is beside the drawing.
Image plot(const Picture& picture, int size = 1200);

}  // namespace ilot::render
