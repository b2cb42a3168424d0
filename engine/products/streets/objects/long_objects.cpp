// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/long_objects.h"

#include <algorithm>

namespace ilot {
namespace {

// Choice: a broad hedge; cars that are parked in a row are wider.
constexpr double kWidestStrip = 1.5;  // metres
// Choice: gates, and what stands before a fence and hides its foot.
constexpr double kStandingShare = 0.75;  // of its length

double feature(const ObjectCandidate& candidate, CandidateFeature which, std::size_t band = 0) {
  return candidate.features[static_cast<std::size_t>(which) + band];
}

}  // namespace

bool is_strip_on_ground(const ObjectCandidate& candidate, double pixel) {
  const double standing = std::max(feature(candidate, CandidateFeature::band_length, 0),
                                   feature(candidate, CandidateFeature::band_length, 1));
  return candidate.width <= kWidestStrip + 2 * pixel && standing >= kStandingShare * candidate.length;
}

void name_long_strips(std::span<const ObjectCandidate> candidates, double pixel, std::vector<CandidateClass>& classes) {
  for (std::size_t i = 0; i < classes.size(); ++i)
    if (candidates[i].length > kLongestObject && is_street_object(classes[i].label) &&
        is_strip_on_ground(candidates[i], pixel))
      classes[i].label = PointLabel::fence;
}

}  // namespace ilot
