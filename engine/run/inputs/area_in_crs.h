// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/cloud/area.h"
#include "engine/run/inputs/open_inputs.h"

namespace ilot {

// Transforms polygons in degrees (WGS 84, the CRS of GeoJSON) to the CRS of the inputs and reports it; other polygons
// do not change. Polygons are in degrees when all their corners can be degrees and the inputs are elsewhere. Throws
// Error with ExitCode::usage when they are in degrees and the CRS of the inputs is not known.
Area area_in_crs(const Area& area, const RunInputs& inputs, Progress& progress, RunRecord& record);

}  // namespace ilot
