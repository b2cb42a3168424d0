// SPDX-License-Identifier: Apache-2.0
// Ground plans of buildings as users give them.
#pragma once
#include <array>
#include <string>
#include <vector>

namespace ilot {

// The outer ring, then its holes, in the CRS of the clouds. Nothing is known of its validity. Rings are not closed:
// from the last vertex an edge leads to the first.
using FootprintPolygon = std::vector<std::vector<std::array<double, 2>>>;

struct Footprint {
  std::string id;                       // unique within a file
  std::vector<FootprintPolygon> parts;  // none: see fault
  std::string fault;                    // why nothing can be built on it; empty when there are parts
};

}  // namespace ilot
