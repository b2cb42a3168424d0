// SPDX-License-Identifier: Apache-2.0
// The labels that buildings give to points, on the way from a task to the merge, whose stores have other blocks. A
// point is known by its place and its number among the points of this place, which is the same in both stores.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <vector>

#include "engine/products/roofs/roof_labels.h"
#include "engine/store/store.h"

namespace ilot {

// Labels of one building, in global order.
struct PlacedLabels {
  std::uint32_t site = 0;  // place of the building in the part
  Tile tile;
  std::vector<std::uint64_t> codes;    // of each point
  std::vector<SitePointLabel> labels;  // `point` is the number among the points with this code
};

// Reads labels that model_buildings has stored and RoofLabels has committed.
PlacedLabels stored_labels(const Store& store, std::uint32_t site, const LabelRun& run);

// Turns the numbers among points with the same code into numbers in a block with these codes. Leaves out labels of
// points that the block does not have.
void find_points(std::span<const std::uint64_t> block, std::span<const std::uint64_t> codes,
                 std::vector<SitePointLabel>& labels);

nlohmann::json record_of(const PlacedLabels& labels);
bool is_placed_labels(const nlohmann::json& record);

// Throws nlohmann::json::exception where a field is missing, and Error where the lists do not belong together.
PlacedLabels placed_labels(const nlohmann::json& record);

}  // namespace ilot
