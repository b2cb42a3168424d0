// SPDX-License-Identifier: Apache-2.0
// Elements of a facade as closed solids [Lorraine thesis, 4.2.1], its irregularities as meshes [Lorraine
// thesis, 4.2.2].
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

// Faces turn outwards: counter-clockwise seen from outside of the solid.
struct FacadeSolid {
  std::uint32_t element = 0;  // its id
  std::string kind;
  std::vector<Vec3> vertices;  // CRS
  std::vector<std::vector<std::uint32_t>> faces;
};

// One for each element with a depth and a simple ring, in their order: its body where it has a closed one, else its
// outline swept out of the wall or into it. The outline is set on a plane parallel to the
// wall at its mean distance from it; the other end lies a depth away, on the side that the ring is farther from: a
// sill's ring is its front and ends at the wall, a window's lies in the wall and ends at the pane. Arcs are chords of
// at most 5 degrees, corners nearer than 1 mm to the one before are left out.
std::vector<FacadeSolid> facade_solids(const Facade& facade, double metres_per_unit = 1);

// The triangles of irregularities, open towards the wall, in their order. They turn out of it.
std::vector<FacadeSolid> facade_meshes(const Facade& facade);

// As OBJ, an object an element ("element-3-window"), and as ASCII STL, a solid an element. Coordinates of the CRS to a
// tenth of a millimetre.
std::string solids_obj(const std::vector<FacadeSolid>& solids);
std::string solids_stl(const std::vector<FacadeSolid>& solids);

}  // namespace ilot
