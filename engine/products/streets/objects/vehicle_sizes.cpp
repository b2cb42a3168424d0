// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/vehicle_sizes.h"

#include <algorithm>

namespace ilot {
namespace {

// Derived: Directive 96/53/EC of the European Union: 2.55 m, and two mirrors that stand out by 0.25 m each.
constexpr double kWidest = 3.05;  // metres
// Derived: the same directive, for a lorry with its trailer.
constexpr double kLongest = 18.75;  // metres
// Choice: the longest pick-ups and saloons that are built in series.
constexpr double kLongestCar = 6;  // metres

}  // namespace

bool exceeds_vehicle(const ObjectCandidate& candidate, PointLabel label, double pixel) {
  if (label != PointLabel::car && label != PointLabel::van) return false;
  const double ends = 2 * pixel;
  return candidate.width > kWidest + ends ||
         candidate.length > (label == PointLabel::car ? kLongestCar : kLongest) + ends;
}

void deny_too_large_vehicles(std::span<const ObjectCandidate> candidates, const VehicleLimits& limits,
                             std::vector<CandidateClass>& classes) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    CandidateClass& of = classes[i];
    const bool joins = candidates[i].parts[0] != 0;
    if (!exceeds_vehicle(candidates[i], of.label, limits.pixel) || (!joins && !limits.parts_too)) continue;
    of.label = PointLabel::other;
    of.probability = 1 / static_cast<double>(limits.number_of_classes);
    if (!joins) continue;
    of.merged = std::max(of.merged, of.whole);
    of.whole = 0;
  }
}

}  // namespace ilot
