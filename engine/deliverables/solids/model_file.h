// SPDX-License-Identifier: Apache-2.0
// Models of buildings, read back from the formats they are delivered in.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/polygon_model.h"

namespace ilot {

struct ModelFile {
  std::vector<PolygonModel> models;   // in the file's order; names are unique
  std::vector<std::string> warnings;  // what was left out
};

// Largest number of corners of a face: more is a damaged file.
constexpr std::size_t kMaxCorners = 4096;

// By extension: .obj, or CityJSON and CityJSONSeq as .json and .jsonl. Input is hostile: indices, numbers and structure
// are checked, memory is bounded by the file's size. Error names file, place and fault; a usage Error when there is no
// such file.
ModelFile read_models(const std::filesystem::path& path);

// Is the file one that read_models() takes: .obj, .jsonl or .city.json? (Plain .json may be anything.)
bool is_model_file(const std::filesystem::path& path);

// One model per `o` or `g` (equal names are one model), or one named `stem` where there is neither. Only v, f, o and g
// are looked at; `name` stands in messages. Faces of fewer corners than `least_corners` are a fault of the file.
ModelFile parse_obj(std::string_view text, const std::string& name, const std::string& stem,
                    std::size_t least_corners = 3);

// One model per building, its parts included, of the highest level of detail of each object; where the file has no
// buildings, one per object that has a geometry. Geometry templates are left out with a warning. 1.0 to 2.0.
ModelFile parse_city_json(std::string_view text, const std::string& name);

}  // namespace ilot
