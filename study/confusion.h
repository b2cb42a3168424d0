// SPDX-License-Identifier: Apache-2.0
// What classes were taken for what, and shares with their intervals over several runs.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/model/point_label.h"

namespace ilot {

// By the truth, then by what it was called.
using Confusion = std::map<PointLabel, std::map<PointLabel, std::uint64_t>>;

// Percentages by name, one a run.
using RunShares = std::map<std::string, std::vector<double>>;

void add(const Confusion& m, Confusion& all);
void print_confusion(const Confusion& m);

// Adds the share of each class that is right, and the total error.
void note_shares(const Confusion& m, RunShares& shares);

// Means with their 95 % intervals by Student's t; of 2 to 10 runs.
void print_intervals(const RunShares& shares);

}  // namespace ilot
