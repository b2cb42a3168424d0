// SPDX-License-Identifier: Apache-2.0
// One CRS for all inputs, with one unit in all three axes.
#pragma once
#include <string>

#include "engine/run/open_inputs.h"

namespace ilot {

// "EPSG:2154", else the name; "none" when nothing is known.
std::string crs_name(const Crs& crs);

// Decides inputs.crs and changes the readers where their coordinates are not what products work on:
// - degrees that cannot be degrees are not believed: the CRS is then unknown;
// - with --to-crs places are reprojected; degrees without it are refused;
// - inputs without a CRS take that of the footprints, when these are where the inputs are (refused when not);
// - heights in another unit than positions are converted, and inputs.crs is then the CRS of the positions alone.
// All of it is said and recorded. Returns the factor that heights were multiplied by (units of x and y per unit of z).
// Errors are of ExitCode::usage.
double resolve_crs(RunInputs& inputs, const RunOptions& options, Progress& progress, RunRecord& record);

}  // namespace ilot
