// SPDX-License-Identifier: Apache-2.0
// Inside of find_things: parts that stand in two layers, as a bollard beside somebody who hides its top.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

struct SplitLayers {
  PixelLabels labels;  // in the order of the parts; of two layers the upper one first
  std::vector<std::pair<std::uint32_t, std::uint32_t>> layers;  // of each part that was split: upper, lower
};

// A part is split at the height that tells its pixels apart best (Otsu 1979: the greatest variance between two classes)
// where the classes are farther apart than those of an even slope, of whose variance three quarters lie between its
// halves. The lower layer is the largest connected piece of what is lower; all else is the upper one. Neither is
// smaller than `least` pixels. Every pixel of a part must have a height. O(n log n).
SplitLayers split_layers(const PixelLabels& parts, const Image& heights, std::uint32_t least);

}  // namespace ilot
