// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/make_streets.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "engine/error.h"
#include "engine/run/run.h"
#include "tests/engine/products/streets/street_runs.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using nlohmann::json;
using test::run_cloud;
using test::street_points;
using test::StreetsOutcome;

TEST(StreetsProduct, AllFilesAreThere) {
  const TemporaryFolder folder;
  const StreetsOutcome out = run_cloud(folder, street_points(2, 3), "out");
  for (const char* file :
       {"objects.gpkg", "blocks.gpkg", "range.tif", "accumulation.tif", "ground.tif", "artefacts.tif", "streets.svg"})
    EXPECT_GT(std::filesystem::file_size(out.out / "streets" / file), 0u) << file;
  const json counts = out.record["counts"];
  EXPECT_EQ(counts["points"]["read"], street_points(2, 3).size());
  EXPECT_EQ(counts["points"]["labelled"].get<std::uint64_t>() + counts["points"]["unlabelled"].get<std::uint64_t>(),
            street_points(2, 3).size());
  EXPECT_TRUE(counts["streets"].contains("objects"));
  EXPECT_EQ(out.record["chosen"][0]["key"], "streets.pixel");
}

TEST(StreetsProduct, ObjectsAreFoundOnEverySlope) {
  for (const int percent : {0, 20}) {
    const auto points = street_points(percent, 3);
    const test::CloudStore store(points);
    const FoundStreet street = find_street(store.store(), {}, {});
    std::size_t boxes = 0;
    for (const ObjectCandidate& t : street.candidates)
      if (t.parts[0] == 0 && t.length > 3.5 && t.length < 4.5 && t.width > 1.4 && t.width < 2) ++boxes;
    EXPECT_EQ(boxes, 3u) << percent;
    ASSERT_EQ(street.stretches.size(), 2u) << percent;
    for (const StreetStretch& s : street.stretches) EXPECT_TRUE(s.gaps.empty()) << percent;
  }
}

// From the street what is upright fills its square metres; from above all places have about as many points.
TEST(StreetsProduct, WhereItWasScannedFrom) {
  const test::CloudStore street(street_points(2, 3));
  EXPECT_EQ(find_street(street.store(), {}, {}).view, StreetView::street);
  std::vector<Index3> air;
  Rng rng(6);
  for (int i = 0; i < 24 * 12 * 30; ++i) {
    const auto x = static_cast<std::int64_t>(rng.below(24000)), y = static_cast<std::int64_t>(rng.below(12000));
    air.push_back({700000000 + x, 660000000 + y, y < 1000 || y >= 11000 ? 39000 : 30000});
  }
  const test::CloudStore above(air);
  const FoundStreet found = find_street(above.store(), {}, {});
  EXPECT_EQ(found.view, StreetView::air);
  EXPECT_EQ(found.density.dense_share, 0);
  std::size_t empty = 0, pixels = 0;
  const TileRaster& raster = found.tiles->raster();
  const Image seen = layer_window(found.tiles->layers(), "accumulation", raster.column(700000000) + 4,
                                  raster.row(660000000) + 4, 60, 30);
  for (const Height v : seen.values) empty += v <= 0, ++pixels;
  EXPECT_LE(empty, pixels / 10 + 20) << "a pixel in ten, and some chance";
  StreetsSettings settings;
  settings.view = StreetView::street;
  EXPECT_EQ(find_street(above.store(), settings, {}).view, StreetView::street) << "what is set holds";
  const TemporaryFolder folder;
  const std::string chosen = run_cloud(folder, air, "out").record["chosen"].dump();
  EXPECT_NE(chosen.find(R"("key":"streets.view","value":"air")"), std::string::npos) << chosen;
}

