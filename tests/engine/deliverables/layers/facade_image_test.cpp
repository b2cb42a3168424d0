// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/facade_image.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "tests/support/facades.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

PointSource source_of(const std::vector<ImagePoint>& points, std::size_t piece) {
  return [&points, piece](const Box3<Vec3>&, const std::function<void(std::span<const ImagePoint>)>& take) {
    for (std::size_t i = 0; i < points.size(); i += piece)
      take(std::span(points).subspan(i, std::min(piece, points.size() - i)));
  };
}

// Gives what lies in the box that is asked for and nothing else.
PointSource strict_source_of(const std::vector<ImagePoint>& points) {
  return [&points](const Box3<Vec3>& box, const std::function<void(std::span<const ImagePoint>)>& take) {
    for (const ImagePoint& p : points)
      if (p.position.x >= box.min.x && p.position.y >= box.min.y && p.position.z >= box.min.z &&
          p.position.x <= box.max.x && p.position.y <= box.max.y && p.position.z <= box.max.z)
        take(std::span(&p, 1));
  };
}

// A wall 1 x 1 in lattice steps of a centimetre, red, green above the middle.
std::vector<ImagePoint> a_wall() {
  std::vector<ImagePoint> points;
  for (int z = 0; z < 100; ++z)
    for (int x = 0; x < 100; ++x)
      points.push_back(
          {{x / 100.0 + 0.005, 0, z / 100.0 + 0.005}, {static_cast<std::uint8_t>(z < 50 ? 200 : 0), 90, 0}});
  return points;
}

FacadeImageParams params_of(double pixel) {
  FacadeImageParams params;
  params.pixel_m = pixel;
  params.around_m = 0;
  params.fill_rounds = 0;
  return params;
}

Facade pictured_facade() {
  return facade_of({drawn("outline", wall_rectangle(0, 0, 1, 1))});
}

TEST(FacadeImage, PlacesAndColours) {
  const std::vector<ImagePoint> points = a_wall();
  const FacadeImage image = facade_image(pictured_facade(), source_of(points, 7), params_of(0.1));
  ASSERT_EQ(image.width, 10u);
  ASSERT_EQ(image.height, 10u);
  EXPECT_EQ(image.points, 10000u);
  EXPECT_EQ(image.empty, 0u);
  EXPECT_EQ(image.rgba[0], 0);         // the top left
  EXPECT_EQ(image.rgba[4 * 99], 200);  // the bottom right
  EXPECT_EQ(image.rgba[4 * 99 + 1], 90);
  EXPECT_EQ(image.place.max.y, 1);
}

TEST(FacadeImage, AnyOrderAndAnyPiecesGiveTheSameBytes) {
  std::vector<ImagePoint> points = a_wall();
  points.push_back({{0.505, -0.2, 0.505}, {1, 2, 3}});
  const FacadeImage once = facade_image(pictured_facade(), source_of(points, 1000), params_of(0.03));
  std::reverse(points.begin(), points.end());
  const FacadeImage turned = facade_image(pictured_facade(), source_of(points, 13), params_of(0.03));
  EXPECT_EQ(once.rgba, turned.rgba);
}

TEST(FacadeImage, APixelIsTheDistanceOfPointsHoweverMuchOfTheWallIsBare) {
  const std::vector<ImagePoint> points = a_wall();
  const Facade facade = facade_of({drawn("outline", wall_rectangle(0, 0, 12, 9))});
  for (const std::uint32_t tile : {0u, 512u}) {
    FacadeImageParams params;
    params.tile = tile;
    EXPECT_EQ(facade_image(facade, source_of(points, 1000), params).pixel_m, 0.02) << tile;
  }
}

