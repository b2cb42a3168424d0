// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scan/streets/street_model.h"

namespace ilot::scan {

// Adds a house: a wall with windows and a door that are cut kReveal deep into it, string course, cornice and roof. The
// planes are the front with its openings, the planes inside the openings, the two sides and the slope of the roof.
void add_house(StreetModel& model, const Street& street, const StreetHouse& house);

// Adds a plane with the next free true_plane and records it in the truth.
TruePlane& add_plane(StreetModel& model, const char* surface_class, const Plane& plane, std::vector<Vec3> ring);

}  // namespace ilot::scan
