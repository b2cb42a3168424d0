// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// h-maxima [Hernandez and Marcotegui 2008, 5.1]: suppresses the maxima that rise by at most h (>= 0) above the highest
// pass to a higher one, and lowers the others by h: reconstruction by dilation of the image from the image less h
// (Soille 2003). Pixels without a height stay without. Unique; costs as a reconstruction.
Image h_maxima(const Image& image, Height h, Adjacency adjacency);

// Regional maxima: flat zones without a higher neighbour; a plateau is one maximum, a flat image too. Numbered by their
// first pixel. Pixels without a height are in none. O(n).
PixelLabels regional_maxima(const Image& image, Adjacency adjacency);

}  // namespace ilot
