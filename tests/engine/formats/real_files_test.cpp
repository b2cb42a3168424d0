// SPDX-License-Identifier: Apache-2.0
// Every real file is read or refused with a sentence; nothing crashes. Counts of some are known.
#include <map>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

bool is_candidate(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return is_cloud_extension(path) || extension == ".txt" || extension == ".csv" || extension == ".ptx" ||
         extension == ".e57";
}

TEST(RealFiles, EachIsReadOrRefused) {
  ILOT_DATA_OR_SKIP(data);
  std::size_t read = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data)) {
    if (!entry.is_regular_file() || !is_candidate(entry.path())) continue;
    try {
      const auto reader = open_cloud(entry.path());
      const Rows rows = read_all(*reader, 65536);
      EXPECT_EQ(rows.valid.size(), reader->info().points) << entry.path();
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).rfind(entry.path().string(), 0), 0u) << error.what();
      ++refused;
    }
  }
  RecordProperty("read", static_cast<int>(read));
  RecordProperty("refused", static_cast<int>(refused));
  EXPECT_GE(read, 200u);
}

TEST(RealFiles, KnownCounts) {
  ILOT_DATA_OR_SKIP(data);
  const std::map<std::string, std::uint64_t> counts{
      {"ign/77050_627755_pf6.las", 21172},           {"ign/870000_6618000.las", 70840},
      {"autzen/autzen_north_buildings.las", 549462}, {"roofs/city3d/district_east.las", 1917939},
      {"conformance/pdal/las/extrabytes.las", 1065}, {"conformance/pdal/las/no-points.las", 0},
      {"conformance/pdal/pcd/autzen-utm.pcd", 1065}, {"conformance/pdal/ply/simple_binary.ply", 3},
      {"conformance/pdal/text/utm17_1.txt", 10},     {"conformance/pdal/pts/test.pts", 19}};
  for (const auto& [name, count] : counts) EXPECT_EQ(open_cloud(data / name)->info().points, count) << name;
}

TEST(RealFiles, LasCopiesKeepEveryRowAndRecord) {
  ILOT_DATA_OR_SKIP(data);
  const Folder folder;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "conformance")) {
    const std::filesystem::path& path = entry.path();
    if (path.extension() != ".las") continue;
    const auto reader = open_cloud(path);
    const Rows rows = read_all(*reader);
    const auto writer = create_cloud(folder / "copy.las", {reader->info(), {}, ""});
    writer->write(rows.bytes);
    writer->finish();
    const auto copy = open_cloud(folder / "copy.las");
    EXPECT_EQ(read_all(*copy).bytes, rows.bytes) << path;
    EXPECT_EQ(copy->info().crs.wkt, reader->info().crs.wkt) << path;
    EXPECT_EQ(copy->info().layout.extra.size(), reader->info().layout.extra.size()) << path;
    ASSERT_EQ(copy->info().vlrs.size(), reader->info().vlrs.size()) << path;
    for (std::size_t i = 0; i < copy->info().vlrs.size(); ++i)
      EXPECT_EQ(copy->info().vlrs[i].payload, reader->info().vlrs[i].payload) << path;
  }
}

}  // namespace
}  // namespace ilot
