// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/planes_csv.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::string planes_fault(const std::filesystem::path& path) {
  try {
    read_planes_csv(path);
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(PlanesCsv, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "planes.csv";
  Segment s{3, 0xabcdef, {{0.1, -0.2, 0.97}, 1.0 / 3}, 1234, {651000.5, 2, 3}, {1, 2, 3}, {4, 5, 6}, 0.004, 0.02};
  write_planes_csv(path, std::vector<Segment>{s});
  const std::vector<Segment> read = read_planes_csv(path);
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].id, 3u);
  EXPECT_EQ(read[0].points, 1234u);
  EXPECT_EQ(read[0].plane.d, 1.0 / 3);
  EXPECT_EQ(read[0].plane.n.y, -0.2);
  EXPECT_EQ(read[0].centroid.x, 651000.5);
  EXPECT_EQ(read[0].max.z, 6);
  EXPECT_EQ(read[0].epsilon_m, 0.02);
}

TEST(PlanesCsv, FindsColumnsByNameAndRefusesFaults) {
  const TemporaryFolder folder;
  const std::string head = "colour,d,nz,ny,nx,centroid_z,centroid_y,centroid_x,plane_id\n";
  const auto read = read_planes_csv(folder.put("a.csv", head + "red,5,1,0,0,3,2,1,9\r\n"));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0].id, 9u);
  EXPECT_EQ(read[0].plane.n.z, 1);
  EXPECT_EQ(read[0].centroid.y, 2);
  EXPECT_TRUE(planes_fault(folder.put("b.csv", head + "red,5,1\n")).ends_with("b.csv:2: 3 cells for 9 columns"));
  EXPECT_TRUE(
      planes_fault(folder.put("c.csv", head + "red,5,1,0,0,3,nan,1,9\n")).ends_with("c.csv:2: 'nan' is no number"));
  EXPECT_TRUE(planes_fault(folder.put("d.csv", head + "red,5,1,0,0,3,2,1,0\n")).ends_with("d.csv:2: bad id or count"));
  EXPECT_TRUE(planes_fault(folder.put("e.csv", "plane_id,d\n")).ends_with("e.csv:1: no column 'nx'"));
  EXPECT_TRUE(planes_fault(folder.path() / "none.csv").ends_with("none.csv: cannot be read"));
}

}  // namespace
}  // namespace ilot
