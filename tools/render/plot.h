// SPDX-License-Identifier: Apache-2.0
// Plans of what steps found: areas, points and lines with a title, a legend and a scale bar.
#pragma once
#include "engine/replay/picture.h"
#include "tools/render/image.h"

namespace ilot::render {

// size: pixels of the longer side of what is drawn; the words come beside.
Image plot(const Picture& picture, int size = 1200);

}  // namespace ilot::render
