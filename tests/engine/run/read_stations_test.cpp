// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_stations.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

class ReadStations : public testing::Test {
 protected:
  std::vector<Station> read(const std::string& text) {
    std::ofstream(path(), std::ios::binary) << text;
    return read_stations(path());
  }
  // What stands behind the file's name.
  std::string fault_of(const std::string& text) {
    try {
      read(text);
    } catch (const Error& fault) {
      EXPECT_EQ(fault.code(), ExitCode::usage);
      const std::string what = fault.what();
      EXPECT_EQ(what.rfind(path().string(), 0), 0u) << what;
      return what.substr(std::min(what.size(), path().string().size()));
    }
    return "no fault";
  }
  std::filesystem::path path() const { return folder_.path() / "stations.csv"; }

 private:
  TemporaryFolder folder_;
};

TEST_F(ReadStations, PlacesAlone) {
  const auto s = read("# surveyed\n\n1 2 3\r\n-4.5,5e1;6\n");
  ASSERT_EQ(s.size(), 2u);
  EXPECT_EQ(s[1].position.x, -4.5);
  EXPECT_EQ(s[1].position.y, 50);
  EXPECT_EQ(s[1].azimuth_step, 0);
  EXPECT_EQ(s[1].axis.z, 1);
  EXPECT_EQ(s[1].name, "station 2");
}

TEST_F(ReadStations, ANameMayComeFirst) {
  const auto s = read("S1;1;2;3\nS2;4;5;6\n");
  ASSERT_EQ(s.size(), 2u);
  EXPECT_EQ(s[1].name, "S2");
  EXPECT_EQ(s[1].position.z, 6);
  EXPECT_GT(read("court 1 2 3 0.1 0.2\n").at(0).azimuth_step, 0);
}

TEST_F(ReadStations, StepsAndAxisInTheUsualOrder) {
  const auto s = read("1 2 3 0.1 0.2 0 3 4\n");
  ASSERT_EQ(s.size(), 1u);
  EXPECT_NEAR(s[0].azimuth_step, 0.1 * 0.017453292519943295, 1e-15);
  EXPECT_NEAR(s[0].elevation_step, 0.2 * 0.017453292519943295, 1e-15);
  EXPECT_NEAR(s[0].axis.y, 0.6, 1e-15);
  EXPECT_NEAR(s[0].axis.z, 0.8, 1e-15);
}

TEST_F(ReadStations, AHeaderNamesTheColumns) {
  const auto s = read("name,z,y,x,elevation_step_deg,azimuth_step_deg\ncourt,3,2,1,0.2,0.1\n");
  ASSERT_EQ(s.size(), 1u);
  EXPECT_EQ(s[0].name, "court");
  EXPECT_EQ(s[0].position.x, 1);
  EXPECT_EQ(s[0].position.z, 3);
  EXPECT_GT(s[0].elevation_step, s[0].azimuth_step);
}

TEST_F(ReadStations, NumbersOfTheirPoints) {
  const auto named = read("name,x,y,z\n3,1,2,3\n3.5,1,2,3\n0,1,2,3\n65536,1,2,3\nsix,1,2,3\n65535,1,2,3\n");
  const std::vector<std::uint16_t> expected{3, 0, 0, 0, 0, 65535};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(named.at(i).source_id, expected[i]) << named[i].name;
  const auto stations = read("name,x,y,z,point_source_id\n3,1,2,3,12\ncourt,1,2,3,7\n");
  EXPECT_EQ(stations.at(0).source_id, 12) << "the column comes before the name";
  EXPECT_EQ(stations.at(1).source_id, 7);
  EXPECT_EQ(read("1 2 3\n").at(0).source_id, 0) << "station 1 is a name of ours";
}

TEST_F(ReadStations, FaultsSayWhere) {
  EXPECT_EQ(fault_of("1 2 3\n1 2\n"), ":2: has 2 fields, not 3");
  const std::string expected =
      "; expected are x y z (3), with two angular steps (5), with the axis too (8), a name before them if wanted, or a "
      "header that names the columns (name,x,y,z)";
  EXPECT_EQ(fault_of("1 2 3 4\n"), ":1: has 4 columns, read as 4 numbers" + expected);
  EXPECT_EQ(fault_of("bgt_type,x,y\n"), ":1: has 3 columns, read as a name (\"bgt_type\") and 2 numbers" + expected);
  EXPECT_EQ(fault_of("1 2 north\n"), ":1: \"north\" is not a number");
  EXPECT_EQ(fault_of("1 2 inf\n"), ":1: \"inf\" is not a number");
  EXPECT_EQ(fault_of("x,y,height\n1,2,3\n"), ":1: \"height\" is no column of a stations file");
  EXPECT_EQ(fault_of("x,y,x\n"), ":1: the column \"x\" comes twice");
  EXPECT_EQ(fault_of("x,y\n"), ":1: the columns x, y and z are needed");
  EXPECT_EQ(fault_of("x,y,z,azimuth_step_deg\n"), ":1: azimuth_step_deg and elevation_step_deg go together");
  EXPECT_EQ(fault_of("1 2 3 0 0.1\n"), ":1: angular steps must lie above 0 and be 5 degrees at most");
  EXPECT_EQ(fault_of("x,y,z,point_source_id\n1,2,3,0\n"),
            ":2: \"0\" is no point_source_id, a whole number from 1 to 65535");
  EXPECT_EQ(fault_of("1 2 3 0.1 0.1 0 0 0\n"), ":1: the axis has no length");
  EXPECT_EQ(fault_of("# nobody\n"), ": contains no station");
}

}  // namespace
}  // namespace ilot
