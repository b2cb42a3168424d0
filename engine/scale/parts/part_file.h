// SPDX-License-Identifier: Apache-2.0
// The part of a result that a task makes. It has no clock, host or path: two tasks of one area write the same bytes.
#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/products/roofs/sites/misalignment.h"

namespace ilot {

enum class PartState { missing, stale, damaged, whole };

// What the end of a part says of it.
struct PartSummary {
  std::uint64_t without_model = 0;  // buildings that were asked for and could not be made
  std::uint64_t cells = 0;          // of planes
  ShiftCounts shifts;               // of buildings
};

// The head of the part of an area with this key.
nlohmann::json part_head(const std::string& key);

// Whether the file is the part of an area with this key. Reads the whole file; fills in the summary where it is whole.
PartState part_state(const std::filesystem::path& path, const std::string& key, PartSummary& summary);

// The last record of a part.
nlohmann::json summary_record(const PartSummary& summary);
bool is_summary(const nlohmann::json& record);
PartSummary summary_of(const nlohmann::json& record);

}  // namespace ilot
