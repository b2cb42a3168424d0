// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/ptx.h"

#include <cmath>
#include <cstdio>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

struct OpenedPtx {
  std::unique_ptr<PointReader> reader;
  Rows rows;
  Vec3 point(std::size_t row) const { return world(rows, reader->info().layout, row); }
  PointFields fields(std::size_t row) const {
    const RecordLayout& layout = reader->info().layout;
    return decode_fields(std::span(rows.bytes).subspan(row * layout.record_length, layout.record_length),
                         layout.point_format);
  }
};

OpenedPtx open_file(const std::filesystem::path& path, std::size_t step = 2) {
  OpenedPtx opened{open_cloud(path), {}};
  opened.rows = read_all(*opened.reader, step);
  return opened;
}

OpenedPtx open_ptx_of(const Folder& folder, const std::string& text, const char* name = "t.ptx") {
  spill_text(folder / name, text);
  return open_file(folder / name);
}

constexpr const char* kTurned = "10 20 30\n0 1 0\n-1 0 0\n0 0 1\n0 1 0 0\n-1 0 0 0\n0 0 1 0\n10 20 30 1\n";
constexpr const char* kPlain = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";

TEST(Ptx, MatrixMovesRowVectorsAndEmptyCellsAreRejected) {
  const Folder folder;
  const OpenedPtx o =
      open_ptx_of(folder, std::string("3\n1\n") + kTurned + "0 0 0 0.5 0 0 0\n1 0 0 1 255 0 128\n0 2 5 0.25 1 2 3\n");
  EXPECT_EQ(o.reader->info().format, "ptx");
  EXPECT_EQ(o.rows.valid, (std::vector<std::uint8_t>{0, 1, 1}));
  EXPECT_NEAR(o.point(1).x, 10, 1e-9);
  EXPECT_NEAR(o.point(1).y, 21, 1e-9);
  EXPECT_NEAR(o.point(2).x, 8, 1e-9);
  EXPECT_NEAR(o.point(2).z, 35, 1e-9);
  EXPECT_EQ(o.fields(1).intensity, 65535);
  EXPECT_EQ(o.fields(2).intensity, 16384);
  ASSERT_EQ(o.reader->info().layout.point_format, 7);
  const std::byte* rgb = &o.rows.bytes[o.reader->info().layout.record_length + *rgb_offset(7)];
  EXPECT_EQ(load<std::uint16_t>(rgb), 65535);
  EXPECT_EQ(load<std::uint16_t>(rgb + 4), 128 * 257);
  ASSERT_EQ(o.reader->info().stations.size(), 1u);
  EXPECT_EQ(o.reader->info().stations[0].position.z, 30);
  EXPECT_TRUE(o.reader->info().warnings.empty());
}

TEST(Ptx, DecimalCommasAreRead) {
  const Folder folder;
  std::string points = "3\n1\n" + std::string(kTurned) + "0 0 0 0.5 0 0 0\n1.25 0 0 1 255 0 128\n0 2 5 0.25 1 2 3\n";
  std::string commas = points;
  std::replace(commas.begin(), commas.end(), '.', ',');
  const OpenedPtx a = open_ptx_of(folder, points), b = open_ptx_of(folder, commas, "b.ptx");
  EXPECT_EQ(a.rows.bytes, b.rows.bytes);
  EXPECT_EQ(b.reader->info().dialect, "separated by blanks, decimal comma");
  EXPECT_EQ(a.reader->info().dialect, "separated by blanks, decimal point");
}

