// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/text.h"

#include "engine/formats/tables/lines.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

struct OpenedText {
  std::unique_ptr<PointReader> reader;
  Rows rows;
  PointFields fields(std::size_t row) const {
    const RecordLayout& layout = reader->info().layout;
    return decode_fields(std::span(rows.bytes).subspan(row * layout.record_length, layout.record_length),
                         layout.point_format);
  }
  std::array<int, 3> colour(std::size_t row) const {
    const RecordLayout& layout = reader->info().layout;
    const std::byte* p = &rows.bytes[row * layout.record_length + *rgb_offset(layout.point_format)];
    return {load<std::uint16_t>(p), load<std::uint16_t>(p + 2), load<std::uint16_t>(p + 4)};
  }
  Vec3 point(std::size_t row) const { return world(rows, reader->info().layout, row); }
};

OpenedText open_text_of(const Folder& folder, const std::string& name, const std::string& text, std::size_t step = 2) {
  spill_text(folder / name, text);
  OpenedText opened{open_cloud(folder / name), {}};
  opened.rows = read_all(*opened.reader, step);
  return opened;
}

TEST(Text, NationalCoordinatesKeepTheirDigits) {
  const Folder folder;
  const OpenedText o =
      open_text_of(folder, "a.xyz", "701362.56 4485513.72 836.41983944702\n836419.83944702 4485513.72 1\n");
  EXPECT_EQ(o.reader->info().points, 2u);
  EXPECT_NEAR(o.point(0).x, 701362.56, 1e-9);
  EXPECT_NEAR(o.point(0).y, 4485513.72, 1e-9);
  EXPECT_NEAR(o.point(0).z, 836.4198, 1e-9);
  EXPECT_NEAR(o.point(1).x, 836419.8394, 1e-9);
  EXPECT_NE(o.reader->info().dialect.find("11 decimals of which 4 are kept"), std::string::npos);
}

TEST(Text, TheScaleFollowsTheDigits) {
  const Folder folder;
  const OpenedText few = open_text_of(folder, "a.xyz", "701362.5 4485513.7 836.4\n701363 4485514 837\n");
  EXPECT_EQ(few.reader->info().layout.scale[0], 1e-4);
  const OpenedText many = open_text_of(folder, "b.xyz", "12.123456 4.5 836.41983944702\n12.2 4.6 836\n");
  EXPECT_EQ(many.reader->info().layout.scale[2], 1e-6);
  EXPECT_NEAR(many.point(0).x, 12.123456, 1e-9);
  EXPECT_NE(many.reader->info().dialect.find("11 decimals of which 6 are kept"), std::string::npos);
  const OpenedText zeros = open_text_of(folder, "c.xyz", "12.12000000 4.50000000 8.00000000\n1 2 3\n");
  EXPECT_EQ(zeros.reader->info().layout.scale[0], 1e-4) << "trailing zeros are no digits";
}

// Scanners write 0 0 0 for rays without an echo; national coordinates are far from there.
TEST(Text, StraysDoNotCoarsenTheScale) {
  const Folder folder;
  std::string cloud;
  for (int i = 0; i < 2000; ++i) cloud += "651000." + std::to_string(1000 + i) + " 6861000.25 50.003\n";
  const OpenedText clean = open_text_of(folder, "a.xyz", cloud, 500);
  for (const std::size_t zeros : {1u, 3000u}) {
    std::string text;
    for (std::size_t i = 0; i < zeros; ++i) text += "0 0 0\n";
    const OpenedText o = open_text_of(folder, "b.xyz", text + cloud, 500);
    EXPECT_EQ(o.reader->info().layout.scale, clean.reader->info().layout.scale);
    EXPECT_EQ(o.reader->info().layout.offset, clean.reader->info().layout.offset);
    EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 0), static_cast<std::ptrdiff_t>(zeros));
    EXPECT_NEAR(o.point(zeros).z, 50.003, 1e-9);
    ASSERT_EQ(o.reader->info().warnings.size(), 1u);
    EXPECT_TRUE(o.reader->info().warnings[0].starts_with(std::to_string(zeros) +
                                                         (zeros == 1 ? " row is 0 0 0" : " rows are 0 0 0")));
  }
  const OpenedText far = open_text_of(folder, "c.xyz", "1e9 5 7\n" + cloud, 500);
  EXPECT_EQ(far.reader->info().layout.scale[0], 1e-4);
  EXPECT_EQ(far.rows.valid[0], 0);
  EXPECT_EQ(far.rows.valid[1], 1);
}

