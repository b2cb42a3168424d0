// SPDX-License-Identifier: Apache-2.0
// The pulses of a vehicle: a range along the axis of a pulse is a distance, whatever the slope of the road.
#include "scan/wild/facade/wild_pulses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ilot::scan {
namespace {

// The largest amount by which the axes of a line of pulses are not of unit length or not perpendicular to each other.
double fault_of_axes(const WildDrive& drive, int head) {
  double worst = 0;
  WildPulses(drive, head).each(0, [&](const WildPulse& pulse) {
    const Aim& aim = pulse.aim;
    for (const double fault : {norm(aim.axis) - 1, norm(aim.right) - 1, norm(aim.up) - 1, dot(aim.axis, aim.right),
                               dot(aim.axis, aim.up), dot(aim.right, aim.up)})
      worst = std::max(worst, std::abs(fault));
  });
  return worst;
}

TEST(WildPulses, AxesOfAHeadArePerpendicularUnitVectorsOnAnySlope) {
  for (const double slope : {0.0, 0.05, -0.12})
    for (const int head : {1, 2}) {
      WildDrive drive;
      drive.way = (1 / std::sqrt(1.25 + slope * slope)) * Vec3{1, 0.5, slope};
      EXPECT_LT(fault_of_axes(drive, head), 1e-12) << "slope " << slope << ", head " << head;
    }
}

}  // namespace
}  // namespace ilot::scan
