// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/streets/street_model.h"

namespace ilot::scan {

// Adds a house: a wall with windows and a door cut kReveal deep out of it, string course, cornice and roof. Planes: the
// front with its openings, what lies in them, the two sides, the roof's slope.
void add_house(StreetModel& model, const Street& street, const StreetHouse& house);

// The next free true_plane, with its place in the truth.
TruePlane& add_plane(StreetModel& model, const char* surface_class, const Plane& plane, std::vector<Vec3> ring);

}  // namespace ilot::scan
