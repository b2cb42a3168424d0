// SPDX-License-Identifier: Apache-2.0
// A candidate that a test draws pixel by pixel, described as a run does.
#pragma once
#include <functional>

#include "engine/products/streets/objects/candidate_description.h"

namespace ilot {

constexpr std::uint32_t kDrawnSide = 60;

struct DrawnPixel {
  Height height = kNoHeight;
  Height bins = 0;
};
using DrawnAt = std::function<DrawnPixel(std::uint32_t x, std::uint32_t y)>;  // kNoHeight: not of the candidate

// Describes the candidate whose pixels `at` gives.
inline ObjectCandidate drawn_candidate(const DrawnAt& at) {
  Patch patch;
  patch.x = 100, patch.y = -40;
  for (Image* image : {&patch.height, &patch.range, &patch.accumulation, &patch.above, &patch.low, &patch.occupancy,
                       &patch.components, &patch.beside})
    *image = filled_image(kDrawnSide, kDrawnSide, 0);
  ComponentImages images{patch, filled_image(kDrawnSide, kDrawnSide, kNoHeight),
                         filled_image(kDrawnSide, kDrawnSide, 0)};
  PixelLabels labels{kDrawnSide, kDrawnSide, 1, std::vector<std::uint32_t>(kDrawnSide * kDrawnSide, 0)};
  for (std::uint32_t y = 0; y < kDrawnSide; ++y)
    for (std::uint32_t x = 0; x < kDrawnSide; ++x) {
      const DrawnPixel f = at(x, y);
      if (f.height == kNoHeight) continue;
      const std::size_t i = std::size_t{y} * kDrawnSide + x;
      labels.of[i] = 1, images.own.values[i] = f.height, patch.occupancy.values[i] = f.bins;
      patch.accumulation.values[i] = patch.above.values[i] = patch.low.values[i] = 1;
    }
  return describe(labels, images, {}, {}).at(0);
}

inline double of(const ObjectCandidate& c, CandidateFeature f) {
  return c.features[static_cast<std::size_t>(f)];
}

}  // namespace ilot
