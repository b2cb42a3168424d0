// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ilot/clouds.h"
#include "ilot/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

PointColumns coloured_points(std::size_t count) {
  PointColumns p;
  for (std::size_t i = 0; i < count; ++i) {
    p.x.push_back(652000 + 0.001 * static_cast<double>(i));
    p.y.push_back(6862000 - 0.002 * static_cast<double>(i));
    p.z.push_back(35.5);
    p.intensity.push_back(static_cast<std::uint16_t>(i));
    p.classification.push_back(static_cast<std::uint8_t>(i % 2 == 0 ? 2 : 64));
    p.red.push_back(static_cast<std::uint16_t>(2 * i));
    p.green.push_back(7);
    p.blue.push_back(65535);
  }
  return p;
}

class PublicClouds : public ::testing::TestWithParam<const char*> {
 protected:
  TemporaryFolder folder_;
};

TEST_P(PublicClouds, ComeBackAsTheyWereWritten) {
  const auto path = folder_.path() / (std::string("cloud") + GetParam());
  const PointColumns made = coloured_points(1234);
  CloudWriter writer(path, {.crs = "EPSG:2154", .offset = {652000, 6862000, 0}, .colour = true});
  writer.write(made);
  EXPECT_FALSE(std::filesystem::exists(path));
  writer.finish();
  CloudFile cloud(path);
  EXPECT_EQ(cloud.description().points, 1234u);
  EXPECT_TRUE(cloud.description().has_colour);
  PointColumns piece, all;
  for (std::uint64_t at = 0; cloud.read(at, 500, piece) > 0; at += 500) {
    all.x.insert(all.x.end(), piece.x.begin(), piece.x.end());
    all.classification.insert(all.classification.end(), piece.classification.begin(), piece.classification.end());
    all.red.insert(all.red.end(), piece.red.begin(), piece.red.end());
  }
  ASSERT_EQ(all.size(), made.size());
  for (std::size_t i = 0; i < made.size(); ++i) EXPECT_NEAR(all.x[i], made.x[i], 1e-6);
  EXPECT_EQ(all.classification, made.classification);
  EXPECT_EQ(all.red, made.red);
}

INSTANTIATE_TEST_SUITE_P(Formats, PublicClouds, ::testing::Values(".las", ".laz", ".ply"));

TEST(PublicCloudFile, FillsTheCallersArraysAndMeasures) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "cloud.laz";
  CloudWriter writer(path, {.crs = "EPSG:2154", .offset = {652000, 6862000, 0}});
  writer.write(coloured_points(300));
  writer.finish();
  CloudFile cloud(path);
  EXPECT_EQ(cloud.description().crs.epsg, 2154);
  std::vector<double> x(200), y(200), z(200);
  std::vector<std::uint16_t> red(200, 9);
  std::size_t points = 0;
  EXPECT_EQ(cloud.read(200, {.x = x, .y = y, .z = z, .red = red}, points), 100u);
  EXPECT_EQ(points, 100u);
  EXPECT_NEAR(x[0], 652000.2, 1e-6);
  EXPECT_EQ(red[0], 0) << "the cloud has no colours";
  EXPECT_EQ(cloud.read(300, {.x = x, .y = y, .z = z}, points), 0u);
  EXPECT_THROW(cloud.read(0, {.x = x, .y = y, .z = {}}, points), Error);
  const CloudMeasure measure = cloud.measure();
  EXPECT_EQ(measure.points, 300u);
  EXPECT_EQ(measure.classes[2], 150u);
  EXPECT_EQ(cloud.suitability(measure).size(), 4u);
  PointColumns after;
  cloud.read(0, 10, after);
  ASSERT_EQ(after.size(), 10u);
  EXPECT_EQ(after.classification[1], 64);
  const std::vector<std::string> none{"plane_id"};
  EXPECT_THROW(cloud.read(0, 10, after, none), Error);
}

TEST(PublicCloudFile, RefusesWhatItCannotWrite) {
  const TemporaryFolder folder;
  EXPECT_THROW(CloudWriter(folder.path() / "cloud.xyz9"), Error);
  EXPECT_THROW(CloudFile(folder.path() / "missing.las"), Error);
  CloudWriter writer(folder.path() / "cloud.las");
  PointColumns far = coloured_points(1);
  EXPECT_THROW(writer.write(far), Error) << "6862 km are beyond 2^31 mm of 0";
  far.y.clear();
  EXPECT_THROW(writer.write(far), Error);
}

}  // namespace
}  // namespace ilot
