// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/reconstruct.h"

#include "kernels/morphology/reconstruct_in_place.h"

namespace ilot {
namespace {

// Inverts the heights. The function is its own inverse, and exact at both ends of the range.
void turn_over(std::vector<Height>& values) {
  for (Height& v : values) v = ~v;
}

Image reconstructed(const Image& mask, std::vector<Height> f, std::vector<Height> g, Adjacency adjacency) {
  const PaddedFrame frame(mask.width, mask.height);
  for (std::size_t i = 0; i < g.size(); ++i) g[i] = std::max(f[i], g[i]);
  reconstruct_in_place(frame, adjacency, f, g);
  return {mask.width, mask.height, unpadded<Height>(frame, g)};
}

}  // namespace

Image reconstruct_by_erosion(const Image& marker, const Image& mask, Adjacency adjacency) {
  assert(marker.width == mask.width && marker.height == mask.height);
  if (mask.size() == 0) return mask;
  return reconstructed(mask, padded(mask, kAboveAll), padded(marker, kAboveAll), adjacency);
}

Image reconstruct_by_dilation(const Image& marker, const Image& mask, Adjacency adjacency) {
  assert(marker.width == mask.width && marker.height == mask.height);
  if (mask.size() == 0) return mask;
  std::vector<Height> f = padded(mask, kNoHeight), g = padded(marker, kNoHeight);
  turn_over(f);
  turn_over(g);
  Image out = reconstructed(mask, std::move(f), std::move(g), adjacency);
  turn_over(out.values);
  return out;
}

}  // namespace ilot
