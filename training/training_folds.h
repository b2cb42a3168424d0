// SPDX-License-Identifier: Apache-2.0
// Inside of the training: samples dealt out in folds.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"

namespace ilot {

// Groups in their order, dealt out one by one; single samples where there are fewer groups than folds.
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

// Some of a list of samples, their places in it; with their parts among them: what has lost a part joins none.
struct ChosenSamples {
  std::vector<std::size_t> places;
  std::vector<TrainingSample> samples;
};
enum class Chosen : std::uint8_t { of_fold, of_others };
ChosenSamples choose(std::span<const TrainingSample> all, const TrainingFolds& folds, std::uint32_t fold, Chosen which);

std::vector<CandidateFeatures> features_of(std::span<const TrainingSample> samples);
std::vector<CandidateParts> parts_of(std::span<const TrainingSample> samples);

}  // namespace ilot
