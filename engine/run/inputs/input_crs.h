// SPDX-License-Identifier: Apache-2.0
// Chooses one CRS for all inputs, with one unit in all three axes.
#pragma once
#include <string>

#include "engine/report/run_record.h"
#include "engine/run/inputs/open_inputs.h"

namespace ilot {

// Returns "EPSG:2154", else the name; "none" when nothing is known.
std::string crs_name(const Crs& crs);

// What run.json says of the CRS of the results.
CrsRecord crs_record(const Crs& crs);

// Chooses inputs.crs and changes the readers when products cannot work on their coordinates:
// - Degrees that are outside their range are not accepted: the CRS is then unknown.
// - With --to-crs, places are reprojected; without it, degrees are refused.
// - Inputs without a CRS take that of the footprints. They are refused when the footprints are at another place.
// - The readers say inputs.crs, and so do labelled clouds.
// - Heights in another unit than positions are converted, and inputs.crs is then the CRS of the positions alone.
// All of this is reported and recorded. Returns the factor by which heights were multiplied (units of x and y per unit
// of z). Errors have ExitCode::usage.
double resolve_crs(RunInputs& inputs, const RunOptions& options, Progress& progress, RunRecord& record);

}  // namespace ilot
