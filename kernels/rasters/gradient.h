// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Morphological gradient: the highest minus the lowest height of a pixel and its neighbours with a height. It is
// kNoHeight where the pixel has none. O(n).
Image gradient(const Image& image, Adjacency adjacency);

}  // namespace ilot
