// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "scan/roofs/roof_town.h"

namespace ilot::scan {

constexpr double kStreetPitch = 56;  // metres from the axis of one street to the next
constexpr double kRoofHalfRoad = 3.5, kRoofHalfStreet = 5.5, kHalfAvenue = 9;

// One of four, numbered as columns within rows. Its own coordinates: u along its streets, from its centre; the axes of
// the streets lie at whole multiples of kStreetPitch.
struct Quarter {
  RoofFrame frame;
  Rect area;  // of the town, without the avenues
};
Quarter make_quarter(std::size_t index, double side);

// Buildings with these roofs, in this order, along both sides of the streets, from the middle one outwards. Fewer when
// there is no room for all.
std::vector<RoofBuilding> fill_quarter(const RoofTownParams& params, const Ground& ground, std::size_t index,
                                       double side, std::span<const RoofKind> kinds);

}  // namespace ilot::scan