// Two rows of roofs, one point for each square of 20 cm, and ground between them: from the air no front of a house is
// seen, and a line through pixels of roofs is none.
TEST(StreetsProduct, FromTheAirNoHousesAreDrawn) {
  std::vector<Index3> points;
  Rng rng(8);
  for (int i = 0; i < 60 * 40 * 25; ++i) {
    const auto x = static_cast<std::int64_t>(rng.below(60000)), y = static_cast<std::int64_t>(rng.below(40000));
    const bool roof = (y > 4000 && y < 14000) || (y > 26000 && y < 36000);
    points.push_back({700000000 + x, 660000000 + y, roof ? 37000 : 30000});
  }
  const TemporaryFolder folder;
  const StreetsOutcome air = run_cloud(folder, points, "air");
  EXPECT_NE(air.record["chosen"].dump().find(R"("value":"air")"), std::string::npos);
  EXPECT_EQ(air.record["counts"]["streets"]["blocks"], 0);
  EXPECT_EQ(air.record["counts"]["streets"]["gaps"], 0);
  EXPECT_NE(air.record["warnings"].dump().find("houses, gaps between them"), std::string::npos);
  EXPECT_NE(test::file_bytes(air.out / "streets" / "streets.svg").find("Seen from the air: houses"), std::string::npos);
  const StreetsOutcome street =
      run_cloud(folder, points, "street", [](RunOptions& o) { o.settings.streets.view = StreetView::street; });
  EXPECT_EQ(street.record["warnings"].dump().find("houses, gaps between them"), std::string::npos);
}

// What `ilot info` calls unsuitable is made with a warning.
TEST(StreetsProduct, ACloudThatDoesNotSuitIsWarnedOf) {
  Rng rng(9);
  for (const std::int64_t points : {600, 20000}) {  // a step of about 0.94 and 0.16 m
    std::vector<Index3> ground;
    for (std::int64_t i = 0; i < points; ++i)
      ground.push_back({700000000 + static_cast<std::int64_t>(rng.below(60000)),
                        660000000 + static_cast<std::int64_t>(rng.below(40000)), 30000});
    const TemporaryFolder folder;
    const std::string warnings = run_cloud(folder, ground, "out").record["warnings"].dump();
    const bool warned = warnings.find("streets: the cloud does not suit it: 0.9") != std::string::npos;
    EXPECT_EQ(warned, points == 600) << warnings;
  }
}

TEST(StreetsProduct, OneSideOnly) {
  const test::CloudStore store(street_points(2, 2, false));
  const FoundStreet street = find_street(store.store(), {}, {});
  EXPECT_EQ(street.stretches.size(), 1u);
  EXPECT_GE(street.candidates.size(), 2u);
}

// 50 km and more from the first, at a multiple of tiles for pixels of 5 cm.
std::vector<Index3> with_second_site(std::vector<Index3> points) {
  const std::size_t alone = points.size();
  for (std::size_t i = 0; i < alone; ++i)
    points.push_back({points[i].x + 2000 * 25600, points[i].y - 3000 * 25600, points[i].z});
  return points;
}

TEST(StreetsProduct, ASecondSiteFarAwayCostsItsOwnTiles) {
  StreetsSettings settings;
  settings.pixel = 0.05;
  settings.view = StreetView::street;
  const test::CloudStore one(street_points(2, 3)), two(with_second_site(street_points(2, 3)));
  const FoundStreet alone = find_street(one.store(), settings, {}), both = find_street(two.store(), settings, {});
  const TileGrid &grid = both.tiles->raster().grid, &first = alone.tiles->raster().grid;
  EXPECT_EQ(grid.count(), 2 * first.count());
  EXPECT_LT(grid.width, 100u * grid.side);
  EXPECT_LT(grid.height, 100u * grid.side);
  ASSERT_EQ(both.candidates.size(), 2 * alone.candidates.size());
  std::multiset<std::tuple<Height, std::uint64_t, std::uint32_t>> want, got;
  for (const ObjectCandidate& t : alone.candidates)
    for (int times = 0; times < 2; ++times) want.insert({t.ground, t.points, t.pixels});
  for (const ObjectCandidate& t : both.candidates) got.insert({t.ground, t.points, t.pixels});
  EXPECT_EQ(got, want);
  // Places are those of the sites.
  const TileRaster& raster = both.tiles->raster();
  std::size_t far = 0;
  for (const ObjectCandidate& t : both.candidates) far += raster.crs_x(t.x) > 700000 + 1000;
  EXPECT_EQ(far, alone.candidates.size());
  EXPECT_NEAR(raster.crs_x(static_cast<double>(raster.column(700000000 + 2000 * 25600))), 751200, 0.051);
  EXPECT_EQ(raster.column(710000000), -1);
}

