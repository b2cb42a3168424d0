// SPDX-License-Identifier: Apache-2.0
// Where elements are in the axes of their facade, in metres.
#pragma once
#include <vector>

#include "engine/model/facade.h"
#include "engine/products/facades/openings/openings.h"

namespace ilot {

inline Place2 local_place(const Facade& f, Vec3 place, double metres_per_unit) {
  const Vec3 d = metres_per_unit * (place - f.origin);
  return {dot(d, f.right), dot(d, f.up)};
}

// The box around the ring of an element, along the axes of its facade.
inline Box2 local_box(const Facade& f, const FacadeElement& e, double metres_per_unit) {
  std::vector<Place2> ring;
  for (const Vec3& p : e.ring) ring.push_back(local_place(f, p, metres_per_unit));
  return box_of(ring);
}

}  // namespace ilot
