// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/colours_pass.h"

#include <gtest/gtest.h>

#include <optional>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

// The colour of a point is told by its place: red in the west, blue in the east, a little darker with y.
StoredColour colour_at(Index3 p) {
  const auto shade = static_cast<StoredColour>(200 + p.y / 100);
  return p.x < 5000 ? shade << 16 : shade;
}

std::vector<Index3> scattered_points(std::size_t n) {
  Rng rng(3);
  std::vector<Index3> points;
  const auto within = [&](std::uint64_t reach) { return static_cast<std::int64_t>(rng.below(reach)); };
  for (std::size_t i = 0; i < n; ++i) points.push_back({within(9000), within(5000), within(100)});
  return points;
}

void write_coloured(const std::filesystem::path& path, std::span<const Index3> points, int bits) {
  CloudSpec spec;
  spec.like.layout.point_format = 2;
  spec.like.layout.record_length = 26;
  spec.like.layout.scale = {test::kUnit, test::kUnit, test::kUnit};
  std::vector<std::byte> records(points.size() * 26);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointFields f;
    f.x = static_cast<std::int32_t>(points[i].x);
    f.y = static_cast<std::int32_t>(points[i].y);
    f.z = static_cast<std::int32_t>(points[i].z);
    const auto record = std::span(records).subspan(i * 26, 26);
    encode_fields(f, record, 2);
    const StoredColour c = colour_at(points[i]);
    for (int channel = 0; channel < 3; ++channel)
      store<std::uint16_t>(record.data() + 20 + 2 * channel,
                           static_cast<std::uint16_t>((c >> (16 - 8 * channel) & 255) << (bits - 8)));
  }
  const auto writer = create_cloud(path, spec);
  writer->write(records);
  writer->finish();
}

struct Coloured {
  Coloured(const std::vector<Index3>& points, std::uint64_t block_points, bool backwards = false) {
    const auto half = points.size() / 2;
    const std::span all(points);
    write_coloured(folder.path() / "a.las", all.first(half), 16);
    write_coloured(folder.path() / "b.las", all.subspan(half), 8);
    test::write_cloud(folder.path() / "c.las", {{100, 100, 5000}, {200, 100, 5000}});
    std::vector names{"a.las", "b.las", "c.las"};
    if (backwards) std::reverse(names.begin(), names.end());
    files.emplace(folder.path(), names, block_points);
  }
  const Store& cloud() const { return *files->cloud; }
  TemporaryFolder folder;
  std::optional<test::FilesStore> files;
};

TEST(ColoursPass, EveryPointGetsItsOwnColourInEightBits) {
  const Coloured c(scattered_points(5000), 700);
  ASSERT_GT(c.cloud().blocks().size(), 5u);
  ASSERT_TRUE(colours_pass(c.cloud(), c.files->inputs, {}));
  const auto where = test::positions(c.cloud());
  const auto colour = test::whole_column(c.cloud(), columns::kColour);
  std::size_t none = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    none += colour[i] == kNoColour;
    if (where[i].z < 5000) {
      ASSERT_EQ(colour[i], colour_at(where[i])) << i;
    }
  }
  EXPECT_EQ(none, 2u) << "of the input without colours";
}

TEST(ColoursPass, WithoutColoursThereIsNothing) {
  const test::CloudStore cloud({{1, 2, 3}, {4, 5, 6}});
  EXPECT_FALSE(colours_pass(cloud.store(), cloud.inputs(), {}));
  EXPECT_FALSE(cloud.store().has(0, columns::kColour));
}

TEST(ColoursPass, ThePaletteDependsOnThePointsAlone) {
  const auto points = scattered_points(5000);
  const Coloured a(points, 700), b(points, 1 << 20, true);
  ASSERT_TRUE(colours_pass(a.cloud(), a.files->inputs, {}));
  ASSERT_TRUE(colours_pass(b.cloud(), b.files->inputs, {}));
  const ColourPalette one = colour_palette(a.cloud(), 2, 0), other = colour_palette(b.cloud(), 2, 0);
  EXPECT_EQ(one.centre, other.centre);
  ASSERT_EQ(one.centre.size(), 2u);
  EXPECT_NE(one.class_of(0xd00000), one.class_of(0x0000d0));
  EXPECT_EQ(one.class_of(0xd00000), one.class_of(0xe00000));
  EXPECT_EQ(one.class_of(kNoColour), 0u);
  EXPECT_EQ(ColourPalette{}.class_of(0xd00000), 0u);
}

}  // namespace
}  // namespace ilot
