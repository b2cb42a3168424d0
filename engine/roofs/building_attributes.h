// SPDX-License-Identifier: Apache-2.0
// What is told of a building beside its shape, and of its points beside their faces.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/point_label.h"
#include "engine/roofs/roof_model.h"
#include "engine/roofs/roof_site.h"

namespace ilot {

using BuildingAttributes = std::vector<std::pair<std::string, AttributeValue>>;

const char* name_of(RoofStatus status);

// status, reason, points, heights, area, how well points and model agree: docs/outputs.md. Heights in CRS units.
BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit);

// Per point of the site: roof where it has a face; wall where it has none and stands within 0.3 m of a wall of the
// model, not above it; else none, or roof where the model is one level block. O(points x walls) for the points without
// a face.
std::vector<PointLabel> point_labels(const RoofSite& site, const RoofModel& model, double metres_per_unit);

// The outline as a flat surface on the ground, lod 0: what is left of a building without a solid.
Building flat_outline(const RoofSite& site, double metres_per_unit);

}  // namespace ilot