TEST(Text, TwoSitesFarApartAreBothReadAndTheCoarserScaleIsSaid) {
  const Folder folder;
  std::string text;
  for (int i = 0; i < 50; ++i) text += "100000.1234 200000 " + std::to_string(i) + "\n";
  for (int i = 0; i < 50; ++i) text += "900000.1234 200000 " + std::to_string(i) + "\n";
  const OpenedText o = open_text_of(folder, "a.xyz", text, 10);
  EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 1), 100);
  EXPECT_EQ(o.reader->info().layout.scale[0], 1e-3);
  ASSERT_EQ(o.reader->info().warnings.size(), 1u);
  EXPECT_NE(o.reader->info().warnings[0].find("only 3 decimals"), std::string::npos);
  std::string near = text.substr(0, text.size() / 2);
  for (int i = 0; i < 50; ++i) near += "150000.1234 200000 " + std::to_string(i) + "\n";
  EXPECT_TRUE(open_text_of(folder, "b.xyz", near, 10).reader->info().warnings.empty()) << "50 km fit";
}

TEST(Text, SeparatorsHeadersAndLineEndsDoNotMatter) {
  const Folder folder;
  const char* texts[] = {"1 2 3\n4 5 6\n",
                         "1\t2\t3\r\n4\t5\t6\r\n",
                         "1,2,3\n4,5,6",
                         "X;Y;Z\n1;2;3\n4; 5 ;6\n",
                         "\"x\",\"y\",\"z\"\n1 2 3\n\n4 5 6\n\n",
                         "\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n",
                         "# made by hand\n//X Y Z\n2\n1 2 3\n4 5 6\n",
                         "Easting,Northing,Elevation\n+1,2e0,3.0\n4,5,6\n"};
  for (const char* text : texts) {
    const OpenedText o = open_text_of(folder, "t.txt", text);
    ASSERT_EQ(o.rows.valid, (std::vector<std::uint8_t>{1, 1})) << text;
    EXPECT_EQ(o.point(0).y, 2) << text;
    EXPECT_NEAR(o.point(1).z, 6, 1e-12) << text;
    EXPECT_EQ(o.reader->info().layout.point_format, 6);
  }
}

TEST(Text, ColumnsFindTheirFields) {
  const Folder folder;
  const OpenedText o = open_text_of(folder, "t.csv",
                                    "R,G,B,Z,Y,X,Intensity,Classification,ReturnNumber,GpsTime,Deviation\n"
                                    "255,128,0,3,2,1,700,6,2,123456789.25,0.5\n");
  const RecordLayout& layout = o.reader->info().layout;
  EXPECT_EQ(layout.point_format, 7);
  EXPECT_EQ(o.point(0).x, 1);
  EXPECT_EQ(o.point(0).z, 3);
  EXPECT_EQ(o.colour(0), (std::array<int, 3>{65535, 128 * 257, 0}));
  EXPECT_EQ(o.fields(0).intensity, 700);
  EXPECT_EQ(o.fields(0).classification, 6);
  EXPECT_EQ(o.fields(0).return_number, 2);
  EXPECT_EQ(load<double>(&o.rows.bytes[22]), 123456789.25);
  ASSERT_EQ(layout.extra.size(), 1u);
  EXPECT_EQ(layout.extra[0].name, "Deviation");
  EXPECT_EQ(load<double>(&o.rows.bytes[layout.extra[0].offset]), 0.5);
}

TEST(Text, ScalesOfColourAndIntensityFollowTheValues) {
  const Folder folder;
  OpenedText o = open_text_of(folder, "a.txt", "1 2 3 0.5 0 0 255\n1 2 3 1 300 0 0\n");
  EXPECT_EQ(o.fields(0).intensity, 32768);
  EXPECT_EQ(o.colour(0)[2], 255) << "one value above 255: the colours have 16 bits";
  o = open_text_of(folder, "a.pts", "2\n1 2 3 -2048 1 2 3\n1 2 3 2047 255 0 0\n");
  EXPECT_EQ(o.reader->info().declared_points, 2u);
  EXPECT_EQ(o.fields(0).intensity, 0);
  EXPECT_EQ(o.fields(1).intensity, 65520);
  EXPECT_EQ(o.colour(1)[0], 65535);
  o = open_text_of(folder, "a.txt", "1 2 3 0.6 0.8 0\n");
  EXPECT_EQ(o.reader->info().layout.extra[1].name, "ny");
}

TEST(Text, MalformedAndImpossibleRowsAreRejectedAndTheFirstIsNamed) {
  const Folder folder;
  const OpenedText o =
      open_text_of(folder, "t.xyz", "x y z\n1 2 3\n1 2\n\nnan 2 3\n1 2 inf\n1 2 1e300\n1,,2\n1 2 3x\n7 8 9\n");
  EXPECT_EQ(o.rows.valid, (std::vector<std::uint8_t>{1, 0, 0, 0, 0, 0, 0, 1}));
  ASSERT_EQ(o.reader->info().warnings.size(), 1u);
  EXPECT_EQ(o.reader->info().warnings[0],
            "3 lines are not 3 numbers (separated by blanks, decimal point) and are rejected, the first is line 3");
  EXPECT_EQ(read_all(*o.reader, 3).bytes, o.rows.bytes) << "a second pass gives the same";
  EXPECT_EQ(o.reader->info().warnings.size(), 1u);
}

