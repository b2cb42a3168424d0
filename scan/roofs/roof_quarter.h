// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "scan/roofs/roof_town.h"

namespace ilot::scan {

constexpr double kStreetPitch = 56;  // metres from the axis of one street to the next
constexpr double kRoofHalfRoad = 3.5, kRoofHalfStreet = 5.5, kHalfAvenue = 9;

// One of four quarters. They are numbered by row, then by column. The quarter has its own coordinates, with u along its
// streets and the origin at its centre. The axes of the streets are at integer multiples of kStreetPitch.
struct Quarter {
  RoofFrame frame;
  Rect area;  // of the town, without the avenues
};
Quarter make_quarter(std::size_t index, double side);

// Places buildings with these roofs, in this order, along both sides of the streets, starting with the middle street.
// Places fewer buildings if there is not enough room.
std::vector<RoofBuilding> fill_quarter(const RoofTownParams& params, const Ground& ground, std::size_t index,
                                       double side, std::span<const RoofKind> kinds);

}  // namespace ilot::scan
