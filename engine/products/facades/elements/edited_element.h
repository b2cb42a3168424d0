// SPDX-License-Identifier: Apache-2.0
// Elements of a facade as a person draws or moves them. Boxes are in metres in the axes of the facade.
#pragma once
#include "engine/model/facade.h"
#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// The box around the ring of an element, which has one.
Box2 box_in(const Facade& facade, const FacadeElement& element, double metres_per_unit);

// The area that two boxes have in common, divided by the area that they cover together.
double shared_area(const Box2& a, const Box2& b);

// An opening that a person drew: a rectangle on the wall. Nothing is known of its depth, and its edges state no error.
FacadeElement drawn_opening(const Facade& facade, const std::string& kind, const Box2& box, double metres_per_unit);

// Moves the sides of an element to those of the box. Sides that move by more than `same_m` are by hand and state no
// error; the others keep what was measured. An element that keeps its size keeps its form, otherwise its ring is
// stretched, its arcs become corners, and the body behind it is dropped.
void move_element(const Facade& facade, const Box2& to, double same_m, double metres_per_unit, FacadeElement& element);

// Gives an opening another kind. A place that nobody saw becomes an opening with edges by hand.
void rename_opening(const std::string& kind, FacadeElement& element);

}  // namespace ilot
