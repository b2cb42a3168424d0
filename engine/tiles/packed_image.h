// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/tiles/tile_layers.h"

namespace ilot {

// An image that is packed row by row. Long runs of one value are stored as one value, and heights that are close enough
// together take two bytes each. Rows can be unpacked without the rows above them.
struct PackedImage {
  std::vector<std::uint32_t> rows;   // index of the word at which each row begins, and the end of the last row
  std::vector<std::uint16_t> words;  // of all rows
  Height base = 0;                   // origin of the two-byte values
  bool wide = false;                 // four bytes per value
};

// Packs an image with a width below 2^15. O(n).
PackedImage packed_image(const Image& image);

// Writes a rectangle of the image to `out`. `words` are those of its rows. O(n) of these rows.
void unpack(const PackedImage& packed, std::span<const std::uint16_t> words, const TileFrame& part,
            const PixelRows& out);

}  // namespace ilot
