// SPDX-License-Identifier: Apache-2.0
// Turns footprints into the sites of a run: valid outlines with ids, in the order in which everything is written.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/footprint.h"
#include "engine/products/roofs/sites/outline_map.h"

namespace ilot {

struct PlannedSite {
  std::string id;         // of the footprint; its further parts have the suffixes -2, -3 ...
  PlacedOutline outline;  // an empty polygon: see `reason`
  std::string reason;     // why no building can be made on it
  std::string repair;     // what was repaired
  std::vector<std::pair<std::string, AttributeValue>> attributes = {};  // of the footprint
};

// Returns one site for each part of each footprint, and one for each footprint that gives no outline, so that none is
// lost. The sites are ordered by id, with numbers in ids compared by value. The result is a function of the footprints
// alone.
std::vector<PlannedSite> plan_sites(std::span<const Footprint> footprints, double metres_per_unit);

// Sorts the sites by id, with numbers in ids compared by value.
void order_sites(std::vector<PlannedSite>& sites);

// The area in square metres that two outlines share.
double shared_area(const PlacedOutline& a, const PlacedOutline& b);

}  // namespace ilot
