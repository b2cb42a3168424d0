// SPDX-License-Identifier: Apache-2.0
// The attributes of a building beside its shape.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"
#include "engine/products/roofs/solids/roof_quality.h"

namespace ilot {

using BuildingAttributes = std::vector<std::pair<std::string, AttributeValue>>;

const char* name_of(RoofStatus status);

// Returns the attributes of docs/outputs.md: status, reason, points, heights, area, and how well points and model
// agree. Heights are in CRS units.
BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit,
                                       PointMeasures& measures);

// Returns the volume of each level of detail that is a solid.
BuildingAttributes volumes(std::span<const Building> levels, double metres_per_unit);

// Returns the outline as a flat surface on the ground, lod 0.
Building flat_outline(const RoofSite& site, double metres_per_unit);

}  // namespace ilot
