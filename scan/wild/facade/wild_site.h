// SPDX-License-Identifier: Apache-2.0
// What lies around wild fronts: ground, vehicles, people, plants, poles and cables, and where the scanner stands.
#pragma once
#include "scan/wild/facade/wild_front.h"
#include "scan/wild/facade/wild_scanner.h"

namespace ilot::scan {

// A rectangle of ground before walls. In the coordinates of its frame x runs along the walls and `out` away from them.
struct WildSite {
  FacadeFrame frame;
  double length = 10, width = 10;     // of the ground between the walls
  double slope = 0;                   // rise with x
  double pavement = 1.5, kerb = 0.1;  // the pavement before the walls; kerb 0 = no pavement
  double road = 6;
  bool opposite = false;  // walls stand at out = width as well
  bool court = false;     // walls on all sides

  double ground(double x, double out) const {
    const bool on_road = kerb > 0 && out > pavement && out < pavement + road;
    return slope * x - (on_road ? kerb : 0);
  }
};

void add_ground(TerrestrialScene& scene, const WildSite& site);

// Adds what stands on the ground. Nothing stands within 1.2 metres of a station.
void add_street_things(TerrestrialScene& scene, Draws& draws, const WildSite& site);

// Places the stations, or the vehicle, and sets the crop, which must be known before. `reach` is the height of the
// highest wall.
void place_scanner(WildScan& scan, Draws& draws, const WildSite& site, double reach);

// Removes elements, openings and control points of the truth that do not lie within the crop.
void drop_cropped(TerrestrialScene& scene, const WildCrop& crop);

}  // namespace ilot::scan
