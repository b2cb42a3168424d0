// SPDX-License-Identifier: Apache-2.0
// How well the stations of a wall agree with each other.
#pragma once
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// The bound of 95 % for what the place and the turn of a station move its points by, in metres along one axis. Where
// several stations saw the wall it comes from how far apart their points of the same half square metres of wall lie,
// square to it, with what such scans have in general as two more measurements; with one station from that alone.
// Without stations it is 0. O(points of the wall).
double registration_error(const RaySamples& samples);

}  // namespace ilot
