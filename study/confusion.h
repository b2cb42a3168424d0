// SPDX-License-Identifier: Apache-2.0
// Confusion matrices, and shares with their confidence intervals over several runs.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/model/point_label.h"

namespace ilot {

// Counts by the true class, then by the assigned class.
using Confusion = std::map<PointLabel, std::map<PointLabel, std::uint64_t>>;

// Percentages by name, one per run.
using RunShares = std::map<std::string, std::vector<double>>;

void add(const Confusion& m, Confusion& all);
void print_confusion(const Confusion& m);

// Adds the share of correct points of each class, and the total error.
void note_shares(const Confusion& m, RunShares& shares);

// Prints means with their 95 % intervals by Student's t. There must be 2 to 10 runs.
void print_intervals(const RunShares& shares);

}  // namespace ilot
