// SPDX-License-Identifier: Apache-2.0
// What a model of things is learnt from.
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// What a thing is of what stands there: parts are joined to wholes, and these to several in one.
enum class CandidateRole : std::uint8_t { whole, part, merged };

// A thing whose class is known. `none`: a remnant that is no thing at all.
struct TrainingSample {
  CandidateFeatures features{};
  PointLabel label = PointLabel::none;
  std::uint32_t group = 0;  // things of one group are never parted by a fold: the number of a block
  CandidateRole role = CandidateRole::whole;
  CandidateParts parts{};  // places in the list of samples, from 1, of those it joins; 0: none
};

// Learns a model from samples (training/object_model_training.h has one). Error(usage) where nothing can be learnt from
// them.
using TrainObjectModel = std::function<ObjectModel(std::span<const TrainingSample>)>;

}  // namespace ilot
