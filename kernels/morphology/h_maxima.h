// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "kernels/rasters/image.h"

namespace ilot {

// h-maxima [Hernandez and Marcotegui 2008, 5.1]. The function removes the maxima that rise by at most h (>= 0) above
// the highest pass to a higher one, and lowers the others by h. It is the reconstruction by dilation of the image from
// the image minus h (Soille 2003). Pixels without a height stay so. The result is unique. The cost is that of a
// reconstruction.
Image h_maxima(const Image& image, Height h, Adjacency adjacency);

// Regional maxima are flat zones without a higher neighbour. A plateau is one maximum, and so is a flat image. They are
// numbered by their first pixel. Pixels without a height are in no maximum. O(n).
PixelLabels regional_maxima(const Image& image, Adjacency adjacency);

}  // namespace ilot
