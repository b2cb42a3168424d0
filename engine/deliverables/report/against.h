// SPDX-License-Identifier: Apache-2.0
// Two results beside each other: which settings differ, what came, what went, what moved.
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "engine/deliverables/report/result_folder.h"
#include "engine/deliverables/report/scene_buildings.h"

namespace ilot {

// A unit of a result as it is compared: where it is, and what is said of it.
struct ComparedUnit {
  std::string id;     // for people
  std::string key;    // equal keys are one unit wherever they are; empty: the place decides
  std::string kind;   // units of different kinds are different ones
  std::string state;  // in words; a difference is a change
  Vec3 middle;        // metres of a common frame
};

struct UnitChanges {
  std::vector<std::pair<std::size_t, std::size_t>> same;  // numbers in `now` and `before`, by the first
  std::vector<std::size_t> came, went;                    // numbers in `now`, and in `before`
};

// First pairs units with equal keys, then, of the rest, those of one kind that are nearest to each other, at most
// `reach` metres apart: the nearest pair first, ties by their numbers. O(n log n) for units that are not all at one
// place.
UnitChanges compare_units(const std::vector<ComparedUnit>& now, const std::vector<ComparedUnit>& before, double reach);

// Returns the section "Against ...": settings, counts and units that differ. `rows` are the buildings of `now`.
std::string against_section(const ResultFolder& now, const std::vector<BuildingRow>& rows, const SceneFrame& frame,
                            const std::filesystem::path& before);

}  // namespace ilot
