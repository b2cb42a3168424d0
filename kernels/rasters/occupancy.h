// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// The heights at which a pixel is occupied. Bit i is set where a point is in bin i above the ground. There are 31 bins,
// so an occupancy stored as a Height is never negative.
using Occupancy = std::uint32_t;
constexpr std::uint32_t kOccupancyBins = 31;

// A square ring around a pixel: the pixels farther than `within` pixels along one of the axes, and no farther than
// `reach`.
struct PixelRing {
  std::uint32_t within = 0, reach = 1;  // within < reach
};

// Returns for each pixel the bins that are empty in all pixels of the ring around it. An object no wider than `within`
// stands free in these bins (the isolation of Cabo et al. 2014, ISPRS J. 87, and the ring of Lehtomaki et al. 2010, for
// all heights at once). Outside of the image all bins are empty. The bits are combined by OR in windows that double
// with each pass: O(n log reach), several pixels at a time, 20 bytes per pixel.
std::vector<Occupancy> free_bins(std::span<const Occupancy> image, std::uint32_t width, std::uint32_t height,
                                 const PixelRing& ring);

// The longest run of bits that are set, the lowest of equally long ones. O(bits).
struct BinRun {
  std::uint32_t first = 0, length = 0;
  Occupancy bins() const { return ((Occupancy{1} << length) - 1) << first; }  // length at most 31
};
BinRun longest_run(Occupancy bins);

}  // namespace ilot
