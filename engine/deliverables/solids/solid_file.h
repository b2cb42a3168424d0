// SPDX-License-Identifier: Apache-2.0
// City objects as they are in files, with everything that may be wrong with their geometries. Validation uses them.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/solid_model.h"

namespace ilot {

// A violation of the rules of a format; `object` is empty for the file as a whole.
struct FormatFault {
  std::string object, text;
};

struct SolidFileSink {
  std::function<void(const CityObject&)> object;
  std::function<void(const FormatFault&)> fault;
};

// Tells whether the name ends like a file that read_solids() takes: .obj, .off, .poly, .json or .jsonl.
bool is_solid_file(const std::filesystem::path& path);

// Reads the objects of the file, one after the other. OBJ: one solid for each o or g. OFF and POLY: one solid; in a
// POLY the shells after the first are inner ones. CityJSON and CityJSONSeq, 1.0 to 2.0: every object, with
// BuildingParts as parts of their Building and templates in place of their instances. A geometry that breaks a rule of
// the format is left out after its fault is given. A sequence is read line by line. Throws Error with the place for a
// file that cannot be read. Throws a usage Error when there is no file or its name gives no format.
void read_solids(const std::filesystem::path& path, const SolidFileSink& sink);

// The extension of a file name in lower case, with its point.
std::string lower_extension(const std::filesystem::path& path);

// Reads a whole file. Throws Error when it cannot be read, a usage Error when there is none.
std::string read_text(const std::filesystem::path& path);

CityObject parse_off(std::string_view text, const std::string& name);
CityObject parse_poly(std::string_view text, const std::string& name);

}  // namespace ilot
