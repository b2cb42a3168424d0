// SPDX-License-Identifier: Apache-2.0
#include "engine/run/suitability.h"

#include <gtest/gtest.h>

#include "engine/formats/crs.h"

namespace ilot {
namespace {

CloudMeasure airborne() {
  CloudMeasure m;
  m.points = m.last_returns = 100000;
  m.max = {100, 100, 30};
  m.density = m.last_return_density = 10;
  m.sampling_step = 0.2;
  return m;
}

std::string verdict(const CloudInfo& info, const CloudMeasure& m) {
  std::string letters;
  for (const CloudSuitability& s : suitability(info, m)) {
    letters += s.yes ? 'y' : 'n';
    EXPECT_FALSE(s.reason.empty());
  }
  return letters;
}

TEST(Suitability, FollowsDensityAndStations) {
  CloudInfo info;
  CloudMeasure m = airborne();
  EXPECT_EQ(verdict(info, m), "yyny");
  m.classes[6] = 5;
  EXPECT_NE(suitability(info, m)[1].reason.find("class 6"), std::string::npos);
  m.sampling_step = 0.7;
  EXPECT_EQ(verdict(info, m), "yynn");
  m.last_return_density = 0.4;
  EXPECT_EQ(verdict(info, m), "ynnn");
  m = airborne();
  m.sampling_step = 0.01;
  info.stations.resize(2);
  EXPECT_EQ(verdict(info, m), "ynyy");
}

TEST(Suitability, StepsThatCannotBeAreNoAndDoubted) {
  const CloudInfo info;
  for (const double step : {0.0, 60.0, 6e7}) {
    CloudMeasure m = airborne();
    m.sampling_step = step;
    EXPECT_EQ(verdict(info, m), "nnnn") << step;
    EXPECT_TRUE(step_warning(m)) << step;
  }
  CloudMeasure m = airborne();
  EXPECT_FALSE(step_warning(m));
  m.sampling_step = 5e-5;
  EXPECT_TRUE(step_warning(m));
}

TEST(Suitability, DegreesAreNoUnlessTheyAreNotBelieved) {
  CloudInfo info;
  info.crs = crs_from_epsg(4326);
  CloudMeasure m = airborne();
  m.max = {3, 48, 30};
  EXPECT_EQ(verdict(info, m), "nnnn");
  m.min = m.max = {515393, 4918000, 30};
  EXPECT_EQ(verdict(info, m), "yyny");
  EXPECT_FALSE(assumed_crs(info, m).geographic);
}

}  // namespace
}  // namespace ilot
