// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/stations_pass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "engine/error.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

// The id that the file gives a point is told by its place.
std::uint16_t source_at(Index3 p) {
  return static_cast<std::uint16_t>(p.x < 3000 ? 1 : p.x < 6000 ? 700 : 65535);
}

void write_sources(const std::filesystem::path& path, std::span<const Index3> points, std::uint8_t format) {
  CloudSpec spec;
  spec.like.layout.point_format = format;
  const std::size_t length = standard_size(format);
  spec.like.layout.record_length = static_cast<std::uint16_t>(length);
  spec.like.layout.scale = {test::kUnit, test::kUnit, test::kUnit};
  std::vector<std::byte> records(points.size() * length);
  for (std::size_t i = 0; i < points.size(); ++i) {
    PointFields f;
    f.x = static_cast<std::int32_t>(points[i].x);
    f.y = static_cast<std::int32_t>(points[i].y);
    f.z = static_cast<std::int32_t>(points[i].z);
    f.intensity = static_cast<std::uint16_t>(i);
    f.source_id = source_at(points[i]);
    encode_fields(f, std::span(records).subspan(i * length, length), format);
  }
  const auto writer = create_cloud(path, spec);
  writer->write(records);
  writer->finish();
}

struct Scanned {
  explicit Scanned(std::uint64_t block_points) {
    Rng rng(3);
    std::vector<Index3> points;
    const auto within = [&](std::uint64_t reach) { return static_cast<std::int64_t>(rng.below(reach)); };
    for (std::size_t i = 0; i < 6000; ++i) points.push_back({within(9000), within(5000), within(100)});
    const std::span all(points);
    write_sources(folder.path() / "a.laz", all.first(2000), 0);
    write_sources(folder.path() / "b.laz", all.subspan(2000, 2000), 6);
    write_sources(folder.path() / "c.las", all.subspan(4000), 1);
    test::write_cloud(folder.path() / "d.las", {{100, 100, 5000}, {200, 100, 5000}});
    files.emplace(folder.path(), std::vector{"a.laz", "b.laz", "c.las", "d.las"}, block_points);
  }
  const Store& cloud() const { return *files->cloud; }
  TemporaryFolder folder;
  std::optional<test::FilesStore> files;
};

TEST(StationsPass, EveryPointGetsItsStation) {
  const Scanned s(700);
  ASSERT_GT(s.cloud().blocks().size(), 5u);
  const InputStations by_source{0, {{1, 2}, {65535, 9}}}, all{4, {}}, none;
  // The second input says nothing of the source 700, the last one is one station's whatever its rows say.
  const StationTally tally = stations_pass(s.cloud(), s.files->inputs, {by_source, by_source, none, all}, {});
  const auto where = test::positions(s.cloud());
  const auto order = test::whole_column(s.cloud(), columns::kOrder);
  const auto station = test::whole_column(s.cloud(), columns::kStation);
  std::uint64_t recorded = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    const std::uint64_t file = file_of(order[i]);
    const StationNumber of_source = source_at(where[i]) == 1 ? 2 : source_at(where[i]) == 700 ? 0 : 9;
    ASSERT_EQ(station[i], file == 3 ? 4 : file == 2 ? 0 : of_source) << i;
    recorded += station[i] != 0;
  }
  EXPECT_EQ(tally.recorded, recorded);
  EXPECT_EQ(tally.unrecorded, where.size() - recorded);
}

TEST(StationsPass, BlocksAreInvisible) {
  const Scanned small(500), large(1 << 20);
  const std::vector<InputStations> recorded(4, InputStations{0, {{1, 1}, {700, 2}}});
  stations_pass(small.cloud(), small.files->inputs, recorded, {});
  stations_pass(large.cloud(), large.files->inputs, recorded, {});
  EXPECT_EQ(test::whole_column(small.cloud(), columns::kStation), test::whole_column(large.cloud(), columns::kStation));
}

// A file of one station, told by its file or by each source that its rows name: the same column.
TEST(StationsPass, TheFileTellsWhatAllItsSourcesTell) {
  const Scanned by_file(700), by_source(700);
  std::vector<InputStations> of_file, of_sources;
  for (StationNumber n = 1; n <= 4; ++n) {
    of_file.push_back({n, {}});
    of_sources.push_back({0, {{0, n}, {1, n}, {700, n}, {65535, n}}});
  }
  const StationTally tally = stations_pass(by_file.cloud(), by_file.files->inputs, of_file, {});
  EXPECT_EQ(tally.recorded, 6002u);
  EXPECT_EQ(tally.unrecorded, 0u);
  stations_pass(by_source.cloud(), by_source.files->inputs, of_sources, {});
  const auto station = test::whole_column(by_file.cloud(), columns::kStation);
  EXPECT_EQ(station, test::whole_column(by_source.cloud(), columns::kStation));
  EXPECT_EQ(std::count(station.begin(), station.end(), 4), 2) << "the last file holds two points";
}

// Rows are read again only where they tell something: files that were cut behind their headers are enough else.
TEST(StationsPass, RowsThatTellNothingAreNotRead) {
  const Scanned s(700);
  for (const char* name : {"a.laz", "b.laz", "c.las"}) std::filesystem::resize_file(s.folder.path() / name, 400);
  const std::vector<InputStations> by_file{{1, {}}, {2, {{700, 1}}}, {0, {}}, {0, {{0, 4}}}};
  const StationTally tally = stations_pass(s.cloud(), s.files->inputs, by_file, {});
  EXPECT_EQ(tally.unrecorded, 2000u);
  std::vector<InputStations> by_source = by_file;
  by_source[2].of_source[1] = 3;
  EXPECT_THROW(stations_pass(s.cloud(), s.files->inputs, by_source, {}), Error);
}

}  // namespace
}  // namespace ilot
