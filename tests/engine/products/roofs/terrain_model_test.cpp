// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/terrain_model.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>

#include "engine/columns/point_roles.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

constexpr std::int64_t kWest = 84000000, kSouth = 447000000;  // millimetres: the corner of the scene

double ground_at(double x, double y) {
  return 30 + 0.05 * x - 0.02 * y;
}

// A slope of 120 m x 60 m with a hall of 30 m x 20 m on it, `density` points a square metre. East of x = 200 stand the
// roofs of another place without ground.
std::unique_ptr<Store> scene(const std::filesystem::path& folder, double density, std::uint64_t block_points,
                             std::vector<std::unique_ptr<PointReader>>& inputs, bool ground = true) {
  Rng rng(4);
  std::vector<Index3> points;
  std::vector<PointRole> roles;
  const auto add = [&](double x, double y, double z, PointRole role) {
    points.push_back({kWest + std::llround(1000 * x), kSouth + std::llround(1000 * y), std::llround(1000 * z)});
    roles.push_back(role);
  };
  for (int i = 0; i < static_cast<int>(density * 120 * 60); ++i) {
    const double x = 120 * rng.uniform(), y = 60 * rng.uniform();
    const bool hall = x > 40 && x < 70 && y > 20 && y < 40;
    add(x, y, ground_at(x, y) + (hall ? 8 : 0.02 * (rng.uniform() - 0.5)),
        hall || !ground ? PointRole::building : PointRole::ground);
    if (i % 10 == 0) add(300 + x, y, 60, PointRole::building);
  }
  test::write_cloud(folder / "c.las", points, {}, 0, {kWest, kSouth, 0});
  inputs.push_back(open_cloud(folder / "c.las"));
  IndexParams params;
  params.unit = test::kUnit;
  params.block_points = block_points;
  auto store = std::make_unique<Store>(build_index(inputs, params, folder / "store", {}).store);
  for (std::uint32_t b = 0; b < store->blocks().size(); ++b) {
    std::vector<PointRole> column;
    for (const InputOrder order : store->read(b, columns::kOrder)) column.push_back(roles[row_of(order)]);
    store->write(b, columns::kRole, column);
  }
  return store;
}

struct Raster {
  double x = 0, y = 0, pixel = 0;
  int width = 0, height = 0;
  std::vector<double> values;
  double nodata = 0;

  explicit Raster(const std::filesystem::path& path) {
    GDALAllRegister();
    const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    if (!file) throw std::runtime_error(path.string());
    double place[6];
    file->GetGeoTransform(place);
    x = place[0], y = place[3], pixel = place[1];
    width = file->GetRasterXSize(), height = file->GetRasterYSize();
    values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    GDALRasterBand* band = file->GetRasterBand(1);
    nodata = band->GetNoDataValue();
    EXPECT_EQ(band->RasterIO(GF_Read, 0, 0, width, height, values.data(), width, height, GDT_Float64, 0, 0), CE_None);
  }
  double at(double east, double north) const {
    const auto column = static_cast<std::size_t>((east - x) / pixel),
               row = static_cast<std::size_t>((y - north) / pixel);
    return values.at(row * static_cast<std::size_t>(width) + column);
  }
};

TEST(TerrainModel, HeightsOfTheGroundAlsoUnderTheHall) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<PointReader>> inputs;
  const auto store = scene(folder.path(), 8, 1u << 20, inputs);
  const TerrainModel model = write_terrain_model(*store, folder.path(), {}, {});
  EXPECT_EQ(model.pixel_m, 1) << "eight points a square metre: four points need 0.7 m";
  EXPECT_GT(model.density_m2, 4) << "cells at the edge of the scene and at the hall are not full";
  EXPECT_LT(model.density_m2, 8.5);
  const Raster dtm(folder.path() / "dtm.tif"), counts(folder.path() / "dtm_points.tif");
  for (double x = 1.5; x < 118; x += 1)
    for (double y = 1.5; y < 58; y += 1) {
      const double z = dtm.at(84000 + x, 447000 + y), n = counts.at(84000 + x, 447000 + y);
      const bool hall = x > 41 && x < 69 && y > 21 && y < 39;
      ASSERT_NEAR(z, ground_at(x, y), hall ? 0.25 : 0.06) << x << " " << y;
      if (hall) {
        EXPECT_EQ(n, 0);
      }
    }
  EXPECT_EQ(dtm.at(84000 + 330, 447000 + 30), dtm.nodata) << "far from all ground";
  EXPECT_EQ(counts.at(84000 + 330, 447000 + 30), 0);
}

TEST(TerrainModel, BlocksChangeNothing) {
  std::vector<std::vector<double>> made;
  for (const std::uint64_t block_points : {std::uint64_t{1} << 20, std::uint64_t{700}}) {
    const TemporaryFolder folder;
    std::vector<std::unique_ptr<PointReader>> inputs;
    const auto store = scene(folder.path(), 3, block_points, inputs);
    EXPECT_EQ(write_terrain_model(*store, folder.path(), {}, {}).pixel_m, 2);
    made.push_back(Raster(folder.path() / "dtm.tif").values);
  }
  EXPECT_EQ(made[0], made[1]);
}

TEST(TerrainModel, WithoutGroundThereIsNoFile) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<PointReader>> inputs;
  const auto store = scene(folder.path(), 1, 1u << 20, inputs, false);
  EXPECT_EQ(write_terrain_model(*store, folder.path(), {}, {}).pixel_m, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "dtm.tif"));
}

}  // namespace
}  // namespace ilot
