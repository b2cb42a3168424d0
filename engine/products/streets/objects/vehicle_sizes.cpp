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

// Choice: cars are lower. What is higher than a scanner is not seen from above: of a van the sides and what is behind
// its windows.
constexpr double kHighestSeen = 2.2;  // metres
// Choice: less is seen where only a side or an end was.
constexpr double kLeastSeen = 1.0 / 3;  // of the box around it
// Choice: bicycles in a rack are 30 to 50 cm apart; coarser pixels neither show their gaps nor the form of a car.
constexpr double kCoarsestOfGaps = 0.07;  // metres, side of a pixel
// Choice: cars of development streets that were seen so have 4.9 and more, racks of bicycles 1 to 2.
constexpr double kLevelsOfStep = 3;  // level steps between pixels for each jump of two pixels and more

double feature(const ObjectCandidate& candidate, CandidateFeature which) {
  return candidate.features[static_cast<std::size_t>(which)];
}

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

bool is_rough_vehicle(const ObjectCandidate& candidate, PointLabel label) {
  if (label != PointLabel::car && label != PointLabel::van) return false;
  if (feature(candidate, CandidateFeature::pixel_size) > kCoarsestOfGaps) return false;
  const double level = feature(candidate, CandidateFeature::level_share),
               step = feature(candidate, CandidateFeature::step_share);
  return candidate.features[static_cast<std::size_t>(ComponentFeature::max_height)] <= kHighestSeen &&
         feature(candidate, CandidateFeature::box_fill) >= kLeastSeen && level < kLevelsOfStep * step;
}

void deny_rough_vehicles(std::span<const ObjectCandidate> candidates, std::size_t number_of_classes,
                         std::vector<CandidateClass>& classes) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    CandidateClass& of = classes[i];
    if (!is_rough_vehicle(candidates[i], of.label)) continue;
    const bool two_wheeler = of.next == PointLabel::two_wheeler;
    of.label = two_wheeler ? of.next : PointLabel::other;
    of.probability = two_wheeler ? of.next_probability : 1 / static_cast<double>(number_of_classes);
  }
}

}  // namespace ilot
