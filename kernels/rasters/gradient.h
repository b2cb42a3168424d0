// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// Morphological gradient: the highest less the lowest of a pixel and its neighbours that have a height; kNoHeight where
// the pixel has none. O(n).
Image gradient(const Image& image, Adjacency adjacency);

}  // namespace ilot
