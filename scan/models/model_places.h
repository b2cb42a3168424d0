// SPDX-License-Identifier: Apache-2.0
// Where scanners stand or drive when nobody says it.
#pragma once
#include <vector>

#include "scan/models/model_stage.h"

namespace ilot::scan {

struct AutomaticPlaces {
  double distance = 0;  // metres from the building; 0 = three quarters of its height, from 5 to 20 m
  double height = 1.8;  // metres above the ground
};

struct PlacedStation {
  Vec3 position;
  std::uint32_t building = 0;
  double distance = 0;  // metres from the footprint
};

// Stands around each building on a line that keeps the distance from the convex footprint, one and a half distances
// from one to the next. Sides that no window and no door faces get no station, unless the building has no openings at
// all. Places inside or under a building are left out, and those nearer to an earlier one than half a distance.
std::vector<PlacedStation> automatic_stations(const ModelStage& stage, const AutomaticPlaces& wanted);

// Drives once around the convex outline of all footprints, at the distance. Returns a closed path.
std::vector<Vec3> automatic_path(const ModelStage& stage, const AutomaticPlaces& wanted);

// True when something of the model is above the place, or the place is below the ground of the model's terrain.
bool is_covered(const PartScene& scene, const ModelStage& stage, Vec3 place);

}  // namespace ilot::scan
