// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/copc/copc.h"

#include <functional>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

const char* const kFiles[] = {"conformance/pdal/copc/1.2-with-color.copc.laz",
                              "conformance/pdal/copc/lone-star.copc.laz", "ign/77050_627755.copc.laz"};

std::uint64_t size_of(const std::vector<RowRange>& ranges) {
  std::uint64_t rows = 0;
  for (const RowRange& range : ranges) rows += range.end - range.first;
  return rows;
}

// Places of the hierarchy: of the root page and of its first entry that has points.
std::uint64_t root_page(const PointReader& reader) {
  for (const Vlr& vlr : reader.info().vlrs)
    if (vlr.user_id == "copc" && vlr.record_id == 1) return load<std::uint64_t>(&vlr.payload[40]);
  throw Error("no info record");
}

TEST(Copc, RangesHoldEveryPointOfTheBox) {
  ILOT_DATA_OR_SKIP(data);
  Rng rng(7);
  std::uint64_t asked = 0, given = 0;
  for (const char* name : kFiles) {
    const auto reader = open_cloud(data / name);
    ASSERT_TRUE(is_copc(reader->info())) << name;
    const Rows rows = read_all(*reader, 65536);
    const RecordLayout& layout = reader->info().layout;
    const std::size_t count = rows.valid.size();
    ASSERT_EQ(count, reader->info().points);
    for (int round = 0; round < 60; ++round) {
      // From point to point: sizes from nothing to everything, edges exactly on points.
      const Vec3 a = world(rows, layout, rng.below(static_cast<std::uint32_t>(count)));
      const double reach = round % 3 == 0 ? 0 : round % 3 == 1 ? 5 : 1e9;
      const Vec3 b = world(rows, layout, rng.below(static_cast<std::uint32_t>(count)));
      const Area area{std::max(std::min(a.x, b.x), a.x - reach),
                      std::max(std::min(a.y, b.y), a.y - reach),
                      std::min(std::max(a.x, b.x), a.x + reach),
                      std::min(std::max(a.y, b.y), a.y + reach),
                      {}};
      const std::vector<RowRange> ranges = rows_in_box(*reader, area);
      std::vector<bool> covered(count);
      for (std::size_t i = 0; i < ranges.size(); ++i) {
        ASSERT_LT(ranges[i].first, ranges[i].end);
        ASSERT_LE(ranges[i].end, count);
        if (i > 0) {
          ASSERT_LT(ranges[i - 1].end, ranges[i].first);
        }
        std::fill(covered.begin() + static_cast<std::ptrdiff_t>(ranges[i].first),
                  covered.begin() + static_cast<std::ptrdiff_t>(ranges[i].end), true);
      }
      for (std::size_t row = 0; row < count; ++row) {
        const Vec3 p = world(rows, layout, row);
        const bool inside = p.x >= area.min_x && p.x <= area.max_x && p.y >= area.min_y && p.y <= area.max_y;
        ASSERT_TRUE(!inside || covered[row]) << name << " row " << row;
      }
      asked += count;
      given += size_of(ranges);
    }
    EXPECT_TRUE(rows_in_box(*reader, {-2e9, -2e9, -1e9, -1e9, {}}).empty()) << "far away there is nothing";
    EXPECT_EQ(size_of(rows_in_box(*reader, {-1e9, -1e9, 1e9, 1e9, {}})), count);
  }
  EXPECT_LT(given, asked * 2 / 3) << "the octree saves something";
}

TEST(Copc, OtherFilesAndDamagedHierarchiesGiveAllRows) {
  ILOT_DATA_OR_SKIP(data);
  const Area nowhere{-2e9, -2e9, -1e9, -1e9, {}};
  const auto plain = open_cloud(data / "ign/77050_627755_pf6.las");
  EXPECT_FALSE(is_copc(plain->info()));
  EXPECT_EQ(size_of(rows_in_box(*plain, nowhere)), plain->info().points);

  const Folder folder;
  const std::vector<std::byte> sound = slurp(data / kFiles[2]);
  const auto at = static_cast<std::size_t>(root_page(*open_cloud(data / kFiles[2])));
  const auto damaged = [&](const std::function<void(std::byte*)>& change) {
    std::vector<std::byte> bytes = sound;
    change(&bytes[at]);
    spill(folder / "t.copc.laz", bytes);
    const auto reader = open_cloud(folder / "t.copc.laz");
    return size_of(rows_in_box(*reader, nowhere)) == reader->info().points;
  };
  EXPECT_TRUE(damaged([](std::byte* p) { store(p + 28, load<std::int32_t>(p + 28) + 1); })) << "another count";
  EXPECT_TRUE(damaged([](std::byte* p) { store(p, std::int32_t{-1}); })) << "a negative level";
  EXPECT_TRUE(damaged([](std::byte* p) { store(p, std::int32_t{500}); })) << "an absurd level";
  EXPECT_TRUE(damaged([](std::byte* p) { store(p + 28, std::int32_t{-7}); }));
  EXPECT_TRUE(damaged([&](std::byte* p) {
    store(p + 16, std::uint64_t{at});
    store(p + 24, std::int32_t{32});
    store(p + 28, std::int32_t{-1});
  })) << "a page that names itself";
  EXPECT_TRUE(damaged([](std::byte* p) {
    store(p + 16, UINT64_MAX - 5);
    store(p + 24, std::int32_t{32});
    store(p + 28, std::int32_t{-1});
  })) << "a page behind the end";
}

TEST(Copc, MutatedHierarchiesNeverCrash) {
  ILOT_DATA_OR_SKIP(data);
  const Folder folder;
  const std::vector<std::byte> sound = slurp(data / kFiles[2]);
  const auto at = static_cast<std::size_t>(root_page(*open_cloud(data / kFiles[2])));
  Rng rng(2);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::byte> bytes = sound;
    for (std::uint32_t c = 0; c <= rng.below(3); ++c)
      bytes[at + rng.below(160)] = static_cast<std::byte>(rng.below(256));
    if (rng.below(3) == 0) bytes[429 + rng.below(56)] = static_cast<std::byte>(rng.below(256));
    spill(folder / "t.copc.laz", bytes);
    const auto reader = open_cloud(folder / "t.copc.laz");
    for (const RowRange& range : rows_in_box(*reader, {770510, 6277510, 770515, 6277515, {}}))
      ASSERT_LE(range.end, reader->info().points);
  }
}

}  // namespace
}  // namespace ilot
