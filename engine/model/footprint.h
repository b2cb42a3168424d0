// SPDX-License-Identifier: Apache-2.0
// Footprints of buildings that users give.
#pragma once
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

// The outer ring, then its holes, in the CRS of the clouds. Its validity is not known. Rings are not closed: an edge
// leads from the last vertex to the first.
using FootprintPolygon = std::vector<std::vector<std::array<double, 2>>>;

struct Footprint {
  std::string id;                       // unique within a file
  std::vector<FootprintPolygon> parts;  // none: the reason is in fault
  std::string fault;                    // why no building can be made from it; empty when there are parts
  std::vector<std::pair<std::string, AttributeValue>> attributes = {};  // of the file, without those that are null
};

}  // namespace ilot
