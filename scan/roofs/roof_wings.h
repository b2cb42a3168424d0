// SPDX-License-Identifier: Apache-2.0
// The wings that roofs are made of. Lengths are millimetres. Slopes are in sixteenths: 12 is 3 in 4, or 36.9 degrees.
#pragma once
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

enum class Axis : std::uint8_t { u, v };                        // direction of a ridge
enum class Uphill : std::uint8_t { east, west, north, south };  // +u, -u, +v, -v

Wing flat_wing(const GridRect& rect, Integer height);
Wing shed_wing(const GridRect& rect, Integer eave, Integer slope, Uphill uphill);
Wing gable_wing(const GridRect& rect, Axis ridge, Integer eave, Integer slope);
Wing hip_wing(const GridRect& rect, Integer eave, Integer slope, Integer end_slope);
// The hips begin `lift` above the eaves.
Wing half_hip_wing(const GridRect& rect, Axis ridge, Integer eave, Integer slope, Integer lift);
// A hip whose slopes become flatter at the height `knee` above the eaves. knee / steep must be an integer.
Wing mansard_wing(const GridRect& rect, Integer eave, Integer steep, Integer shallow, Integer knee);
// The same form between two gables.
Wing gambrel_wing(const GridRect& rect, Axis ridge, Integer eave, Integer steep, Integer shallow, Integer knee);

// Returns the height of the ridge above the eaves.
Integer gable_rise(const GridRect& rect, Axis ridge, Integer slope);

Wing moved(Wing wing, Integer du, Integer dv, Integer dz);
Wing mirrored_u(Wing wing, Integer length);  // u becomes length - u
Wing mirrored_v(Wing wing, Integer depth);   // v becomes depth - v

}  // namespace ilot::scan