TEST(StreetsProduct, RastersOfFarSitesAreSheetsAndAMosaic) {
  const TemporaryFolder folder;
  const auto change = [](RunOptions& options) { options.settings.streets.pixel = 0.05; };
  const StreetsOutcome one = run_cloud(folder, street_points(2, 3), "one", change);
  const StreetsOutcome out = run_cloud(folder, with_second_site(street_points(2, 3)), "two", change);
  EXPECT_FALSE(std::filesystem::exists(out.out / "streets" / "range.tif"));
  EXPECT_FALSE(std::filesystem::exists(one.out / "streets" / "range.vrt"));
  GDALAllRegister();
  const auto open = [&](const std::filesystem::path& file) {
    return GDALDatasetUniquePtr(GDALDataset::Open(file.c_str(), GDAL_OF_RASTER));
  };
  for (const char* layer : {"range", "accumulation", "ground", "artefacts"}) {
    const auto whole = open(out.out / "streets" / (std::string(layer) + ".vrt"));
    const auto alone = open(one.out / "streets" / (std::string(layer) + ".tif"));
    ASSERT_TRUE(whole && alone) << layer;
    EXPECT_LT(std::filesystem::file_size(out.out / "streets" / (std::string(layer) + "_1.tif")), 2u << 20);
    double at[6], of[6];
    whole->GetGeoTransform(at);
    alone->GetGeoTransform(of);
    // Both sites in the mosaic hold what the one holds.
    for (const double dx : {0.0, 51200.0}) {
      const double dy = dx == 0 ? 0 : -76800;
      const auto x = static_cast<int>(std::lround((of[0] + dx - at[0]) / at[1]));
      const auto y = static_cast<int>(std::lround((of[3] + dy - at[3]) / at[5]));
      const int width = alone->GetRasterXSize(), height = alone->GetRasterYSize();
      std::vector<float> want(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)), got = want;
      ASSERT_EQ(alone->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, width, height, want.data(), width, height, GDT_Float32,
                                                  0, 0, nullptr),
                CE_None);
      ASSERT_EQ(whole->GetRasterBand(1)->RasterIO(GF_Read, x, y, width, height, got.data(), width, height, GDT_Float32,
                                                  0, 0, nullptr),
                CE_None);
      EXPECT_EQ(got, want) << layer << " " << dx;
    }
  }
}

#ifdef __SANITIZE_ADDRESS__
constexpr std::uint64_t kLittleMemory = 768u << 20;  // the sanitizer's own memory counts as used
#else
constexpr std::uint64_t kLittleMemory = 256u << 20;
#endif

TEST(StreetsProduct, NothingDependsOnThreadsBlocksOrMemory) {
  const auto points = street_points(3, 2);
  std::string hash;
  struct Way {
    int threads;
    std::uint64_t block_points, memory;
  };
  for (const auto& [threads, block_points, memory] :
       {Way{1, 1u << 20, 1u << 30}, {3, 1u << 20, 1u << 30}, {2, 5000u, 1u << 30}, {2, 1u << 20, kLittleMemory}}) {
    const TemporaryFolder folder;
    const StreetsOutcome out =
        run_cloud(folder, points, "out", [&, t = threads, b = block_points, m = memory](RunOptions& o) {
          o.threads = t;
          o.settings.index.block_points = b;
          o.memory_bytes = m;
        });
    const std::string got = out.record["result_hash"];
    if (hash.empty()) hash = got;
    EXPECT_EQ(got, hash) << threads << " " << block_points;
  }
}

std::size_t boxes_of(const FoundStreet& street) {
  std::size_t boxes = 0;
  for (const ObjectCandidate& t : street.candidates)
    boxes += t.parts[0] == 0 && t.length > 3.5 && t.length < 4.5 && t.width > 1.4 && t.width < 2;
  return boxes;
}

