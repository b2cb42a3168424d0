// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/spatial_reference.h"

namespace ilot {

std::unique_ptr<OGRSpatialReference> spatial_reference(const Crs& crs) {
  auto reference = std::make_unique<OGRSpatialReference>();
  reference->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const bool known = !crs.wkt.empty() ? reference->importFromWkt(crs.wkt.c_str()) == OGRERR_NONE
                                      : crs.epsg != 0 && reference->importFromEPSG(crs.epsg) == OGRERR_NONE;
  return known ? std::move(reference) : nullptr;
}

}  // namespace ilot
