// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <embree3/rtcore.h>

#include "kernels/geometry/box3.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// One device serves the whole process, as Embree advises; it lives until the end. Throws Error.
RTCDevice embree_device();

// The box in floats about the anchor, grown by the margin.
void set_embree_bounds(const Box3<Vec3>& box, Vec3 anchor, double margin, RTCBounds& out);

// A ray to everything along it, about the anchor.
RTCRayHit embree_query(const Ray& ray, Vec3 anchor);

// Throws Error when Embree could not do what was asked.
void check_embree(const char* what, std::size_t count);

}  // namespace ilot::scan
