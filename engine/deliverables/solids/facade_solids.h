// SPDX-License-Identifier: Apache-2.0
// Elements of a facade as closed solids [Lorraine thesis, 4.2.1] and its irregularities as meshes [Lorraine thesis,
// 4.2.2].
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/model/facade.h"

namespace ilot {

// Faces are oriented outwards: counter-clockwise seen from outside the solid.
struct FacadeSolid {
  std::uint32_t element = 0;  // its id
  std::string kind;
  std::vector<Vec3> vertices;  // CRS
  std::vector<std::vector<std::uint32_t>> faces;
};

// Returns one solid for each element with a depth and a simple ring, in their order. A closed body of the element is
// taken as it is. Otherwise the outline is extruded out of the wall or into it: it is put on a plane parallel to the
// wall at its mean distance from the wall, and the other end is one depth away, on the side from which the ring is
// farther. So the ring of a sill is its front and the solid ends at the wall, and the ring of a window is in the wall
// and the solid ends at the pane. Arcs become chords of at most 5 degrees. Corners nearer than 1 mm to the previous one
// are left out.
std::vector<FacadeSolid> facade_solids(const Facade& facade, double metres_per_unit = 1);

// Returns the triangles of irregularities in their order. The meshes are open towards the wall and oriented out of it.
std::vector<FacadeSolid> facade_meshes(const Facade& facade);

// Return OBJ, with one object for each element ("element-3-window"), and ASCII STL, with one solid for each element.
// Coordinates are those of the CRS to a tenth of a millimetre.
std::string solids_obj(const std::vector<FacadeSolid>& solids);
std::string solids_stl(const std::vector<FacadeSolid>& solids);

}  // namespace ilot
