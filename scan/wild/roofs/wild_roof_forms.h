// SPDX-License-Identifier: Apache-2.0
// The forms of roofs that only `roofs-wild` has: spires, domes, barrels, tents, saw-teeth, terraces, halls and glass.
#pragma once
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/part.h"
#include "scan/roofs/roof_partition.h"

namespace ilot::scan {

// A curved surface below the facets of a wing: they touch it from outside. In the frame of the wings, in metres.
struct CurvedRoof {
  std::size_t wing = 0;
  Quadric surface;
};

struct WildRoof {
  std::string_view form, family;  // family: what leaves it out
  std::vector<Wing> wings;
  std::vector<CurvedRoof> curved;
  std::vector<std::size_t> glass;  // wings whose roof lets pulses through to what lies `below`
  Integer below = 0;               // millimetres above the foot: the lower layer
};

struct WildRoofForm {
  std::string_view name, family;
  double frequency;
  WildRoof (*draw)(Rng& rng);
};

// Returns the forms in a fixed order, with those of draw_roof() (family "houses") first.
std::span<const WildRoofForm> wild_roof_forms();

}  // namespace ilot::scan
