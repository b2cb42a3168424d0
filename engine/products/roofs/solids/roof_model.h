// SPDX-License-Identifier: Apache-2.0
// From points and an outline to a closed solid. The outline is divided into cells, every cell belongs to one roof face,
// and faces end in walls where their heights differ.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/building.h"
#include "engine/model/edit.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_params.h"
#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/products/roofs/sites/roof_site.h"

namespace ilot {

enum class RoofStatus : std::uint8_t {
  lod22,           // a face for every plane of the roof
  lod12,           // one level face
  footprint_only,  // no solid
};

// Why faces of a building without LoD2.2 cannot be merged.
constexpr const char* kNoFacesToMerge = "the building has no faces of a roof";

// The faces of a roof as seen from above. Points to which no plane was fitted are measured against them.
struct RoofFaceMap {
  Partition faces;                    // regions are the faces of lod22, numbered as there
  std::vector<RoofPlane> planes;      // per face
  std::vector<std::uint32_t> number;  // per face its plane_id; empty: the plane_id is the number of the face
  double epsilon = 0;                 // metres; greatest distance of a point of a face from its plane
};

struct RoofModel {
  RoofStatus status = RoofStatus::footprint_only;
  std::string reason;            // why the model is not lod22; empty when it is
  Building lod22, lod13, lod12;  // without surfaces where there is no such solid; coordinates are in the CRS
  // Per point of the site, then per point beside it: 0 = none, else its face, a plane_id of lod22.
  std::vector<std::uint32_t> face_of_point;
  RoofFaceMap map;                 // of lod22
  std::vector<EditResult> merges;  // what became of each merge of the site
};

// The intermediate results of the steps, for anyone who looks for the step that went wrong.
struct RoofSteps {
  std::vector<Vec3> points;     // those of the outline, then those beside it that were taken; metres from the anchor
  RoofPlanes planes;            // of these points
  std::vector<FlatEdge> lines;  // the lines that divide the outline; metres from the anchor
  Partition cells;
  std::vector<std::uint32_t> cell_of_point, label;  // per point its cell, per cell 1 + the index of its plane
  Partition faces;                                  // of the attempt that is delivered, or else of the last attempt
  std::vector<RoofPlane> face_planes;
  std::vector<std::string> refused;  // why attempts to raise the faces failed, in their order
};

// Returns the reason against delivering a solid; empty when there is none.
using SolidCheck = std::function<std::string(const Building&)>;

// Models a roof. The result depends on the site alone: the same building gets the same vertices wherever and with
// whatever neighbours it is modelled. If the check refuses a solid, it is built again with fewer faces that share
// vertices, then with small faces (up to 16 m2) given to their neighbours. If that does not help either, the result is
// the next lower level of detail. Each merge of the site takes one more attempt on the planes that it leaves; where its
// places are on two faces still, the model stays as it was without it. lod13 is made from lod22, and is lod12 where no
// part of the roof steps. The function never throws because of the data. `metres_per_unit` is that of the CRS. If
// `steps` is given, it is filled; the model is the same.
RoofModel model_roof(
    const RoofSite& site, const RoofModelParams& params, double metres_per_unit,
    const SolidCheck& check = [](const Building&) { return std::string(); }, RoofSteps* steps = nullptr);

// For points from which the model was not made (metres from the site's anchor): returns the face above or below each
// point if its plane passes within epsilon of the point, else 0.
std::vector<std::uint32_t> faces_at(const RoofFaceMap& map, std::span<const Vec3> points);

}  // namespace ilot
