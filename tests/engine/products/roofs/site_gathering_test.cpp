// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/site_gathering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>
#include <variant>

#include "engine/products/roofs/site_modeller.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

constexpr std::int64_t kX = 84000000, kY = 447000000;  // millimetres: the house's corner

// A house of 10 x 8 m under a gable, with walls; beside it ground, and points of no class in it.
struct House {
  TemporaryFolder folder;
  std::unique_ptr<Store> store;
  std::vector<PlannedSite> sites;
  std::unique_ptr<OutlineMap> map;

  explicit House(std::uint64_t block_points, Index3 by = {}) {
    Rng rng(11);
    std::vector<Index3> points;
    std::vector<std::uint8_t> classes;
    const auto below = [&](std::uint64_t n) { return static_cast<std::int64_t>(rng.below(n)); };
    for (int i = 0; i < 24000; ++i) {
      std::int64_t x = below(10000), y = below(8000), z = 3000 + std::min(y, 8000 - y) / 2 + below(40);
      if (i % 3 == 0) x = below(40), z = below(3000);
      if (i % 5 == 0) x = -below(3000), z = below(40);
      points.push_back({kX + x + by.x, kY + y + by.y, z + by.z});
      classes.push_back(i % 5 == 0 ? 2 : i % 7 == 0 ? 1 : 6);
    }
    test::write_cloud(folder.path() / "house.las", points, classes, 0, by);
    std::vector<std::unique_ptr<PointReader>> inputs;
    inputs.push_back(open_cloud(folder.path() / "house.las"));
    IndexParams params;
    params.unit = test::kUnit;
    params.block_points = block_points;
    params.classes = ClassColumns::written;
    store = std::make_unique<Store>(build_index(inputs, params, folder.path() / "store", {}).store);
    const auto roles = point_roles(std::vector<int>{6}, std::vector<int>{2});
    for (std::uint32_t b = 0; b < store->blocks().size(); ++b) {
      std::vector<PointRole> column;
      for (const std::uint8_t code : store->read(b, columns::kClass)) column.push_back(roles[code]);
      store->write(b, columns::kRole, column);
    }
    const std::int64_t x = kX + by.x, y = kY + by.y;
    sites.push_back({"house", place_outline({{{x, y}, {x + 10000, y}, {x + 10000, y + 8000}, {x, y + 8000}}}), "", ""});
    map = std::make_unique<OutlineMap>(std::vector<GridBox>{sites[0].outline.box});
  }
  SiteWork work(std::size_t most) const { return {*store, sites, *map, {}, 1, most}; }
};

using Millimetres = std::tuple<std::int64_t, std::int64_t, std::int64_t>;

std::vector<Millimetres> coordinates(const std::vector<Vec3>& points) {
  std::vector<Millimetres> all;
  for (const Vec3& p : points)
    all.emplace_back(std::llround(1e3 * p.x), std::llround(1e3 * p.y), std::llround(1e3 * p.z));
  return all;
}

std::vector<Vec3> streamed(const SiteReader& reader) {
  std::vector<Vec3> all;
  reader.for_each_stretch([&](std::uint32_t, std::span<const std::uint32_t> points, std::span<const Vec3> at) {
    EXPECT_EQ(points.size(), at.size());
    all.insert(all.end(), at.begin(), at.end());
  });
  return all;
}

TEST(SiteGathering, AllPointsComeInStretchesAsTheyWereGathered) {
  const House house(1000);
  const SiteWork work = house.work(1 << 20);
  SiteReader reader(work, 0);
  const GatheredSite site = reader.gather();
  EXPECT_FALSE(site.thinned);
  EXPECT_TRUE(site.by_class);
  EXPECT_GT(site.points, 15000u);
  EXPECT_EQ(site.points, site.site.points.size());
  EXPECT_EQ(coordinates(streamed(reader)), coordinates(site.site.points));
}

TEST(SiteGathering, ALargeHouseIsASampleOfItself) {
  const House house(1000);
  const SiteWork all_work = house.work(1 << 20), few_work = house.work(2000);
  SiteReader whole(all_work, 0), sampled(few_work, 0);
  const GatheredSite all = whole.gather(), few = sampled.gather();
  EXPECT_TRUE(few.thinned);
  EXPECT_EQ(few.points, all.points);
  EXPECT_EQ(few.points_around, all.points_around);
  EXPECT_LE(few.site.points.size(), 2000u);
  EXPECT_GT(few.site.points.size(), 500u);
  EXPECT_EQ(few.site.anchor.z, all.site.anchor.z);
  EXPECT_EQ(few.site.ground, all.site.ground);
  EXPECT_EQ(coordinates(streamed(sampled)), coordinates(all.site.points)) << "labels are for all points";
  const auto of_all = coordinates(all.site.points), of_few = coordinates(few.site.points);
  const std::set<Millimetres> known(of_all.begin(), of_all.end());
  for (const auto& p : of_few) EXPECT_TRUE(known.count(p) == 1);
}

TEST(SiteGathering, TheSampleDependsOnContentAlone) {
  const auto sample_of = [](const House& house) {
    const SiteWork work = house.work(2000);
    return coordinates(SiteReader(work, 0).gather().site.points);
  };
  const auto whole = sample_of(House(1 << 20));
  EXPECT_EQ(sample_of(House(300)), whole);
  auto moved = sample_of(House(1 << 20, {7000, -3000, 2000}));  // whole metres: the order in the store is another
  auto sorted = whole;
  std::sort(moved.begin(), moved.end());
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(moved, sorted);
}

