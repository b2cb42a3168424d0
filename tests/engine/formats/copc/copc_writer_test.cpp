// SPDX-License-Identifier: Apache-2.0
// Files by our COPC writer, read back by ourselves and, where it is installed, by npm's copc 0.0.8:
// npm install laz-perf@0.0.7 copc@0.0.8 in the folder that ILOT_NPM names.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/formats/copc/copc.h"
#include "engine/formats/las/modern_record.h"
#include "kernels/core/parallel.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

const Vlr& copc_vlr(const CloudInfo& info, std::uint16_t id) {
  for (const Vlr& vlr : info.vlrs)
    if (vlr.user_id == "copc" && vlr.record_id == id) return vlr;
  throw Error("no such record");
}

std::vector<std::string> sorted_rows(const std::vector<std::byte>& bytes, std::size_t length) {
  std::vector<std::string> rows;
  for (std::size_t at = 0; at < bytes.size(); at += length)
    rows.emplace_back(reinterpret_cast<const char*>(&bytes[at]), length);
  std::sort(rows.begin(), rows.end());
  return rows;
}

// Random attributes on a wavy surface with a crowded corner: the tree has several levels.
std::vector<std::byte> surface(std::size_t count, const RecordLayout& layout, std::uint64_t key) {
  std::vector<std::byte> rows = random_bytes(count * layout.record_length, key);
  Rng rng(key);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t reach = i % 3 ? 200000 : 900;
    const auto x = static_cast<std::int32_t>(rng.below(reach)), y = static_cast<std::int32_t>(rng.below(reach));
    std::byte* p = &rows[i * layout.record_length];
    store(p, x);
    store(p + 4, -y);
    store(p + 8, std::int32_t{(x / 64 * 7 + y / 32) % 5000});
  }
  return rows;
}

CloudSpec copc_spec_of(std::uint8_t format, std::uint16_t extra) {
  CloudSpec spec;
  RecordLayout& layout = spec.like.layout;
  layout.point_format = format;
  layout.record_length = static_cast<std::uint16_t>(standard_size(format) + extra);
  layout.scale = {0.001, 0.002, 0.01};
  layout.offset = {650000, 6860000, -20};
  return spec;
}

void write_copc(const std::filesystem::path& path, const CloudSpec& spec, const std::vector<std::byte>& rows,
                std::size_t piece = 1 << 20) {
  const auto writer = create_cloud(path, spec);
  const std::size_t step = piece * writer->record_length();
  for (std::size_t at = 0; at < rows.size(); at += step)
    writer->write(std::span(rows).subspan(at, std::min(step, rows.size() - at)));
  writer->finish();
}

// Every node lies where its entry says, and its points lie in its cube.
void check_nodes(PointReader& reader) {
  const Rows rows = read_all(reader, 65536);
  const RecordLayout& layout = reader.info().layout;
  const std::byte* info = copc_vlr(reader.info(), 1).payload.data();
  const double low[3]{load<double>(info) - load<double>(info + 24), load<double>(info + 8) - load<double>(info + 24),
                      load<double>(info + 16) - load<double>(info + 24)};
  const std::vector<std::byte> entries = copc_vlr(reader.info(), 1000).payload;
  ASSERT_EQ(load<std::uint64_t>(info + 48), entries.size());
  const std::vector<std::uint64_t> boundaries = reader.boundaries();
  ASSERT_EQ(entries.size() / 32 + 1, boundaries.size());
  for (std::size_t i = 0; i + 1 < boundaries.size(); ++i) {
    const std::byte* entry = &entries[32 * i];
    ASSERT_EQ(load<std::int32_t>(entry + 28), static_cast<std::int32_t>(boundaries[i + 1] - boundaries[i]));
    const double edge = std::ldexp(2 * load<double>(info + 24), -load<std::int32_t>(entry));
    for (std::uint64_t row = boundaries[i]; row < boundaries[i + 1]; ++row) {
      const Vec3 p = world(rows, layout, row);
      const double at[3]{p.x, p.y, p.z};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double from = low[axis] + load<std::int32_t>(entry + 4 + 4 * axis) * edge;
        ASSERT_GE(at[axis], from - 1e-7);
        ASSERT_LE(at[axis], from + edge + 1e-7);
      }
    }
  }
}

// Rows outside the ranges are outside the box; returns how many rows the ranges hold.
std::uint64_t check_box(const PointReader& reader, const Rows& rows, const Area& area) {
  std::vector<bool> covered(rows.valid.size());
  std::uint64_t given = 0;
  for (const RowRange& range : rows_in_box(reader, area)) {
    std::fill(covered.begin() + static_cast<std::ptrdiff_t>(range.first),
              covered.begin() + static_cast<std::ptrdiff_t>(range.end), true);
    given += range.end - range.first;
  }
  for (std::size_t row = 0; row < covered.size(); ++row) {
    const Vec3 p = world(rows, reader.info().layout, row);
    const bool inside = p.x >= area.min_x && p.x <= area.max_x && p.y >= area.min_y && p.y <= area.max_y;
    EXPECT_TRUE(!inside || covered[row]) << "row " << row;
  }
  return given;
}

