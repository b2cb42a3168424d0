// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "engine/model/street.h"

namespace ilot {

// Returns the plan as a picture: blocks, gaps and the extents of objects, coloured by class. One unit is a metre, north
// is up. The same plan gives the same picture on every machine.
std::string street_map_svg(const StreetPlan& plan, double metres_per_unit);

// The same as a sheet that explains itself: with the numbers of the objects, a legend, the north and the scale. `notes`
// are short lines below the legend.
std::string street_sheet_svg(const StreetPlan& plan, double metres_per_unit, std::span<const std::string> notes = {});

// Returns HTML with the counts of what is on the map and the colours of the classes.
std::string street_legend_html(const StreetPlan& plan);

// Writes the sheet as streets.svg, complete or not at all. A plan of several areas (street_areas.h) becomes a sheet for
// each of them: streets_1.svg, streets_2.svg ..., which say so.
void write_street_map(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit,
                      std::span<const std::string> notes = {});

}  // namespace ilot
