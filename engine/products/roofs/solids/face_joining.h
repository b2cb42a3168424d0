// SPDX-License-Identifier: Apache-2.0
// Joins faces of a roof because a person says that they are one.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/model/edit.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"

namespace ilot {

// Returns the face above a place (metres from the site's anchor), kOutside where there is none.
std::uint32_t face_above(const RoofFaceMap& map, FlatPoint place);

// The planes of a roof, and the points that merges gave to them.
struct PlanesWithMerges {
  RoofPlanes planes;
  // Per point: 0, or the plane (1 + index) of the face to which a person gave it although it does not lie on it.
  std::vector<std::uint32_t> given;
};

// Joins the planes of the faces of `model` above the places of a merge: the plane through the points of both or that of
// the first place, whichever has more of these points within the planes' epsilon. The others are given to it. `points`
// are those of the planes. Returns `repeated` where the places lie in one face, and `without_partner` with the reason
// where planes cannot be joined; the planes are then unchanged. O(points).
EditResult join_planes_of_faces(const RoofModel& model, const FaceMerge& merge, std::span<const Vec3> points,
                                PlanesWithMerges& joined);

// The planes with their given points, as borders between faces are to see them: each given point counts for its plane
// at the height of the plane.
RoofPlanes with_given_points(const PlanesWithMerges& joined, std::span<const Vec3> points);

}  // namespace ilot