TEST(Ptx, ScansOfDifferentContentFollowEachOther) {
  const Folder folder;
  const OpenedPtx o = open_ptx_of(folder, std::string("1\r\n2\r\n") + kPlain + "1 1 1 0.5\n2 2 2 0.5\n\n" + "1\n1\n" +
                                              kTurned + "1 0 0 0.5 9 9 9\n");
  ASSERT_EQ(o.rows.valid, (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(o.reader->info().scans.size(), 2u);
  EXPECT_EQ(o.reader->info().layout.point_format, 7);
  EXPECT_EQ(o.fields(1).source_id, 1);
  EXPECT_EQ(o.fields(2).source_id, 2);
  EXPECT_NEAR(o.point(2).y, 21, 1e-9);
  EXPECT_EQ(read_all(*o.reader, 1).bytes, o.rows.bytes) << "a second reading gives the same";
}

// A wall at x = 10 m, scanned in steps of 2 and 1 mrad by a scanner that lies on its side.
TEST(Ptx, TheGridGivesTheAngularSteps) {
  const Folder folder;
  std::string text = "40\n60\n5 6 7\n1 0 0\n0 0 -1\n0 1 0\n1 0 0 0\n0 0 -1 0\n0 1 0 0\n5 6 7 1\n";
  for (int column = 0; column < 40; ++column)
    for (int row = 0; row < 60; ++row) {
      const double a = 0.002 * column - 0.03, e = 0.001 * row - 0.02;
      char line[100];
      std::snprintf(line, sizeof line, "10 %.4f %.4f 0.5\n", 10 * std::tan(a), 10 / std::cos(a) * std::tan(e));
      text += (column * 7 + row) % 9 == 0 ? "0 0 0 0.5\n" : line;
    }
  const OpenedPtx o = open_ptx_of(folder, text);
  ASSERT_EQ(o.reader->info().stations.size(), 1u);
  const Station& s = o.reader->info().stations[0];
  EXPECT_NEAR(s.azimuth_step, 0.002, 2e-5);
  EXPECT_NEAR(s.elevation_step, 0.001, 1e-5);
  EXPECT_EQ(s.position.y, 6);
  EXPECT_EQ(s.axis.y, 1);
  EXPECT_EQ(s.axis.z, 0);
}

TEST(Ptx, TooFewPointsGiveNoSteps) {
  const Folder folder;
  const OpenedPtx o =
      open_ptx_of(folder, std::string("2\n2\n") + kPlain + "5 0 0 1\n5 0 0.1 1\n5 0.1 0 1\n5 0.1 0.1 1\n");
  EXPECT_EQ(o.reader->info().stations.at(0).azimuth_step, 0);
}

TEST(Ptx, MalformedLinesAreRejectedAndCutFilesKeepWhatIsThere) {
  const Folder folder;
  OpenedPtx o = open_ptx_of(folder, std::string("4\n1\n") + kPlain + "1 1 1 0.5\n1 1\nnan 1 1 0.5\n1 1 1 x\n");
  EXPECT_EQ(o.rows.valid, (std::vector<std::uint8_t>{1, 0, 0, 0}));
  ASSERT_EQ(o.reader->info().warnings.size(), 1u);
  EXPECT_NE(o.reader->info().warnings[0].find("2 lines"), std::string::npos);
  EXPECT_NE(o.reader->info().warnings[0].find("line 12"), std::string::npos);
  o = open_ptx_of(folder, std::string("1000\n1000\n") + kPlain + "1 1 1 0.5\n");
  EXPECT_EQ(o.reader->info().declared_points, 1000000u);
  EXPECT_EQ(o.reader->info().points, 1u);
  o = open_ptx_of(folder, std::string("1\n1\n") + kPlain + "1 1 1 0.5\n1\n1\n0 0 0\nrubbish\n");
  EXPECT_EQ(o.reader->info().points, 1u);
  EXPECT_EQ(o.reader->info().warnings.size(), 1u);
}

TEST(Ptx, RefusesWhatIsNoPtx) {
  const Folder folder;
  for (const std::string& text : {std::string("1 2 3\n4 5 6\n"), std::string("\n\n"), std::string("-1\n2\n") + kPlain,
                                  std::string("1\n1.5\n") + kPlain, std::string("1e9\n1e9\n") + kPlain}) {
    spill_text(folder / "t.ptx", text);
    EXPECT_THROW(open_cloud(folder / "t.ptx"), Error) << text;
  }
}

TEST(Ptx, MutationsNeverCrash) {
  const Folder folder;
  const std::string sound =
      std::string("2\n2\n") + kTurned + "1 2 3 0.5\n0 0 0 0\n4 5 6 1\n7 8 9 0\n1\n1\n" + kPlain + "1 2 3 0.5 6 7 8\n";
  const std::string alphabet = "0123456789.-+ \n\texna\"";
  Rng rng(3);
  for (int round = 0; round < 1000; ++round) {
    std::string text = sound;
    for (std::uint32_t c = 0; c <= rng.below(4); ++c)
      text[rng.below(static_cast<std::uint32_t>(text.size()))] =
          alphabet[rng.below(static_cast<std::uint32_t>(alphabet.size()))];
    if (rng.below(4) == 0) text.resize(1 + rng.below(static_cast<std::uint32_t>(text.size() - 1)));
    try {
      const OpenedPtx o = open_ptx_of(folder, text);
      ASSERT_EQ(o.rows.valid.size(), o.reader->info().points) << text;
    } catch (const Error&) {
    }
  }
}

TEST(Pts, LaterCountsBeginOtherBlocks) {
  const Folder folder;
  OpenedPtx o = open_ptx_of(folder, "2\n1 2 3 -2048\n4 5 6 0\n1\n7 8 9 2047\n", "t.pts");
  EXPECT_EQ(o.rows.valid, (std::vector<std::uint8_t>{1, 1, 1}));
  EXPECT_EQ(o.reader->info().declared_points, 3u);
  EXPECT_NEAR(o.point(2).x, 7, 1e-9);
  EXPECT_TRUE(o.reader->info().warnings.empty());
  EXPECT_EQ(read_all(*o.reader, 3).bytes, o.rows.bytes);
  o = open_ptx_of(folder, "2\n1 2 3\n4 5 6\n5\n7 8 9\n", "t.pts");
  EXPECT_EQ(o.reader->info().declared_points, 7u);
  EXPECT_EQ(o.reader->info().points, 3u);
  EXPECT_EQ(o.reader->info().warnings.size(), 1u);
}

TEST(Ptx, RealFiles) {
  ILOT_DATA_OR_SKIP(data);
  const std::filesystem::path folder = data / "conformance/pdal/ptx";
  OpenedPtx o = open_file(folder / "1.2-with-color.ptx", 100);
  EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 1), 1065);
  EXPECT_NEAR(o.point(0).x, 637012.24, 1e-6);
  o = open_file(folder / "multiple-and-transform.ptx");
  ASSERT_EQ(o.rows.valid.size(), 8u);
  ASSERT_EQ(o.reader->info().stations.size(), 2u);
  EXPECT_EQ(o.reader->info().stations[0].source_id, 1);
  EXPECT_EQ(o.reader->info().stations[1].source_id, 2);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_LT(norm(o.point(i) - o.point(i + 4)), 1e-6) << "both scans say the same";
  EXPECT_NEAR(o.point(4).z, 431.66, 1e-6);
  o = open_file(folder / "complex-transform.ptx");
  EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 1), 4);
  EXPECT_EQ(open_file(folder / "no-color.ptx").rows.valid.size(), 15u);
}

TEST(Pts, RealFiles) {
  ILOT_DATA_OR_SKIP(data);
  const std::pair<const char*, std::size_t> known[] = {
      {"autzen.pts", 10}, {"bunny_8.pts", 9}, {"site_56_8.pts", 8}, {"test.pts", 19}};
  for (const auto& [name, points] : known) {
    const OpenedPtx o = open_file(data / "conformance/pdal/pts" / name, 100);
    EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 1), static_cast<std::ptrdiff_t>(points)) << name;
    EXPECT_TRUE(o.reader->info().warnings.empty()) << name;
  }
}

}  // namespace
}  // namespace ilot
