// SPDX-License-Identifier: Apache-2.0
// Models of buildings, read from the formats in which they are delivered.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/model/polygon_model.h"

namespace ilot {

struct ModelFile {
  std::vector<PolygonModel> models;               // in the file's order; names are unique
  std::vector<std::string> warnings;              // what was left out
  std::string crs = {};                           // of CityJSON, for crs_from_text(): "EPSG:7415"; empty = not given
  std::vector<std::string> material_files = {};   // of OBJ: as mtllib names them
  std::vector<std::pair<Vec3, Vec3>> lines = {};  // of OBJ: the segments of its polylines (l), of all groups
};

struct ModelReading {
  std::string lod;  // read only geometries of this level ("2" is also 2.0 to 2.3); empty = the highest of each
  bool every_object = false;  // also the objects beside buildings: terrain, roads, vegetation
};

// Largest number of corners of a face. A face with more comes from a damaged file.
constexpr std::size_t kMaxCorners = 4096;

// The extension selects the format: .obj, or CityJSON and CityJSONSeq as .json and .jsonl. The input is not trusted:
// indices, numbers and structure are checked, and memory is bounded by the size of the file. An Error names file, place
// and fault; it is a usage Error when there is no such file.
ModelFile read_models(const std::filesystem::path& path, const ModelReading& wanted = {});

// Tells whether read_models() takes the file: .obj, .jsonl or .city.json. (Plain .json may be anything.)
bool is_model_file(const std::filesystem::path& path);

// Returns one model for each `o` or `g` (equal names are one model), or one named `stem` when there is neither. Only v,
// f, l, o, g, usemtl and mtllib are read. `name` is for messages. A face with fewer corners than `least_corners` is a
// fault of the file.
ModelFile parse_obj(std::string_view text, const std::string& name, const std::string& stem,
                    std::size_t least_corners = 3);

// Returns one model for each building, with its parts, at the highest level of detail of each object. When the file has
// no buildings, it returns one for each object with a geometry. Geometry templates are put where their instances are.
// When nothing has the wanted level of detail, an Error names those that there are. Versions 1.0 to 2.0 are read.
ModelFile parse_city_json(std::string_view text, const std::string& name, const ModelReading& wanted = {});

}  // namespace ilot
