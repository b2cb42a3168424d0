// SPDX-License-Identifier: Apache-2.0
#include "training/training_folds.h"

#include <algorithm>

namespace ilot {

TrainingFolds::TrainingFolds(std::span<const TrainingSample> samples, std::uint32_t folds) : folds_(folds) {
  for (const TrainingSample& s : samples) groups_.push_back(s.group);
  std::sort(groups_.begin(), groups_.end());
  groups_.erase(std::unique(groups_.begin(), groups_.end()), groups_.end());
}

std::uint32_t TrainingFolds::of(const TrainingSample& s, std::size_t place) const {
  if (by_group())
    place = static_cast<std::size_t>(std::lower_bound(groups_.begin(), groups_.end(), s.group) - groups_.begin());
  return static_cast<std::uint32_t>(place % folds_);
}

ChosenSamples choose(std::span<const TrainingSample> all, const TrainingFolds& folds, std::uint32_t fold,
                     Chosen which) {
  ChosenSamples out;
  std::vector<std::uint32_t> number(all.size() + 1, 0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if ((folds.of(all[i], i) == fold) != (which == Chosen::of_fold)) continue;
    out.places.push_back(i);
    out.samples.push_back(all[i]);
    number[i + 1] = static_cast<std::uint32_t>(out.samples.size());
    auto& [a, b] = out.samples.back().parts;
    a = number[a], b = number[b];
    if (a == 0 || b == 0) a = b = 0;
  }
  return out;
}

std::vector<CandidateFeatures> features_of(std::span<const TrainingSample> samples) {
  std::vector<CandidateFeatures> out;
  out.reserve(samples.size());
  for (const TrainingSample& s : samples) out.push_back(s.features);
  return out;
}

std::vector<CandidateParts> parts_of(std::span<const TrainingSample> samples) {
  std::vector<CandidateParts> out;
  for (const TrainingSample& s : samples) out.push_back(s.parts);
  return out;
}

}  // namespace ilot
