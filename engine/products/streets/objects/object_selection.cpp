// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/object_selection.h"

#include <algorithm>
#include <utility>

#include "kernels/core/portable_math.h"

namespace ilot {

namespace {

// Derived: keeps logarithms finite.
constexpr double kLeast = 1e-30;  // lower bound of a weight

double weight_of(double probability) {
  return natural_log(std::max(kLeast, probability));
}

}  // namespace

std::vector<std::uint8_t> select_objects(std::span<const ObjectCandidate> candidates,
                                         std::span<const CandidateClass> classes) {
  // For each candidate, `parts` is the weight of the case that it and all candidates below it are parts; `best` is the
  // greatest weight of any cut through its tree.
  std::vector<double> parts(candidates.size(), 0), best(candidates.size(), 0);
  std::vector<std::uint8_t> better(candidates.size(), 1), taken(candidates.size(), 0), inside(candidates.size(), 0);
  for (std::size_t i = 0; i < candidates.size(); ++i) {  // parts come first
    const auto [a, b] = std::pair{candidates[i].parts[0], candidates[i].parts[1]};
    const double below = a == 0 ? 0 : parts[a - 1] + parts[b - 1];
    parts[i] = weight_of(classes[i].part) + below;
    best[i] = weight_of(classes[i].whole) + below;
    if (a == 0) continue;
    const double apart = weight_of(classes[i].merged) + best[a - 1] + best[b - 1];
    better[i] = best[i] >= apart;
    best[i] = std::max(best[i], apart);
  }
  for (std::size_t i = candidates.size(); i-- > 0;) {
    const ObjectCandidate& t = candidates[i];
    taken[i] = inside[i] == 0 && better[i] != 0;
    if (t.parts[0] == 0) continue;
    for (const std::uint32_t part : t.parts) inside[part - 1] = inside[i] != 0 || taken[i] != 0;
  }
  return taken;
}

std::vector<std::uint32_t> candidate_of_part(std::span<const ObjectCandidate> candidates,
                                             std::span<const std::uint8_t> taken) {
  std::vector<std::uint32_t> holder(candidates.size() + 1, 0), of{0};
  for (std::size_t i = candidates.size(); i-- > 0;) {
    if (taken[i] != 0) holder[i + 1] = static_cast<std::uint32_t>(i + 1);
    for (const std::uint32_t part : candidates[i].parts)
      if (part != 0 && holder[i + 1] != 0) holder[part] = holder[i + 1];
  }
  for (std::size_t i = 0; i < candidates.size() && candidates[i].parts[0] == 0; ++i) of.push_back(holder[i + 1]);
  return of;
}

}  // namespace ilot
