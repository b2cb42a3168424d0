// SPDX-License-Identifier: Apache-2.0
// Elements of a facade in its plane: rings with real arcs, their lines by what is known of each edge, and the same
// widened by the errors of their edges.
#pragma once
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/model/facade.h"

namespace ilot {

// CRS units: how far the ring of an element lies before the wall, in the mean; 0 without a ring.
double distance_from_wall(const Facade& facade, const FacadeElement& element);

// Whether an element is a hole in the wall: an opening on the wall's plane. Those of dormers lie on planes of their
// own.
bool is_hole(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// x along the facade from its origin, y the height, both in metres: where `up` is upright, y is the z of the CRS.
FlatPoint flat_place(const Facade& facade, Vec3 place, double metres_per_unit);

// An element in the plane of its facade. Stretches of its ring that lie on one of its arcs (both corners within 5 mm of
// the circle, between its ends) are one corner with a bulge, unless edges of them have come about in different ways.
// Corners nearer than 0.01 mm to the one before are left out.
struct FlatElement {
  std::vector<DrawingCorner> corners;  // counter-clockwise
  std::vector<FacadeEdge> edges;       // as many; of an arc the largest figures of its stretches, the least cover
  std::vector<DrawingArc> arcs;        // those that no stretch of the ring lies on
  FlatBox box;
};
FlatElement flat_element(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// The ring with arcs as chords of at most 5 degrees.
std::vector<FlatPoint> chords_of(const FlatElement& element);

// What an element's kind is drawn as.
DrawingRole role_of_kind(const std::string& kind);

// Adds one element's lines: whole and closed on the layer of its kind when no edge of it is occluded, completed
// stretches once more on theirs; open chains by status when one is. A completed element is closed on the layer of
// completed ones, an occluded one is hatched on that of shadows, never drawn as what it may be.
void draw_element(const FacadeElement& element, const FlatElement& flat, Drawing& drawing);

// The ring with every edge moved outwards by its error; empty where no error is known. Corners are where neighbouring
// edges meet, at most four times the larger error away, arcs are chords. O(n).
std::vector<FlatPoint> widened_ring(const FlatElement& element);

}  // namespace ilot