TEST(CopcWriter, EveryFormatComesBackAsTheSameSetOfRows) {
  const Folder folder;
  for (std::uint8_t format = 0; format <= 10; ++format) {
    SCOPED_TRACE(int(format));
    const std::uint16_t extra = format % 2 ? 3 : 0;
    const CloudSpec spec = copc_spec_of(format, extra);
    const auto rows = surface(90000, spec.like.layout, format);
    write_copc(folder / "t.copc.laz", spec, rows, 777);
    const auto reader = open_cloud(folder / "t.copc.laz");
    EXPECT_TRUE(reader->info().warnings.empty());
    ASSERT_TRUE(is_copc(reader->info()));
    ASSERT_EQ(reader->info().layout.point_format, modern_format(format));
    std::vector<std::byte> expected(90000 * reader->info().layout.record_length);
    modernise(rows, format, extra, expected);
    EXPECT_TRUE(sorted_rows(read_all(*reader, 50000).bytes, reader->info().layout.record_length) ==
                sorted_rows(expected, reader->info().layout.record_length));
    EXPECT_GT(reader->boundaries().size(), 3u);
    check_nodes(*reader);
    EXPECT_EQ(folder.files(), 1u);
  }
}

TEST(CopcWriter, BoxesNeedTheRangesThatHoldTheirPoints) {
  const Folder folder;
  const CloudSpec spec = copc_spec_of(7, 0);
  write_copc(folder / "t.copc.laz", spec, surface(300000, spec.like.layout, 5));
  const auto reader = open_cloud(folder / "t.copc.laz");
  const Rows rows = read_all(*reader, 65536);
  Rng rng(6);
  std::uint64_t given = 0;
  for (int round = 0; round < 40; ++round) {
    const Vec3 p = world(rows, reader->info().layout, rng.below(300000));
    const double reach = round % 4 * 0.7;
    given += check_box(*reader, rows, {p.x - reach, p.y - reach, p.x + reach, p.y + reach, {}});
  }
  EXPECT_LT(given, 40u * 300000 * 2 / 3) << "the octree saves something";
  EXPECT_EQ(check_box(*reader, rows, {0, 0, 1, 1, {}}), 0u);
  EXPECT_EQ(check_box(*reader, rows, {-1e9, -1e9, 1e9, 1e9, {}}), 300000u);
}

TEST(CopcWriter, InfoRecordStandsFirstAndSaysWhatIsThere) {
  const Folder folder;
  const CloudSpec spec = copc_spec_of(6, 0);
  auto rows = surface(100, spec.like.layout, 8);
  for (std::size_t i = 0; i < 100; ++i)
    store(&rows[i * 30 + 22], i == 50 ? std::nan("") : 1000.0 - static_cast<double>(i));
  write_copc(folder / "t.copc.laz", spec, rows);
  const std::vector<std::byte> file = slurp(folder / "t.copc.laz");
  EXPECT_EQ(load<std::uint16_t>(&file[94]), 375);
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(&file[377]), 4), "copc");
  EXPECT_EQ(load<std::uint16_t>(&file[393]), 1);
  EXPECT_EQ(load<std::uint16_t>(&file[395]), 160);
  const std::byte* info = &file[429];
  EXPECT_EQ(load<double>(info + 32), 2 * load<double>(info + 24) / 128);
  EXPECT_EQ(load<double>(info + 56), 901);
  EXPECT_EQ(load<double>(info + 64), 1000);
  const auto page = static_cast<std::size_t>(load<std::uint64_t>(info + 40));
  EXPECT_EQ(page + load<std::uint64_t>(info + 48), file.size());
  EXPECT_EQ(load<std::int32_t>(&file[page]), 0) << "the root is the first entry";
  EXPECT_EQ(load<std::uint16_t>(&file[6]) & 16, 16) << "WKT bit";
}

TEST(CopcWriter, SameBytesForAnyNumberOfThreads) {
  const Folder folder;
  const CloudSpec spec = copc_spec_of(8, 2);
  const auto rows = surface(150000, spec.like.layout, 9);
  for (const int threads : {1, 3})
    with_threads(threads, [&] { write_copc(folder / (std::to_string(threads) + ".copc.laz"), spec, rows); });
  EXPECT_TRUE(slurp(folder / "1.copc.laz") == slurp(folder / "3.copc.laz"));
}

