// SPDX-License-Identifier: Apache-2.0
// Pavements of a run over a street whose truth is known exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "ilot/streets.h"
#include "tests/engine/products/streets/street_runs.h"

namespace ilot {
namespace {

constexpr std::int64_t kX = 700000000, kY = 660000000;  // millimetres

// 36 m of road with a kerb of 12 cm at y = 7 m and pavement behind it, a point each 4 cm. A house stands at y = 10 m
// for 16 m and one at 10.6 m for the next 8 m; behind the last 12 m is a yard. A box of 60 cm stands on the pavement.
std::vector<Index3> street_with_houses() {
  Rng rng(3);
  std::vector<Index3> points;
  const auto ground = [](double x, double y) { return 30 + 0.02 * x + (y < 7 ? 0.0 : 0.12 + 0.02 * (y - 7)); };
  const auto add = [&](double x, double y, double z) {
    points.push_back({kX + std::llround(1000 * x), kY + std::llround(1000 * y), std::llround(1000 * z)});
  };
  const auto wall_of = [](double x) { return x < 16 ? 10.0 : x < 24 ? 10.6 : 16.0; };
  const auto on_box = [](double x, double y) { return x > 5 && x < 5.6 && y > 7.5 && y < 8.1; };
  for (double x = 0; x < 36; x += 0.04)
    for (double y = 0; y < 16; y += 0.04) {
      const double u = x + 0.03 * rng.uniform(), v = y + 0.03 * rng.uniform();
      if (v < wall_of(u)) add(u, v, ground(u, v) + (on_box(u, v) ? 1.1 : 0) + 0.008 * (rng.uniform() - 0.5));
    }
  for (double h = 0; h < 1.1; h += 0.03)
    for (double s = 0; s < 0.6; s += 0.03) {
      add(5 + s, 7.5, ground(5, 7.5) + h), add(5 + s, 8.1, ground(5, 8.1) + h);
      add(5, 7.5 + s, ground(5, 7.5) + h), add(5.6, 7.5 + s, ground(5.6, 7.5) + h);
    }
  for (double x = 0; x < 24; x += 0.04)
    for (double h = 0; h < 8; h += 0.05)
      add(x + 0.03 * rng.uniform(), wall_of(x) + 0.01 * (rng.uniform() - 0.5), ground(x, 10) + h);
  for (double h = 0; h < 8; h += 0.05) {  // the sides of the houses
    for (double y = 10; y < 10.6; y += 0.04) add(16, y, ground(16, 10) + h);
    for (double y = 10.6; y < 16; y += 0.04) add(24, y, ground(24, 10) + h);
  }
  return points;
}

struct PavementOutcome {
  StreetPlan plan;
  std::string bytes;
  nlohmann::json counts;
};

PavementOutcome run_pavements(const std::vector<Index3>& points, const std::function<void(RunOptions&)>& change = {}) {
  const TemporaryFolder folder;
  const test::StreetsOutcome done = test::run_mapped(folder, points, change);
  return {read_streets(done.out), test::file_bytes(done.out / "streets" / "pavements.gpkg"),
          done.record["counts"]["streets"]};
}

TEST(PavementMap, WidthsEndAtTheHousesAndTheYardIsOpen) {
  const PavementOutcome out = run_pavements(street_with_houses());
  std::size_t unsure = 0;
  const auto is_wall = [&](const PavementWidth& w) {
    unsure += w.end == PavementEnd::unsure;
    return w.end == PavementEnd::wall || w.end == PavementEnd::unsure;
  };
  std::size_t near = 0, far = 0, open = 0, beside_box = 0;
  for (const PavementWidth& w : out.plan.widths) {
    const double x = w.from.x - kX / 1000.0;
    EXPECT_NEAR(w.from.y, kY / 1000.0 + 7, 0.06);
    if (x > 1 && x < 15) {
      EXPECT_TRUE(is_wall(w)) << x;
      EXPECT_NEAR(w.width_m, 3, 0.08) << x;
      EXPECT_LE(std::abs(w.width_m - 3), w.end == PavementEnd::wall ? w.error_m : 0.1) << x;
      EXPECT_NEAR(w.to.z, 30 + 0.02 * x + 0.18, 0.03) << x;
      const bool beside = x > 4.6 && x < 6;
      EXPECT_NEAR(w.passable_m, beside ? 1.9 : 3, 0.12) << x;
      ++near, beside_box += beside;
    }
    if (x > 17 && x < 23) {
      EXPECT_TRUE(is_wall(w)) << x;
      EXPECT_NEAR(w.width_m, 3.6, 0.08) << x;
      ++far;
    }
    if (x > 25.5 && x < 35) {
      EXPECT_EQ(w.end, PavementEnd::open) << x;
      EXPECT_NEAR(w.width_m, 6, 0.1) << x;
      EXPECT_EQ(w.error_m, 0) << x;
      ++open;
    }
    EXPECT_EQ(w.road_m, 0) << "there is one kerb";
  }
  EXPECT_GE(near, 12u);
  EXPECT_GE(far, 5u);
  EXPECT_GE(open, 7u);
  EXPECT_GE(beside_box, 1u);
  double area = 0, length = 0;
  for (const Pavement& p : out.plan.pavements) area += p.area_m2, length += p.length_m;
  EXPECT_GT(length, 12);
  EXPECT_GT(area, 3 * length - 1);
  EXPECT_LT(area, 3.6 * length);
  EXPECT_LE(unsure, 4u) << "pieces of kerb of one place, of which nothing confirms the width";
  EXPECT_EQ(out.counts["pavement_widths"], out.plan.widths.size());
  EXPECT_EQ(out.counts["pavements"], out.plan.pavements.size());
}

TEST(PavementMap, NothingDependsOnThreadsBlocksOrderOrMemory) {
  std::vector<Index3> points = street_with_houses();
  const PavementOutcome one = run_pavements(points, [](RunOptions& o) { o.threads = 1; });
  ASSERT_FALSE(one.plan.pavements.empty());
  EXPECT_EQ(run_pavements(points, [](RunOptions& o) { o.threads = 3; }).bytes, one.bytes);
  EXPECT_EQ(run_pavements(points,
                          [](RunOptions& o) {
                            o.settings.index.block_points = 20000;
                            o.memory_bytes = std::uint64_t{256} << 20;
                          })
                .bytes,
            one.bytes);
  std::reverse(points.begin(), points.end());
  EXPECT_EQ(run_pavements(points).bytes, one.bytes);
}

// Moved by whole pixels (those of the cells in which kerbs are sought), the borders of tiles lie elsewhere.
TEST(PavementMap, MovedStreetsHaveTheSameWidths) {
  const std::vector<Index3> points = street_with_houses();
  std::vector<Index3> moved = points;
  for (Index3& p : moved) p.x += 50 * 136, p.y -= 50 * 40;
  const PavementOutcome still = run_pavements(points), other = run_pavements(moved);
  ASSERT_EQ(other.plan.widths.size(), still.plan.widths.size());
  for (const PavementWidth& w : still.plan.widths) {
    const auto same = [&](const PavementWidth& o) {
      return std::hypot(o.from.x - w.from.x - 6.8, o.from.y - w.from.y + 2) < 1e-6 && o.end == w.end &&
             std::abs(o.width_m - w.width_m) < 1e-6 && std::abs(o.passable_m - w.passable_m) < 1e-6;
    };
    EXPECT_TRUE(std::any_of(other.plan.widths.begin(), other.plan.widths.end(), same)) << w.from.x;
  }
}

// Turned by a quarter, pixels are the same squares; kerbs are smoothed in another order.
TEST(PavementMap, TurnedStreetsHaveTheSameWidths) {
  std::vector<Index3> points = street_with_houses();
  for (Index3& p : points) p = {kX - (p.y - kY) - 1, kY + (p.x - kX), p.z};
  std::size_t walls = 0, open = 0;
  for (const PavementWidth& w : run_pavements(points).plan.widths) {
    const double along = w.from.y - kY / 1000.0;
    if ((along > 1 && along < 15) || (along > 17 && along < 23)) {
      EXPECT_NEAR(w.width_m, along < 16 ? 3 : 3.6, 0.08) << along;
      walls += w.end == PavementEnd::wall;
    }
    if (along > 25.5 && along < 35) open += w.end == PavementEnd::open;
  }
  EXPECT_GE(walls, 14u);
  EXPECT_GE(open, 7u);
}

}  // namespace
}  // namespace ilot
