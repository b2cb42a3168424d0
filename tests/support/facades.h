// SPDX-License-Identifier: Apache-2.0
// Facades constructed by hand: a wall in the plane y = 0, with x to the right and z up.
#pragma once
#include <string>

#include "engine/model/facade.h"

namespace ilot {

inline std::vector<Vec3> wall_rectangle(double x0, double z0, double x1, double z1, double y = 0) {
  return {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
}

inline FacadeElement drawn(const std::string& kind, std::vector<Vec3> ring, DrawnStatus status = DrawnStatus::seen) {
  FacadeElement element;
  element.kind = kind;
  element.opening = kind == "window" || kind == "door";
  element.ring = std::move(ring);
  element.status = status;
  return element;
}

inline Facade facade_of(std::vector<FacadeElement> elements) {
  Facade facade{1, "", {0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, 20, 12, std::move(elements)};
  for (std::uint32_t i = 0; i < facade.elements.size(); ++i) facade.elements[i].id = i + 1;
  return facade;
}

}  // namespace ilot
