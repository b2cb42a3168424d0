// SPDX-License-Identifier: Apache-2.0
// City objects as files hold them, with all that may be wrong with their geometries: for validation.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/solid_model.h"

namespace ilot {

// What of an object breaks the rules of its format; `object` is empty for the file as a whole.
struct FormatFault {
  std::string object, text;
};

struct SolidFileSink {
  std::function<void(const CityObject&)> object;
  std::function<void(const FormatFault&)> fault;
};

// Does the name end like a file that read_solids() takes: .obj, .off, .poly, .json or .jsonl?
bool is_solid_file(const std::filesystem::path& path);

// The file's objects, one after the other. OBJ: one solid per o or g. OFF and POLY: one solid; shells that follow the
// first in a POLY are inner ones. CityJSON and CityJSONSeq, 1.0 to 2.0: every object, BuildingParts with their
// Building, templates in place of their instances; geometries that break a rule of the format are left out after the
// fault was given. A sequence is read line by line. Error with the place for a file that cannot be read; a usage Error
// when there is none or its name tells no format.
void read_solids(const std::filesystem::path& path, const SolidFileSink& sink);

CityObject parse_off(std::string_view text, const std::string& name);
CityObject parse_poly(std::string_view text, const std::string& name);

}  // namespace ilot
