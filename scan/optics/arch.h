// SPDX-License-Identifier: Apache-2.0
// The heads of openings that are made of several arcs.
#pragma once
#include <vector>

#include "scan/optics/part.h"

namespace ilot::scan {

// An arc of a circle in the plane of the opening. Angles count counter-clockwise from the direction to the right.
struct ArchArc {
  FlatPoint centre;
  double radius = 0, from_deg = 0, to_deg = 0;
};

// Returns the arcs of the head from right to left. There are none for a flat head, one for a circular arch, two for a
// pointed one and three for a basket arch, whose outer arcs have seven tenths of its rise as their radius.
std::vector<ArchArc> arcs_of(const Opening& opening);

// Returns whether a point above the springing is below a pointed or basket arch.
bool below_arch(const Opening& opening, FlatPoint p);

}  // namespace ilot::scan
