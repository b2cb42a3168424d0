// SPDX-License-Identifier: Apache-2.0
// From ground plans to the sites of a run: valid outlines with ids, in the order in which everything is written.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/footprint.h"
#include "engine/products/roofs/sites/outline_map.h"

namespace ilot {

struct PlannedSite {
  std::string id;         // of the footprint; further parts of it have -2, -3 ... behind it
  PlacedOutline outline;  // empty polygon: see reason
  std::string reason;     // why nothing can be built on it
  std::string repair;     // what was mended
};

// One site a part of each footprint, and one for each footprint that gives no outline: none is lost. Ordered by id,
// numbers by value: a function of the footprints alone.
std::vector<PlannedSite> plan_sites(std::span<const Footprint> footprints, double metres_per_unit);

// By id, numbers by value.
void order_sites(std::vector<PlannedSite>& sites);

// Square metres that two outlines share.
double shared_area(const PlacedOutline& a, const PlacedOutline& b);

}  // namespace ilot
