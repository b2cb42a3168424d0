// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/model/street.h"

namespace ilot {

// The plan as a picture: blocks, gaps and the extents of objects, coloured by class; one unit a metre, north up. The
// same for the same plan, on every machine.
std::string street_map_svg(const StreetPlan& plan, double metres_per_unit);

// streets.svg and, with the counts of what is on it, streets.html. Each file is whole or absent.
void write_street_map(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit);

}  // namespace ilot