TEST(CopcWriter, NoPointsAndCoincidentPoints) {
  const Folder folder;
  const CloudSpec spec = copc_spec_of(6, 0);
  write_copc(folder / "none.copc.laz", spec, {});
  const auto none = open_cloud(folder / "none.copc.laz");
  EXPECT_EQ(none->info().points, 0u);
  EXPECT_EQ(copc_vlr(none->info(), 1000).payload.size(), 32u);
  const std::vector<std::byte> same(70000 * std::size_t{30});
  write_copc(folder / "same.copc.laz", spec, same);
  const auto reader = open_cloud(folder / "same.copc.laz");
  EXPECT_EQ(reader->info().points, 70000u);
  check_nodes(*reader);
  EXPECT_TRUE(read_all(*reader, 65536).bytes == same);
}

TEST(CopcWriter, WhatDoesNotFitTheMemoryIsRefusedAndNothingStays) {
  const Folder folder;
  CloudSpec spec = copc_spec_of(6, 0);
  spec.octree_bytes = std::uint64_t{46} * 1000;
  {
    const auto writer = create_copc(folder / "t.copc.laz", spec);
    writer->write(std::vector<std::byte>(30 * 1000));
    EXPECT_THROW(writer->write(std::vector<std::byte>(30)), Error);
  }
  spec.like.points = 1001;
  EXPECT_THROW(create_copc(folder / "t.copc.laz", spec), Error);
  EXPECT_EQ(folder.files(), 0u);
}

TEST(CopcWriter, NamesSayWhatIsWritten) {
  EXPECT_TRUE(is_copc_name("a/b.Copc.LAZ"));
  for (const char* name : {"a.laz", "copc.laz", ".copc.laz", "a.copc.laz.las", "acopc.laz"})
    EXPECT_FALSE(is_copc_name(name));
  EXPECT_EQ(cloud_stem("x/a.b.laz"), "a.b");
  for (const char* name : {"x/a.copc.laz", "a.copc.las", "a.COPC.copc.laz", "a.las"}) EXPECT_EQ(cloud_stem(name), "a");
}

TEST(CopcWriter, RealFilesKeepTheirCrsAndAttributes) {
  ILOT_DATA_OR_SKIP(data);
  const Folder folder;
  for (const char* name : {"ign/77050_627755_pf3.laz", "ign/77050_627755_pf8.laz", "ign/77050_627755.copc.laz",
                           "ign/decimated_0382_6565.laz"}) {
    SCOPED_TRACE(name);
    const auto from = open_cloud(data / name);
    const CloudInfo& info = from->info();
    const Rows rows = read_all(*from, 65536);
    write_copc(folder / "t.copc.laz", {info, {}, "test"}, rows.bytes);
    const auto to = open_cloud(folder / "t.copc.laz");
    EXPECT_TRUE(to->info().warnings.empty());
    EXPECT_EQ(to->info().crs.epsg, info.crs.epsg);
    EXPECT_EQ(to->info().layout.extra.size(), info.layout.extra.size());
    const std::size_t standard = standard_size(info.layout.point_format), length = to->info().layout.record_length;
    std::vector<std::byte> expected(rows.valid.size() * length);
    modernise(rows.bytes, info.layout.point_format, info.layout.record_length - standard, expected);
    const Rows back = read_all(*to, 65536);
    EXPECT_TRUE(sorted_rows(back.bytes, length) == sorted_rows(expected, length));
    check_nodes(*to);
    const Vec3 p = world(back, to->info().layout, back.valid.size() / 2);
    check_box(*to, back, {p.x - 5, p.y - 5, p.x + 5, p.y + 5, {}});
  }
}

// "nodes points outside declared wkt" as tests/oracles/copc_nodes.mjs finds them; empty when it cannot read the file.
std::string found_by_npm(const std::filesystem::path& path) {
  const std::string command = "node '" ILOT_SOURCE_DIR "/tests/oracles/copc_nodes.mjs' '" + path.string() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return {};
  char line[200]{};
  const bool got = std::fgets(line, sizeof line, pipe) != nullptr;
  return pclose(pipe) == 0 && got ? line : "";
}

TEST(CopcWriter, AnotherImplementationFindsAllNodesAndPoints) {
  const char* npm = std::getenv("ILOT_NPM");
  if (!npm || !std::filesystem::exists(std::filesystem::path(npm) / "node_modules/copc"))
    GTEST_SKIP() << "no copc below ILOT_NPM: nothing was compared";
  const Folder folder;
  for (const std::uint8_t format : {1, 6, 7, 8}) {
    CloudSpec spec = copc_spec_of(format, 0);
    spec.like.crs.wkt = "PROJCS[\"anything\"]";
    write_copc(folder / "t.copc.laz", spec, surface(100000, spec.like.layout, format));
    const std::size_t nodes = open_cloud(folder / "t.copc.laz")->boundaries().size() - 1;
    EXPECT_EQ(found_by_npm(folder / "t.copc.laz"), std::to_string(nodes) + " 100000 0 100000 true\n") << int(format);
  }
}

}  // namespace
}  // namespace ilot
