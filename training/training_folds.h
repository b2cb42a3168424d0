// SPDX-License-Identifier: Apache-2.0
// Internal to the training: the division of samples into folds.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"

namespace ilot {

// Deals out groups to the folds one by one, in their order. It deals out single samples where there are fewer groups
// than folds.
class TrainingFolds {
 public:
  TrainingFolds(std::span<const TrainingSample> samples, std::uint32_t folds);
  bool by_group() const { return groups_.size() >= folds_; }
  std::uint32_t of(const TrainingSample& s, std::size_t place) const;
  std::uint32_t count() const { return folds_; }

 private:
  std::uint32_t folds_;
  std::vector<std::uint32_t> groups_;  // rising
};

// Some samples of a list and their positions in it. Their parts refer to the chosen samples. A sample that has lost a
// part counts as no join.
struct ChosenSamples {
  std::vector<std::size_t> places;
  std::vector<TrainingSample> samples;
};
enum class Chosen : std::uint8_t { of_fold, of_others };
ChosenSamples choose(std::span<const TrainingSample> all, const TrainingFolds& folds, std::uint32_t fold, Chosen which);

std::vector<CandidateFeatures> features_of(std::span<const TrainingSample> samples);
std::vector<CandidateParts> parts_of(std::span<const TrainingSample> samples);

}  // namespace ilot
