// SPDX-License-Identifier: Apache-2.0
// Areas that users give. Faults are Errors with ExitCode::usage.
#pragma once
#include <string>
#include <string_view>

#include "ilot/run.h"

namespace ilot {

// Does what read_area() of ilot/run.h does, for a text: GeoJSON (a Polygon or MultiPolygon, alone or in features and
// collections; any other content is an error) or WKT (POLYGON, MULTIPOLYGON; the SRID of EWKT is ignored). A third
// coordinate is dropped. O(bytes). `name` is the name of the file in messages.
Area parse_area(std::string_view text, const std::string& name);

}  // namespace ilot
