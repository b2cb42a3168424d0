// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/cloud/area.h"
#include "engine/run/open_inputs.h"

namespace ilot {

// Polygons in degrees (WGS 84, the CRS of GeoJSON) in the CRS of the inputs, which is said; others as they are.
// Polygons are in degrees when all their corners can be and the inputs are elsewhere. Error of ExitCode::usage when the
// CRS of the inputs is not known then.
Area area_in_crs(const Area& area, const RunInputs& inputs, Progress& progress, RunRecord& record);

}  // namespace ilot
