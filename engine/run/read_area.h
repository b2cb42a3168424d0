// SPDX-License-Identifier: Apache-2.0
// Areas as users give them. Faults are Errors with ExitCode::usage.
#pragma once
#include <string>
#include <string_view>

#include "ilot/run.h"

namespace ilot {

// read_area() of ilot/run.h on text: GeoJSON (a Polygon or MultiPolygon, alone or in features and collections; anything
// else in it is an error) or WKT (POLYGON, MULTIPOLYGON; EWKT's SRID is ignored). A third coordinate is dropped.
// O(bytes). `name` stands for the file in messages.
Area parse_area(std::string_view text, const std::string& name);

}  // namespace ilot
