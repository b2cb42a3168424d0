// SPDX-License-Identifier: Apache-2.0
// The samples on which a model of candidates is trained.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// The role of a candidate: parts are joined to whole objects, and these are joined to merged candidates.
enum class CandidateRole : std::uint8_t { whole, part, merged };

// A candidate whose class is known. `none` means a remnant that is no object at all.
struct TrainingSample {
  CandidateFeatures features{};
  PointLabel label = PointLabel::none;
  std::uint32_t group = 0;  // samples of one group always fall in the same fold; the number of a block
  CandidateRole role = CandidateRole::whole;
  CandidateParts parts{};  // positions in the list of samples, from 1, of the two that it joins; 0: none
};

// Trains a model on samples (training/object_model_training.h has such a function). Throws Error(usage) where nothing
// can be trained on them.
using TrainObjectModel = std::function<ObjectModel(std::span<const TrainingSample>)>;

}  // namespace ilot
