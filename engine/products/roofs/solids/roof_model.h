// SPDX-License-Identifier: Apache-2.0
// From points and an outline to a closed solid: the outline is parted into cells, every cell belongs to one roof face,
// faces end in walls where their heights differ.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/building.h"
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

// The faces of a roof as seen from above: what a point that no plane was fitted to is measured against.
struct RoofFaceMap {
  Partition faces;                    // regions are the faces of lod22, numbered as there
  std::vector<RoofPlane> planes;      // per face
  std::vector<std::uint32_t> number;  // per face its plane_id where that is another one; empty: its own number
  double epsilon = 0;                 // metres; farther from its plane no point is a face's
};

struct RoofModel {
  RoofStatus status = RoofStatus::footprint_only;
  std::string reason;                        // why not lod22; empty when it is
  Building lod22, lod12;                     // without surfaces where there is no such solid; coordinates in the CRS
  std::vector<std::uint32_t> face_of_point;  // per point of the site: 0 = none, else its face, a plane_id of lod22
  RoofFaceMap map;                           // of lod22
};

// What the steps found on the way to the model, for whoever looks for the step that went wrong.
struct RoofSteps {
  RoofPlanes planes;
  std::vector<FlatEdge> lines;  // that part the outline, metres from the anchor
  Partition cells;
  std::vector<std::uint32_t> cell_of_point, label;  // per point its cell, per cell 1 + the index of its plane
  Partition faces;                                  // of the attempt that was delivered, else of the last one
  std::vector<RoofPlane> face_planes;
  std::vector<std::string> refused;  // why attempts to raise the faces came to nothing, in their order
};

// What speaks against delivering a solid; empty when nothing does.
using SolidCheck = std::function<std::string(const Building&)>;

// Depends on the site alone: the same building gives the same vertices wherever and with whatever neighbours it is
// modelled. A solid that the check refuses is raised again with fewer faces sharing vertices, then with small faces
// given to their neighbours, up to 16 m2; if that does not help either, the next lower level of detail is the answer.
// Never throws for what the data holds. `metres_per_unit` of the CRS. Where `steps` are given they are
// filled; the model is the same.
RoofModel model_roof(
    const RoofSite& site, const RoofModelParams& params, double metres_per_unit,
    const SolidCheck& check = [](const Building&) { return std::string(); }, RoofSteps* steps = nullptr);

// For points that the model was not made from (metres from the site's anchor): the face above or below which each lies
// when its plane passes within epsilon of it, else 0.
std::vector<std::uint32_t> faces_at(const RoofFaceMap& map, std::span<const Vec3> points);

}  // namespace ilot
