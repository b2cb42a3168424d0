// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/artefact.h"

namespace ilot::scan {
namespace {

void add_foot(Artefact& lamp, double height, double radius) {
  lamp.taper({0, 0, 0}, height, radius, 0.6 * radius, Material::iron);
}

// Adds an arm in forward direction with a lamp at its end.
void add_arm(Artefact& lamp, double height, double reach) {
  lamp.rod({0, 0, height - 0.3}, {reach, 0, height}, 0.04, Material::iron);
  lamp.box({reach + (reach > 0 ? 0.25 : -0.25), 0, height}, {0.7, 0.3, 0.14}, Material::iron);
}

}  // namespace

// The x axis points to the road.
Artefact make_lamppost(std::string_view variant, Rng& rng) {
  const double stretch = 0.9 + 0.2 * rng.uniform();
  Artefact lamp;
  if (variant == "candelabra") {
    const double h = 3.6 * stretch;
    add_foot(lamp, 0.8, 0.2);
    lamp.rod({0, 0, 0.7}, {0, 0, h}, 0.06, Material::iron);
    lamp.rod({0, -0.5, h - 0.3}, {0, 0.5, h - 0.3}, 0.03, Material::iron);
    for (double y : {-0.5, 0.0, 0.5}) lamp.ball({0, y, h + (y == 0 ? 0.15 : -0.1)}, 0.2, Material::glass);
  } else if (variant == "arm" || variant == "double_arm") {
    const double h = 7.5 * stretch;
    add_foot(lamp, 1, 0.12);
    lamp.taper({0, 0, 0.9}, h - 0.9, 0.09, 0.05, Material::zinc);
    add_arm(lamp, h, 1.4);
    if (variant == "double_arm") add_arm(lamp, h - 1.5, -1.0);
  } else if (variant == "mast") {
    const double h = 9 * stretch;
    lamp.taper({0, 0, 0}, h, 0.13, 0.06, Material::zinc);
    lamp.disc({0, 0, h + 0.05}, {0, 0, 1}, 0.12, 0.4, Material::iron);
  } else if (variant == "lantern") {
    const double h = 4.2 * stretch;
    add_foot(lamp, 0.6, 0.15);
    lamp.rod({0, 0, 0.5}, {0, 0, h}, 0.05, Material::iron);
    lamp.box({0, 0, h + 0.2}, {0.3, 0.3, 0.4}, Material::glass);
    lamp.taper({0, 0, h + 0.4}, 0.2, 0.28, 0.02, Material::iron);
  } else {
    const double h = 3.2 * stretch;
    lamp.rod({0, 0, 0}, {0, 0, h}, 0.055, Material::iron);
    lamp.ball({0, 0, h + 0.2}, 0.27, Material::glass);
  }
  return lamp;
}

}  // namespace ilot::scan
