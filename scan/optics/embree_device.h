// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <embree3/rtcore.h>

#include "kernels/geometry/box3.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// Returns the device. One device serves the whole process, as Embree advises, and it exists until the process ends.
// Throws Error.
RTCDevice embree_device();

// Writes the box as floats relative to the anchor, grown by the margin.
void set_embree_bounds(const Box3<Vec3>& box, Vec3 anchor, double margin, RTCBounds& out);

// Makes an Embree ray relative to the anchor. Its length is not limited.
RTCRayHit embree_query(const Ray& ray, Vec3 anchor);

// Throws Error if Embree reports an error.
void check_embree(const char* what, std::size_t count);

}  // namespace ilot::scan