// Gaps lie across the borders of tiles, and a tile is seen from its own points alone.
TEST(FacadeImage, TilesAreInvisible) {
  std::vector<ImagePoint> points = a_wall();
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].colour = {static_cast<std::uint8_t>(i * 7), static_cast<std::uint8_t>(i / 100), 33};
    points[i].position.y = 0.0001 * static_cast<double>(i % 977);
  }
  std::erase_if(points, [](const ImagePoint& p) { return p.colour[0] % 5 < 2 || p.colour[1] / 4 % 6 == 0; });
  Facade facade = pictured_facade();
  facade.right = {0.8, 0.6, 0}, facade.out = {0.6, -0.8, 0};
  for (ImagePoint& p : points)
    p.position = p.position.x * facade.right + p.position.z * facade.up + (0.1 - p.position.y) * facade.out;
  FacadeImageParams params = params_of(0);
  params.fill_rounds = 2;
  params.around_m = 0.1;
  const FacadeImage whole = facade_image(facade, source_of(points, 1000), params);
  EXPECT_GT(whole.filled, 100u);
  for (const std::uint32_t tile : {1u, 7u, 64u, 1000u}) {
    params.tile = tile;
    const FacadeImage tiled = facade_image(facade, strict_source_of(points), params);
    EXPECT_EQ(tiled.pixel_m, whole.pixel_m) << tile;
    EXPECT_TRUE(tiled.rgba == whole.rgba) << tile;
    EXPECT_EQ(tiled.points, whole.points) << tile;
    EXPECT_EQ(tiled.filled, whole.filled) << tile;
    EXPECT_EQ(tiled.empty, whole.empty) << tile;
  }
}

TEST(FacadeImage, WhatStandsInFrontHidesTheWallAndWhatIsFarDoesNot) {
  std::vector<ImagePoint> points = a_wall();
  points.push_back({{0.05, -0.2, 0.05}, {1, 2, 3}});  // out of the wall
  points.push_back({{0.95, -5, 0.05}, {9, 9, 9}});    // a car
  const FacadeImage image = facade_image(pictured_facade(), source_of(points, 64), params_of(0.1));
  EXPECT_EQ(image.rgba[4 * 90], 1);
  EXPECT_EQ(image.rgba[4 * 99], 200);
}

TEST(FacadeImage, ThePixelFollowsThePoints) {
  const std::vector<ImagePoint> points = a_wall();
  EXPECT_EQ(facade_image(pictured_facade(), source_of(points, 64), params_of(0)).pixel_m, 0.01);
  std::vector<ImagePoint> few{points[0], points[5000]};
  EXPECT_EQ(facade_image(pictured_facade(), source_of(few, 64), params_of(0)).pixel_m, 1);
  FacadeImageParams bounded = params_of(0.001);
  bounded.most_pixels = 1024;
  const FacadeImage image = facade_image(pictured_facade(), source_of(points, 64), bounded);
  EXPECT_EQ(image.width * image.height, 1024u);
  EXPECT_EQ(image.pixel_m, 0.032);
}

TEST(FacadeImage, ReliefIsLighterInFront) {
  const std::vector<ImagePoint> points{{{0.05, 0, 0.05}, {}}, {{0.15, -0.1, 0.05}, {}}, {{0.25, 0.1, 0.05}, {}}};
  FacadeImageParams params = params_of(0.1);
  params.shade = ImageShade::relief;
  const FacadeImage image = facade_image(pictured_facade(), source_of(points, 2), params);
  EXPECT_GT(image.rgba[4 * 91], image.rgba[4 * 90]);
  EXPECT_GT(image.rgba[4 * 90], image.rgba[4 * 92]);
}

TEST(FacadeImage, ThePngReadsBackAndLiesWhereTheDrawingIs) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "facade-001.png";
  const std::vector<ImagePoint> points = a_wall();
  const FacadeImage image = facade_image(pictured_facade(), source_of(points, 64), params_of(0.1));
  write_facade_image(path, image);
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  ASSERT_TRUE(file);
  EXPECT_EQ(file->GetRasterXSize(), 10);
  ASSERT_EQ(file->GetRasterCount(), 4);
  std::uint8_t red = 0;
  ASSERT_EQ(file->GetRasterBand(1)->RasterIO(GF_Read, 9, 9, 1, 1, &red, 1, 1, GDT_Byte, 0, 0), CE_None);
  EXPECT_EQ(red, 200);
  double transform[6];
  ASSERT_EQ(file->GetGeoTransform(transform), CE_None);  // from the world file
  EXPECT_NEAR(transform[0], 0, 1e-9);
  EXPECT_NEAR(transform[3], 1, 1e-9);
  EXPECT_NEAR(transform[5], -0.1, 1e-9);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files += entry.is_regular_file();
  EXPECT_EQ(files, 2u);
}

TEST(FacadeImage, NoPointsNoColours) {
  const std::vector<ImagePoint> none;
  const FacadeImage image = facade_image(facade_of({}), source_of(none, 64), params_of(0));
  EXPECT_EQ(image.points, 0u);
  EXPECT_EQ(image.empty, static_cast<std::uint64_t>(image.width) * image.height);
}

}  // namespace
}  // namespace ilot
