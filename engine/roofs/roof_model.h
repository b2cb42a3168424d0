// SPDX-License-Identifier: Apache-2.0
// From points and an outline to a closed solid: the outline is parted into cells, every cell belongs to one roof face,
// faces end in walls where their heights differ.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/model/building.h"
#include "engine/roofs/roof_site.h"

namespace ilot {

enum class RoofStatus : std::uint8_t {
  lod22,           // a face for every plane of the roof
  lod12,           // one level face
  footprint_only,  // no solid
};

struct RoofModelParams {
  double epsilon = 0;           // metres; farthest that a point lies from its face; 0 = from noise and density
  int min_points = 0;           // fewest points of a face; 0 = from the density
  double least_face_area = 0;   // m2; smaller faces go to their neighbour
  bool superstructures = true;  // false: the main roof alone
};

struct RoofModel {
  RoofStatus status = RoofStatus::footprint_only;
  std::string reason;                        // why not lod22; empty when it is
  Building lod22, lod12;                     // without surfaces where there is no such solid; coordinates in the CRS
  std::vector<std::uint32_t> face_of_point;  // per point of the site: 0 = none, else its face, a plane_id of lod22
};

// What speaks against delivering a solid; empty when nothing does.
using SolidCheck = std::function<std::string(const Building&)>;

// Depends on the site alone: the same building gives the same vertices wherever and with whatever neighbours it is
// modelled. A solid that the check refuses is raised again with fewer faces sharing vertices, then with small faces
// given to their neighbours, up to 16 m2; if that does not help either, the next lower level of detail is the answer.
// Never throws for what the data holds. `metres_per_unit` of the CRS.
RoofModel model_roof(
    const RoofSite& site, const RoofModelParams& params, double metres_per_unit,
    const SolidCheck& check = [](const Building&) { return std::string(); });

}  // namespace ilot
