// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// At which heights something stands in a pixel: bit i is set where a point lies in bin i above the ground. 31 bins, so
// that an occupancy kept as a Height is never negative.
using Occupancy = std::uint32_t;
constexpr std::uint32_t kOccupancyBins = 31;

// A square ring around a pixel: farther than `within` pixels along one of the axes, and no farther than `reach`.
struct PixelRing {
  std::uint32_t within = 0, reach = 1;  // within < reach
};

// Of each pixel the bins in which no pixel of the ring around it has anything: what is no wider than `within` stands
// free there (the isolation of Cabo et al. 2014, ISPRS J. 87, and the ring of Lehtomaki et al. 2010, all heights at
// once). Nothing stands outside of the image. Bits of words that are or-ed in windows which double with each pass:
// O(n log reach), several pixels at a time; 20 bytes a pixel.
std::vector<Occupancy> free_bins(std::span<const Occupancy> image, std::uint32_t width, std::uint32_t height,
                                 const PixelRing& ring);

// The longest run of bits that are set, the lowest of equally long ones. O(bits).
struct BinRun {
  std::uint32_t first = 0, length = 0;
  Occupancy bins() const { return ((Occupancy{1} << length) - 1) << first; }  // length at most 31
};
BinRun longest_run(Occupancy bins);

}  // namespace ilot