TEST(Text, RowsOfAnotherDialectAreRejectedWithTheirLine) {
  const Folder folder;
  std::string text = "x;y;z\n";
  for (int i = 0; i < 1500; ++i) text += "651000,5;6861000,25;" + std::to_string(i) + ",125\n";
  text += "651000.5;6861000.25;7.125\n651000,5;6861000,25\n651000,5;6861000,25;9,5;1\n";
  const OpenedText o = open_text_of(folder, "t.csv", text, 400);
  EXPECT_EQ(std::count(o.rows.valid.begin(), o.rows.valid.end(), 0), 3);
  EXPECT_NEAR(o.point(1499).z, 1499.125, 1e-9);
  EXPECT_EQ(o.reader->info().dialect, "separated by semicolons, decimal comma, header line");
  ASSERT_EQ(o.reader->info().warnings.size(), 1u);
  EXPECT_NE(o.reader->info().warnings[0].find("the first is line 1502"), std::string::npos);
}

TEST(Text, HeadersAndRowsAgreeOnTheirColumns) {
  const Folder folder;
  const OpenedText more = open_text_of(folder, "t.csv", "x,y,z\n1.5,2,3,4\n1,2,3,5\n");
  EXPECT_EQ(more.reader->info().layout.extra[0].name, "column4");
  spill_text(folder / "t.csv", "x y z intensity\n1.5 2 3\n");
  EXPECT_THROW(open_cloud(folder / "t.csv"), Error);
}

TEST(Text, RefusesWhatIsNoCloud) {
  const Folder folder;
  for (const char* text : {"", "hello world\n", "1 2\n", "x,y\n1,2\n", "{\"type\": \"FeatureCollection\"}", "\n\n\n"}) {
    spill_text(folder / "t.txt", text);
    EXPECT_THROW(open_cloud(folder / "t.txt"), Error) << text;
  }
  spill_text(folder / "t.unknown", "1 2 3\n");
  EXPECT_THROW(open_cloud(folder / "t.unknown"), Error);
}

TEST(Text, CsvReadsBackAsItWasWritten) {
  const Folder folder;
  CloudSpec spec;
  spec.like.layout.point_format = 8;
  spec.like.layout.record_length = 38;
  spec.like.layout.scale = {0.001, 0.001, 0.001};
  spec.like.layout.offset = {701000, 4485000, 0};
  ExtraField id{"plane id", "", FieldType::u64, 0, 8, 1, 0};
  spec.appended = {id};
  std::vector<std::byte> row(46);
  PointFields f;
  f.x = 362560;
  f.y = 513720;
  f.z = -1;
  f.intensity = 77;
  f.return_number = 2;
  f.return_count = 3;
  f.classification = 67;
  f.overlap = f.edge_of_flight_line = true;
  f.scan_angle_deg = 12.006;
  encode_fields(f, row, 8);
  store(&row[22], 0.1);
  for (std::size_t i = 0; i < 4; ++i) store(&row[30 + 2 * i], static_cast<std::uint16_t>(1000 * i + 300));
  store(&row[38], std::uint64_t{18446744073709551615ull});
  const auto writer = create_cloud(folder / "t.csv", spec);
  writer->write(row);
  writer->finish();
  const std::vector<std::byte> bytes = slurp(folder / "t.csv");
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  EXPECT_NE(text.find("\n701362.56,4485513.72,-0.001,77,2,3,67,"), std::string::npos) << text;
  EXPECT_NE(text.find(",18446744073709551615\n"), std::string::npos) << text;
  OpenedText o{open_cloud(folder / "t.csv"), {}};
  o.rows = read_all(*o.reader);
  EXPECT_EQ(o.reader->info().layout.point_format, 8);
  EXPECT_EQ(std::vector(&o.rows.bytes[12], &o.rows.bytes[38]), std::vector(&row[12], &row[38]));
  EXPECT_NEAR(o.point(0).x, 701362.56, 1e-9);
  EXPECT_EQ(o.reader->info().layout.extra[0].name, "plane_id");
}

TEST(Lines, LongLinesAreCutAndCountedOnce) {
  const Folder folder;
  spill_text(folder / "l", "a\n" + std::string(5000000, 'x') + "\nb\n\nc");
  const InputFile file(folder / "l");
  LineReader lines(file, 0);
  std::string_view line;
  std::vector<std::string> seen;
  while (lines.next(line)) seen.emplace_back(line.substr(0, 70000));
  ASSERT_EQ(seen.size(), 5u);
  EXPECT_EQ(seen[1], std::string(65536, 'x'));
  EXPECT_EQ(seen[2], "b");
  EXPECT_EQ(seen[4], "c");
}

}  // namespace
}  // namespace ilot
