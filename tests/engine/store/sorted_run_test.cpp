// SPDX-License-Identifier: Apache-2.0
#include "engine/store/sorted_run.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "kernels/core/radix_sort.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using test::kUnit;

std::filesystem::path with(std::filesystem::path stem, const char* suffix) {
  return stem += suffix;
}

SortedRun sort_cloud(const TemporaryFolder& folder, const std::vector<Index3>& points, const IndexFilter& filter,
                     std::uint64_t first, std::uint64_t count) {
  test::write_cloud(folder.path() / "c.las", points);
  const auto reader = open_cloud(folder.path() / "c.las");
  std::uint64_t reported = 0;
  const SortedRun run = make_sorted_run({*reader, 3, first, count}, kUnit, filter, folder.path() / "run",
                                        [&](std::uint64_t n) { reported += n; });
  EXPECT_EQ(reported, count);
  return run;
}

// Oracle: a stable sort of keys.
TEST(SortedRun, ContainsItsRowsSortedByKeyThenRow) {
  const TemporaryFolder folder;
  const auto points = test::points_over_tiles(40000, 1);
  const std::uint64_t first = 1000, count = 38000;
  const SortedRun run = sort_cloud(folder, points, {}, first, count);
  std::vector<std::uint64_t> rows(count);
  for (std::uint64_t i = 0; i < count; ++i) rows[i] = first + i;
  std::stable_sort(rows.begin(), rows.end(), [&](auto a, auto b) { return key_of(points[a]) < key_of(points[b]); });
  const auto stored = read_column<KeyValue>(with(run.stem, ".points"));
  ASSERT_EQ(stored.size(), count);
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_EQ(order_of(stored[i].value), input_order(3, rows[i]));
    ASSERT_EQ(stored[i].key, key_of(points[rows[i]]).code);
  }
  std::uint64_t at = 0;
  for (const RunTile& t : run.tiles) {
    EXPECT_EQ(t.first, at);
    EXPECT_LT(t.first, t.end);
    for (std::uint64_t i = t.first; i < t.end; ++i) ASSERT_EQ(key_of(points[rows[i]]).tile, t.tile);
    at = t.end;
  }
  EXPECT_EQ(at, count);
  ASSERT_EQ(run.samples.size(), (count + kRunSample - 1) / kRunSample);
  for (std::size_t s = 0; s < run.samples.size(); ++s) EXPECT_EQ(run.samples[s], stored[s * kRunSample].key);
}

TEST(SortedRun, AValueContainsOrderClassAndEchoes) {
  const InputOrder order = input_order((1u << 20) - 1, kMostRowsOfInput - 1);
  const RunValue value = run_value(order, 255, 3);
  EXPECT_EQ(order_of(value), order);
  EXPECT_EQ(class_of(value), 255);
  EXPECT_EQ(echoes_of(value), 3);
  EXPECT_EQ(order_of(run_value(input_order(7, 12), 0, 0)), input_order(7, 12));
  EXPECT_LT(run_value(input_order(7, 12), 255, 3), run_value(input_order(7, 13), 0, 0)) << "sorted by input order";
}

TEST(SortedRun, IsFoundAgainAsItWas) {
  const TemporaryFolder folder;
  EXPECT_FALSE(find_sorted_run(folder.path() / "run"));
  const SortedRun run = sort_cloud(folder, test::points_over_tiles(5000, 2), {}, 0, 5000);
  const auto found = find_sorted_run(run.stem);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->samples, run.samples);
  EXPECT_EQ(found->rejected, run.rejected);
  ASSERT_EQ(found->tiles.size(), run.tiles.size());
  for (std::size_t i = 0; i < run.tiles.size(); ++i) {
    EXPECT_EQ(found->tiles[i].tile, run.tiles[i].tile);
    EXPECT_EQ(found->tiles[i].end, run.tiles[i].end);
  }
  std::filesystem::resize_file(with(run.stem, ".table"), std::filesystem::file_size(with(run.stem, ".table")) - 1);
  EXPECT_THROW(find_sorted_run(run.stem), Error);
}

TEST(SortedRun, EveryRowIsStoredOrRejectedWithAReason) {
  const TemporaryFolder folder;
  const auto points = test::points_over_tiles(20000, 3);
  IndexFilter filter;
  filter.keep = IndexBox{{-100, -100, -100}, {3000000, 100, 100}};
  const SortedRun run = sort_cloud(folder, points, filter, 0, points.size());
  const auto kept = std::count_if(points.begin(), points.end(), [&](Index3 p) { return filter.keep->contains(p); });
  EXPECT_EQ(read_column<KeyValue>(with(run.stem, ".points")).size(), static_cast<std::size_t>(kept));
  EXPECT_EQ(run.rejected[static_cast<std::size_t>(Rejection::outside)], points.size() - static_cast<std::size_t>(kept));
  filter = {};
  filter.noise[0] = true;  // the class of all of them
  const SortedRun none = sort_cloud(folder, points, filter, 0, points.size());
  EXPECT_TRUE(none.tiles.empty());
  EXPECT_EQ(none.rejected[static_cast<std::size_t>(Rejection::noise)], points.size());
}

TEST(SortedRun, AFileThatShrankIsAnError) {
  const TemporaryFolder folder;
  EXPECT_THROW(sort_cloud(folder, test::points_over_tiles(100, 4), {}, 50, 51), Error);
  EXPECT_FALSE(find_sorted_run(folder.path() / "run"));
}

}  // namespace
}  // namespace ilot
