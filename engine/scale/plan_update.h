// SPDX-License-Identifier: Apache-2.0
// What a new plan takes from an old one: how the run is made, values that were measured over all points, and the parts
// of areas in which nothing changed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/scale/make_plan.h"
#include "engine/scale/plan.h"

namespace ilot {

// Products, settings, CRS and size of areas become those of the old plan, and so do the inputs and the footprints where
// none are given.
void take_options(const Plan& old, PlanOptions& options);

// Values of `auto` that the old plan measured over all points become settings. Returns them, as the old plan tells
// them.
std::vector<ChosenRecord> keep_statistics(const Plan& old, Settings& settings);

// Gives the new plan the parts of the old one whose areas have the key of a new area, as further names of the same
// files or as copies. Returns their number.
std::uint64_t keep_parts(const std::filesystem::path& old_folder, const Plan& old, const Plan& plan,
                         const std::filesystem::path& folder);

}  // namespace ilot
