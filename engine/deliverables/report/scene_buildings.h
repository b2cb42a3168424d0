// SPDX-License-Identifier: Apache-2.0
// The buildings of a result: what its report says of each, and their shapes in few bytes.
#pragma once
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "engine/deliverables/report/result_folder.h"
#include "engine/model/building.h"

namespace ilot {

// One building: a row of the report's table. Numbers that are not known are NaN.
struct BuildingRow {
  std::string id, status, quality, reason;  // reason: why no LoD2.2, else what decided the quality
  std::uint32_t unit = 0;
  std::uint64_t points = 0, faces = 0;
  double rmse_m = 0, p95_m = 0, explained = 0, area_m2 = 0, height_m = 0, coverage = 0;
  std::string shape;  // packed by packed_shape()
  Vec3 middle;        // of the scene, metres
};

// Reads roofs.city.jsonl line by line. Memory: the rows. O(corners).
std::vector<BuildingRow> building_rows(const ResultFolder& result, const SceneFrame& frame);

// Returns the finest solid of a building, or its outline, as whole centimetres from the scene's origin: the corners,
// then the faces. Numbers: packed.h.
std::string packed_shape(const Building& building, const SceneFrame& frame);

// The solid or outline again, in CRS units, with faces of the kinds that it had.
Building unpacked_shape(std::string_view bytes, const SceneFrame& frame);

// The rows as columns, without the shapes.
nlohmann::ordered_json building_columns(const std::vector<BuildingRow>& rows);

}  // namespace ilot
