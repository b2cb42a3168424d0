// SPDX-License-Identifier: Apache-2.0
// Areas as users give them. Faults are Errors with ExitCode::usage.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/cloud/area.h"

namespace ilot {

// "X0,Y0,X1,Y1" in the units of the CRS, corners in any order; the box must have a size.
Area parse_bounds(std::string_view text);

// GeoJSON (a Polygon or MultiPolygon, alone or in features and collections; anything else in it is an error)
// or WKT (POLYGON, MULTIPOLYGON; EWKT's SRID is ignored). Coordinates are taken to be those of the clouds; a
// third one is dropped. At most 64 MiB. O(bytes).
Area read_area(const std::filesystem::path& path);

// The same on text; `name` stands for the file in messages.
Area parse_area(std::string_view text, const std::string& name);

}  // namespace ilot