// A deck of 4 m, 6 m above the road, from facade to facade: the street goes on behind it.
TEST(StreetsProduct, ABridgeOverTheStreet) {
  auto points = street_points(0, 3);
  for (std::int64_t x = 14000; x < 18000; x += 50)
    for (std::int64_t y = 600; y < 11400; y += 50) points.push_back({700000000 + x, 660000000 + y, 36000});
  const test::CloudStore store(points);
  EXPECT_GE(boxes_of(find_street(store.store(), {}, {})), 2u) << "those on both sides of the bridge";
}

// Ground behind the houses is ground too, and their walls are no objects.
TEST(StreetsProduct, GroundBehindTheHouses) {
  auto points = street_points(0, 3);
  for (std::int64_t x = 0; x < 24000; x += 50)
    for (std::int64_t y = 50; y < 12000; y += 50) {
      points.push_back({700000000 + x, 660000000 - 1000 - y, 30000});
      points.push_back({700000000 + x, 660000000 + 13000 + y, 30000});
    }
  const TemporaryFolder folder;
  const StreetsOutcome out = run_cloud(folder, points, "out");
  constexpr int kPointsOfBoxes = 3 * 80 * 34;  // may be no objects to the model
  EXPECT_LE(out.record["counts"]["points"]["unlabelled"], kPointsOfBoxes);
  const test::CloudStore store(points);
  const FoundStreet street = find_street(store.store(), {}, {});
  EXPECT_EQ(boxes_of(street), 3u);
  for (const ObjectCandidate& t : street.candidates) EXPECT_LT(t.length, 5) << t.x << " " << t.y;
  EXPECT_EQ(street.stretches.size(), 2u);
}

// A street between walls, a point each 5 cm, of a cloud that is cut so high above the ground.
std::vector<Index3> cut_street(std::int64_t cut) {
  auto points = street_points(0, 3);
  std::erase_if(points, [](const Index3& p) { return p.y < 660000600 || p.y >= 660011400; });
  Rng rng(9);
  for (std::int64_t x = 0; x < 24000; x += 50)
    for (std::int64_t z = 0; z < cut; z += 50)
      for (const std::int64_t y : {600, 11400})
        points.push_back({700000000 + x, 660000000 + y + static_cast<std::int64_t>(rng.below(15)), 30000 + z});
  return points;
}

// A cloud that is cut low above the ground still has its walls: they are no objects.
TEST(StreetsProduct, WallsThatAreCutLow) {
  for (const std::int64_t cut : {1400, 1800, 2400, 4000}) {
    const test::CloudStore store(cut_street(cut));
    const FoundStreet street = find_street(store.store(), {}, {});
    EXPECT_EQ(boxes_of(street), 3u) << cut;
    for (const ObjectCandidate& t : street.candidates) EXPECT_LT(t.length, 5) << cut << " " << t.x << " " << t.y;
  }
}

// Clouds that hold no street: a clear end, nothing thrown.
TEST(StreetsProduct, CloudsWithoutAStreet) {
  std::vector<Index3> sparse, wall;
  Rng rng(8);
  for (int i = 0; i < 300; ++i)
    sparse.push_back({static_cast<std::int64_t>(rng.below(400000)), static_cast<std::int64_t>(rng.below(400000)),
                      static_cast<std::int64_t>(rng.below(20000))});
  for (std::int64_t x = 0; x < 8000; x += 40)
    for (std::int64_t z = 0; z < 8000; z += 40) wall.push_back({x, 0, z});
  const std::vector<std::pair<std::string, std::vector<Index3>>> clouds{
      {"one point", {{5, 5, 5}}},
      {"one pixel", {{5, 5, 5}, {6, 6, 900}, {7, 7, 4000}}},
      {"sparse", sparse},
      {"no ground", wall}};
  for (const auto& [name, points] : clouds) {
    const TemporaryFolder folder;
    const StreetsOutcome out = run_cloud(folder, points, "out");
    EXPECT_EQ(out.record["counts"]["streets"]["objects"], 0) << name;
    EXPECT_EQ(out.code, static_cast<int>(ExitCode::incomplete)) << name;
    ASSERT_EQ(out.record["skipped"].size(), 1u) << name;
    EXPECT_EQ(out.record["skipped"][0]["where"], "streets");
  }
}

}  // namespace
}  // namespace ilot
