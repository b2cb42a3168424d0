// SPDX-License-Identifier: Apache-2.0
// True and found roofs in one common form, so that they can be compared.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/flat_area.h"
#include "engine/model/polygon_model.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {

// A roof face. Coordinates are relative to an origin that all faces of a comparison share.
struct RoofFace {
  std::uint32_t building = 0;
  std::vector<FlatPolygon> plan;     // projection along z
  std::vector<Triangle3> triangles;  // in space, covering the face
  Vec3 normal;                       // upward normal; its length is the area
  double offset = 0;                 // normal . p + offset = 0
  FlatBox box;                       // of the plan
  double area() const;               // in space
  double height(FlatPoint p) const;  // height of its plane at p
};

// Returns the faces of the planes of class `roof`, one per plane and building. Upright faces have no plan and are left
// out.
std::vector<RoofFace> true_roofs(std::span<const TruePlane> planes, Vec3 origin);

// Returns roof_faces() of the models; the building is the index of the model.
std::vector<RoofFace> model_roofs(std::span<const PolygonModel> models, Vec3 origin, double metres_per_unit);

bool covers(const RoofFace& face, FlatPoint p);  // uses the even-odd rule over all rings of its plan

// All edges of the plan's rings.
std::vector<FlatEdge> plan_edges(const RoofFace& face);

}  // namespace ilot
