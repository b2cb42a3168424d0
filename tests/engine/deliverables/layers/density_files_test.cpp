// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/density_files.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "engine/error.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

// Three by two pixels of half a foot, the first outside of the outline, the last unseen by any station.
DensityMap small_map() {
  DensityMap map;
  map.plane_id = 7;
  map.origin = {652000.5, 6862000.25, 30};
  map.right = {1, 0, 0};
  map.up = {0, 0, 1};
  map.left = -2;
  map.top = 9;
  map.pixel = 0.5;
  map.width = 3;
  map.height = 2;
  const float none = std::nanf("");
  map.measured = {none, 100, 50, 200, 300, 10};
  map.predicted = {none, 100, 100, 100, 400, none};
  return map;
}

void write_density(const std::filesystem::path& folder) {
  DensityFiles files(folder, 0.3048);
  files.add(small_map());
  files.finish();
}

TEST(DensityFiles, TheRasterReadsBackAsItWasGiven) {
  const TemporaryFolder folder;
  write_density(folder.path() / "density");
  const GDALDatasetUniquePtr file(
      GDALDataset::Open((folder.path() / "density/plane-000007.tif").c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(file);
  ASSERT_EQ(file->GetRasterCount(), 3);
  double place[6];
  ASSERT_EQ(file->GetGeoTransform(place), CE_None);
  EXPECT_DOUBLE_EQ(place[0], -2 * 0.3048);
  EXPECT_DOUBLE_EQ(place[1], 0.5 * 0.3048);
  EXPECT_DOUBLE_EQ(place[3], 9 * 0.3048);
  EXPECT_STREQ(file->GetMetadataItem("origin"), "652000.5 6862000.25 30");
  float ratio[6];
  ASSERT_EQ(file->GetRasterBand(3)->RasterIO(GF_Read, 0, 0, 3, 2, ratio, 3, 2, GDT_Float32, 0, 0), CE_None);
  EXPECT_TRUE(std::isnan(ratio[0]) && std::isnan(ratio[5]));
  EXPECT_EQ(ratio[2], 0.5f);
  EXPECT_EQ(ratio[4], 0.75f);
  EXPECT_TRUE(std::isnan(file->GetRasterBand(1)->GetNoDataValue()));
}

TEST(DensityFiles, ThePictureShowsWhatIsMissingInRed) {
  const TemporaryFolder folder;
  write_density(folder.path());
  const GDALDatasetUniquePtr file(GDALDataset::Open((folder.path() / "plane-000007.png").c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(file);
  ASSERT_EQ(file->GetRasterXSize(), 3 * 480 + 16);
  ASSERT_EQ(file->GetRasterYSize(), 320);
  const auto colour = [&](int x, int y) {
    std::array<std::uint8_t, 3> c{};
    for (int b = 0; b < 3; ++b)
      EXPECT_EQ(file->GetRasterBand(b + 1)->RasterIO(GF_Read, x, y, 1, 1, &c[b], 1, 1, GDT_Byte, 0, 0), CE_None);
    return c;
  };
  constexpr int kThird = 2 * (480 + 8);
  using Colour = std::array<std::uint8_t, 3>;
  EXPECT_EQ(colour(kThird + 80, 80), (Colour{255, 255, 255})) << "outside";
  EXPECT_EQ(colour(kThird + 240, 80), (Colour{255, 255, 255})) << "as predicted";
  EXPECT_GT(colour(kThird + 400, 80)[0], colour(kThird + 400, 80)[2]) << "half of it";
  EXPECT_LT(colour(kThird + 80, 240)[0], colour(kThird + 80, 240)[2]) << "twice as much";
  EXPECT_EQ(colour(kThird + 400, 240), (Colour{200, 200, 200})) << "nothing predicted";
  EXPECT_EQ(colour(488 + 240, 240)[0], 230) << "the densest";
}

TEST(DensityFiles, TheTableHasALineAMap) {
  const TemporaryFolder folder;
  write_density(folder.path());
  EXPECT_EQ(test::file_bytes(folder.path() / "density.csv"),
            "plane_id,pixel_m,pixels,measured,predicted,ratio_p10,ratio_median,ratio_p90\n"
            "7,0.1524,5,100,100,0.5,0.75,1\n");
}

TEST(DensityFiles, SameBytesEveryTimeAndNothingBeside) {
  const TemporaryFolder folder;
  write_density(folder.path() / "a");
  write_density(folder.path() / "b");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "a")) {
    EXPECT_EQ(test::file_bytes(entry.path()), test::file_bytes(folder.path() / "b" / entry.path().filename()));
    ++files;
  }
  EXPECT_EQ(files, 3u);
}

TEST(DensityFiles, AFolderThatCannotBeMadeIsAnError) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "taken") << "x";
  EXPECT_ANY_THROW(DensityFiles(folder.path() / "taken", 1));
}

}  // namespace
}  // namespace ilot