TEST(SiteGathering, WithoutAClassOfBuildingsTheOthersAboveTheGround) {
  const House house(1000);
  for (std::uint32_t b = 0; b < house.store->blocks().size(); ++b) {
    auto roles = house.store->read(b, columns::kRole);
    for (PointRole& r : roles) r = r == PointRole::building ? PointRole::unclassified : r;
    house.store->write(b, columns::kRole, roles);
  }
  const SiteWork all_work = house.work(1 << 20), few_work = house.work(2000);
  SiteReader whole(all_work, 0), sampled(few_work, 0);
  const GatheredSite all = whole.gather(), few = sampled.gather();
  EXPECT_FALSE(all.by_class);
  EXPECT_EQ(few.points, all.points);
  for (const Vec3& p : all.site.points) EXPECT_GE(p.z, all.site.ground + 1);
  EXPECT_EQ(coordinates(streamed(sampled)), coordinates(all.site.points));
}

// The model of a sample is the house, and every point of it has a label.
TEST(SiteModeller, AThinnedHouseHasItsFacesAndAllItsLabels) {
  const House house(1000);
  const auto modelled = [&](std::size_t most) {
    const SiteWork work = house.work(most);
    RoofLabels labels(*house.store);
    return SiteModeller(work, {}, {}, labels).model(0);
  };
  const SiteResult all = modelled(1 << 20), few = modelled(4000);
  EXPECT_FALSE(all.thinned);
  EXPECT_TRUE(few.thinned);
  EXPECT_EQ(all.status, RoofStatus::lod22);
  EXPECT_EQ(few.status, RoofStatus::lod22);
  EXPECT_EQ(few.planes, all.planes);
  const auto attribute = [](const SiteResult& r, const char* name) {
    for (const auto& [key, value] : r.levels[0].attributes)
      if (key == name)
        return std::holds_alternative<double>(value) ? std::get<double>(value)
                                                     : static_cast<double>(std::get<std::int64_t>(value));
    return -1.0;
  };
  EXPECT_EQ(attribute(few, "points"), attribute(all, "points"));
  EXPECT_NEAR(attribute(few, "rmse_m"), attribute(all, "rmse_m"), 0.01);
  EXPECT_NEAR(attribute(few, "h_roof_50"), attribute(all, "h_roof_50"), 0.01);
  EXPECT_NEAR(attribute(few, "explained"), attribute(all, "explained"), 0.02);
  const auto labelled = [](const SiteResult& r) {
    std::uint64_t n = 0;
    for (const LabelRun& run : r.labels) n += run.count;
    return n;
  };
  EXPECT_EQ(labelled(few), labelled(all));
}

// From the Netherlands to the coordinates of the north of France. 262,144 m are whole metres, on which sites start, and
// whole tiles of 2^21 mm, in which the points are ordered: the site is the same, so is its model.
TEST(SiteModeller, TheSameBuildingElsewhereIsTheSame) {
  constexpr std::int64_t kStep = 262144000;
  const Index3 by{2 * kStep, 24 * kStep, 0};
  const auto modelled = [](const House& house) {
    const SiteWork work = house.work(1 << 20);
    RoofLabels labels(*house.store);
    return SiteModeller(work, {}, {}, labels).model(0);
  };
  const SiteResult here = modelled(House(1000)), there = modelled(House(1000, by));
  EXPECT_EQ(here.status, RoofStatus::lod22);
  EXPECT_EQ(there.status, here.status);
  EXPECT_EQ(there.planes, here.planes);
  // A coordinate is a site's anchor, in whole metres, and what is added to it. Doubles at 6,800 km lie 2^-30 m apart:
  // the sum there is off by half of that at most, the one here by less.
  const double rounding = std::ldexp(1, -30);
  const auto same_place = [&](Vec3 a, Vec3 b) {
    EXPECT_NEAR(b.x - a.x, 0.001 * static_cast<double>(by.x), rounding);
    EXPECT_NEAR(b.y - a.y, 0.001 * static_cast<double>(by.y), rounding);
    EXPECT_EQ(b.z, a.z);
  };
  ASSERT_EQ(there.levels.size(), here.levels.size());
  for (std::size_t level = 0; level < here.levels.size(); ++level) {
    const Building &a = here.levels[level], &b = there.levels[level];
    ASSERT_EQ(b.vertices.size(), a.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) same_place(a.vertices[i], b.vertices[i]);
    ASSERT_EQ(b.surfaces.size(), a.surfaces.size());
    for (std::size_t i = 0; i < a.surfaces.size(); ++i) {
      EXPECT_EQ(b.surfaces[i].kind, a.surfaces[i].kind);
      EXPECT_EQ(b.surfaces[i].rings, a.surfaces[i].rings);
    }
    ASSERT_EQ(b.attributes.size(), a.attributes.size());
    for (std::size_t i = 0; i < a.attributes.size(); ++i) {
      EXPECT_EQ(b.attributes[i].first, a.attributes[i].first);
      if (const double* measured = std::get_if<double>(&a.attributes[i].second)) {
        // Distances from planes that are no steeper than 45 degrees: x, y and their rounding here count at most once
        // each.
        EXPECT_NEAR(std::get<double>(b.attributes[i].second), *measured, 4 * rounding) << a.attributes[i].first;
      } else {
        EXPECT_EQ(b.attributes[i].second, a.attributes[i].second) << a.attributes[i].first;
      }
    }
  }
  ASSERT_EQ(there.labels.size(), here.labels.size());
  for (std::size_t i = 0; i < here.labels.size(); ++i) EXPECT_EQ(there.labels[i].count, here.labels[i].count);
}

}  // namespace
}  // namespace ilot
