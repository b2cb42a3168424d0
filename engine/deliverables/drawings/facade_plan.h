// SPDX-License-Identifier: Apache-2.0
// Elements of a facade in its plane: rings with real arcs, their lines by what is known of each edge, and the same
// rings widened by the errors of their edges.
#pragma once
#include <vector>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/model/facade.h"

namespace ilot {

// Returns, in CRS units, the mean distance of an element's ring in front of the wall; 0 without a ring.
double distance_from_wall(const Facade& facade, const FacadeElement& element);

// Tells whether an element is a hole in the wall, which is an opening on the plane of the wall. The openings of dormers
// are on planes of their own.
bool is_hole(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// x runs along the facade from its origin, y is the height, both in metres. Where `up` is vertical, y is the z of the
// CRS.
FlatPoint flat_place(const Facade& facade, Vec3 place, double metres_per_unit);

// An element in the plane of its facade. A stretch of its ring that lies on one of its arcs (both corners within 5 mm
// of the circle, between its ends) becomes one corner with a bulge, unless its edges have different origins. Corners
// nearer than 0.01 mm to the previous one are left out.
struct FlatElement {
  std::vector<DrawingCorner> corners;  // counter-clockwise
  std::vector<FacadeEdge> edges;       // as many; for an arc the largest values of its stretches and the smallest cover
  std::vector<DrawingArc> arcs;        // those on which no stretch of the ring lies
  FlatBox box;
};
FlatElement flat_element(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// Returns the ring; its arcs become chords of at most 5 degrees.
std::vector<FlatPoint> chords_of(const FlatElement& element);

// Returns the role with which an element of this kind is drawn.
DrawingRole role_of_kind(const std::string& kind);

// The same of an element: where the wall is not even (its region) it is an irregularity, whatever its kind.
DrawingRole role_of(const FacadeElement& element);

// Tells whether an element is an opening, by what is known of it or by its kind.
bool is_opening(const FacadeElement& element);

// Adds the lines of one element. When no edge is occluded, its whole closed line is on the layer of its kind, and
// completed stretches are repeated on their own layer. When an edge is occluded, open chains are drawn by status. A
// completed element is closed on the layer of completed ones. An occluded element is hatched on the layer of shadows
// and is never drawn as what it may be.
void draw_element(const FacadeElement& element, const FlatElement& flat, Drawing& drawing);

// Returns the ring with every edge moved outwards by its error; empty where no error is known. Its corners are where
// neighbouring edges meet, at most four times the larger error away. Its arcs are chords. O(n).
std::vector<FlatPoint> widened_ring(const FlatElement& element);

}  // namespace ilot
