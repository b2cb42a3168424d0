// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/registration_error.h"

#include <gtest/gtest.h>

#include "tests/support/facade_sites.h"

namespace ilot {
namespace {

// A bare wall, seen by two stations; all points of the second one are moved out of it by `off`.
FacadeSite seen_twice(double off) {
  test::ScannedWall wall;
  wall.wall({});
  FacadeSite first = test::scan_wall(wall, {1, 1.5, 8}, 0.004), second = test::scan_wall(wall, {5, 1.5, 8}, 0.004);
  for (FacadePoint& p : second.points) p.w += static_cast<float>(off);
  FacadeSite both = test::joined(first, second);
  both.from.assign(first.points.size(), 1);
  both.from.resize(both.points.size(), 2);
  return both;
}

TEST(RegistrationError, OneStationSaysNothingAboutItsPlace) {
  test::ScannedWall wall;
  wall.wall({});
  EXPECT_NEAR(registration_error(RaySamples(test::scan_wall(wall, {1, 1.5, 8}, 0.004))), 0.01, 1e-12);
}

TEST(RegistrationError, StationsThatAgreeMakeItSmallerAndOthersLarger) {
  const double agree = registration_error(RaySamples(seen_twice(0))),
               differ = registration_error(RaySamples(seen_twice(0.012)));
  EXPECT_LT(agree, 0.0085);
  EXPECT_GT(agree, 0.0075);
  EXPECT_GT(differ, agree + 0.001);
}

TEST(RegistrationError, WithoutStationsItIsNotKnown) {
  test::ScannedWall wall;
  wall.wall({});
  FacadeSite site = test::scan_wall(wall, {1, 1.5, 8}, 0.004);
  site.stations.clear();
  EXPECT_EQ(registration_error(RaySamples(site)), 0);
}

}  // namespace
}  // namespace ilot
