// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// L* a* b* in hundredths. L is from 0 to 10,000, a and b are from -12,800 to 12,800.
using Lab = std::array<std::int32_t, 3>;

// Converts sRGB (IEC 61966-2-1) to CIELAB under D65, with tables made by plain arithmetic, so the bits are the same on
// every machine. The error is below 0.02.
Lab lab_of(std::uint8_t r, std::uint8_t g, std::uint8_t b);

// The values by which points are compared. Intensity is for the benchmarks only. The document leaves it out, because it
// depends on range and incidence.
enum class ColourSpace { kLab, kRgb, kLabIntensity };

struct PointColours {
  std::span<const std::uint8_t> r, g, b;
  std::span<const std::uint16_t> intensity;  // read by kLabIntensity only
};

struct ColourClassParams {
  std::uint32_t k = 6;
  ColourSpace space = ColourSpace::kLab;
  int starts = 4;       // number of starts; the result with the least intra-class inertia is kept
  int max_rounds = 50;  // of Lloyd's iteration
  std::uint64_t key = 0;
};

struct ColourClasses {
  std::vector<std::uint32_t> label;           // per point, 1 to the number of classes
  std::vector<std::array<double, 4>> centre;  // per class; the largest first, ties by centre
  std::vector<std::uint64_t> size;            // points per class
  double intra = 0;                           // inertia within classes: sum of squared distances to their centres
  double inter = 0;                           // inertia between classes: intra + inter = total
  double total() const { return intra + inter; }
};

// Computes colour classes [Lorraine thesis, 2.2.1] by k-means (Lloyd 1982) from k-means++ starts (Arthur and
// Vassilvitskii 2007). It runs on the sorted histogram of colours with integer sums, so the order of points does not
// matter. Draws are keyed by that histogram. With fewer colours than k, each colour is a class. O(n) for the histogram,
// O(colours x k x rounds).
ColourClasses colour_classes(const PointColours& colours, const ColourClassParams& params = {});

}  // namespace ilot
