// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "engine/products/streets/classes/object_model.h"

namespace ilot {

// Whether a candidate is longer or wider than a vehicle of this class can be: longer than a road train or wider than
// one with its mirrors (van), longer than cars are built. `pixel` is the side of a pixel in metres: an extent may be
// one too great at each end. False for all other classes.
bool exceeds_vehicle(const ObjectCandidate& candidate, PointLabel label, double pixel);

struct VehicleLimits {
  double pixel = 0;                   // metres
  std::size_t number_of_classes = 1;  // of the model
  bool parts_too = true;              // whether a candidate that joins none loses its class
};

// Takes the class from vehicles that are too large to be one. A join is not whole then, but merged from several things,
// so that select_objects prefers its parts. A candidate that joins none becomes `other`, as what is unlike anything
// that the model was trained with, with the probability 1 / (number of classes). From the air it keeps its class: what
// stands within a pixel or two is one part there, and a car with a bush beside it is a car.
void deny_too_large_vehicles(std::span<const ObjectCandidate> candidates, const VehicleLimits& limits,
                             std::vector<CandidateClass>& classes);

// Whether a candidate of the height of a car has gaps where a vehicle is closed: seen from above, its top jumps between
// pixels side by side often, compared with how often it is level. The roof, the bonnet and the windows of a car are
// surfaces, and it jumps at their outlines only. Where little of the box around it was seen, this is not known. False
// for all other classes.
bool is_rough_vehicle(const ObjectCandidate& candidate, PointLabel label);

// Takes the class from vehicles that have gaps, as racks of bicycles have: they become two-wheelers where these are the
// most probable class but for vehicles, and else `other` with the probability 1 / number_of_classes.
void deny_rough_vehicles(std::span<const ObjectCandidate> candidates, std::size_t number_of_classes,
                         std::vector<CandidateClass>& classes);

}  // namespace ilot
