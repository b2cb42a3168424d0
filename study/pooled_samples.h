// SPDX-License-Identifier: Apache-2.0
// The samples of many streets in one list, from which a model learns.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "study/street_samples.h"

namespace ilot {

// From so many streets on, the folds of a training keep each street together.
constexpr std::size_t kManyStreets = 20;  // four in each fold

// Collects the samples of all streets and keeps their blocks separate. The list repeats the streets after `different`
// of them. With `streets_whole`, a street is one group.
std::vector<TrainingSample> pooled(const std::vector<std::vector<TrainingSample>>& streets, std::size_t different,
                                   bool streets_whole = false);

// Collects the samples of streets and of the same streets in other ways.
std::vector<TrainingSample> samples_of(std::span<const Street> streets, std::span<const Street> others,
                                       std::size_t different);

}  // namespace ilot
