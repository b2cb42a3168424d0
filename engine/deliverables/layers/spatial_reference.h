// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ogr_spatialref.h>

#include <memory>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Returns the CRS as a GDAL object, x before y; nullptr when the CRS is unknown.
std::unique_ptr<OGRSpatialReference> spatial_reference(const Crs& crs);

}  // namespace ilot
