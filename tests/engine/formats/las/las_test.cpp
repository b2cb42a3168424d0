// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/las.h"

#include <algorithm>
#include <functional>
#include <thread>

#include "engine/formats/las/extra_bytes.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

ExtraField field(const std::string& name, FieldType type) {
  ExtraField f;
  f.name = name;
  f.type = type;
  f.size = static_cast<std::uint16_t>(type_size(type));
  return f;
}

Vlr record(const std::string& user, std::uint16_t id, std::size_t size, bool extended) {
  Vlr vlr;
  vlr.user_id = user;
  vlr.record_id = id;
  vlr.description = "kept as it is";
  vlr.payload = random_bytes(size, id);
  vlr.extended = extended;
  vlr.reserved = 0xAABB;
  return vlr;
}

// An input of the given format with two extra fields, made without a header of its own.
CloudSpec fresh_spec(std::uint8_t format) {
  CloudSpec spec;
  spec.like.layout.point_format = format;
  spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format));
  spec.like.layout.scale = {0.001, 0.01, 0.0001};
  spec.like.layout.offset = {700000, 4485000, 0};
  spec.like.vlrs = {record("ours", 7, 100, false)};
  spec.appended = {field("height", FieldType::f32), field("room", FieldType::u16)};
  spec.software = "test";
  return spec;
}

void write_rows(const std::filesystem::path& path, const CloudSpec& spec, const std::vector<std::byte>& rows) {
  const auto writer = create_cloud(path, spec);
  writer->write(rows);
  writer->finish();
}

class LasRoundTrip : public testing::TestWithParam<int> {};

TEST_P(LasRoundTrip, KeepsRowsRecordsAndExtraBytes) {
  const Folder folder;
  CloudSpec spec = fresh_spec(static_cast<std::uint8_t>(GetParam()));
  spec.like.vlrs.push_back(record("far", 9, 70000, true));
  const std::size_t length = spec.like.layout.record_length + 6u;
  const std::vector<std::byte> rows = random_bytes(length * 1234, 5);
  write_rows(folder / "a b.las", spec, rows);
  EXPECT_EQ(folder.files(), 1u);

  const auto reader = open_cloud(folder / "a b.las");
  const CloudInfo& info = reader->info();
  EXPECT_TRUE(info.warnings.empty());
  EXPECT_EQ(info.points, 1234u);
  EXPECT_EQ(info.layout.point_format, GetParam());
  EXPECT_EQ(info.layout.scale, spec.like.layout.scale);
  ASSERT_EQ(info.layout.extra.size(), 2u);
  EXPECT_EQ(info.layout.extra[1].name, "room");
  EXPECT_EQ(info.layout.extra[1].offset, length - 2);
  EXPECT_EQ(read_all(*reader).bytes, rows);
  EXPECT_EQ(info.vlrs.front().payload, spec.like.vlrs.front().payload);
  EXPECT_EQ(info.vlrs.front().reserved, 0xAABB);
  EXPECT_TRUE(info.vlrs.back().extended);
  EXPECT_EQ(info.vlrs.back().payload, random_bytes(70000, 9));

  CloudSpec copy{info, {}, ""};
  write_rows(folder / "copy.las", copy, rows);
  EXPECT_EQ(slurp(folder / "copy.las"), slurp(folder / "a b.las"));
}

INSTANTIATE_TEST_SUITE_P(AllPointFormats, LasRoundTrip, testing::Range(0, 11));

TEST(Las, AppendsBehindDescribedUndocumentedAndMalformedExtraBytes) {
  const Folder folder;
  CloudSpec spec = fresh_spec(3);
  write_rows(folder / "first.las", spec, random_bytes(40 * 10, 1));
  for (const std::size_t payload : {192u, 384u, 100u, 768u}) {
    CloudInfo info = open_cloud(folder / "first.las")->info();
    auto vlr = std::find_if(info.vlrs.begin(), info.vlrs.end(), is_extra_bytes);
    vlr->payload.resize(payload, std::byte{1});
    info.layout.extra.resize(payload == 192 ? 1 : payload == 384 ? 2 : 0);
    const std::vector<std::byte> rows = random_bytes(44 * 10, 2);
    write_rows(folder / "second.las", {info, {field("plane_id", FieldType::u32)}, ""}, rows);
    const auto reader = open_cloud(folder / "second.las");
    EXPECT_TRUE(reader->info().warnings.empty());
    EXPECT_EQ(reader->info().layout.extra.back().name, "plane_id");
    EXPECT_EQ(reader->info().layout.extra.back().offset, 40);
    EXPECT_EQ(read_all(*reader).bytes, rows);
  }
}

TEST(Las, ManyFieldsSpreadOverSeveralRecordsOrOneExtended) {
  const Folder folder;
  for (const std::uint8_t format : {std::uint8_t{1}, std::uint8_t{6}}) {
    CloudSpec spec = fresh_spec(format);
    spec.appended.assign(700, field("f", FieldType::u8));
    const std::vector<std::byte> rows = random_bytes((standard_size(format) + 700) * 3, 2);
    write_rows(folder / "many.las", spec, rows);
    const auto reader = open_cloud(folder / "many.las");
    EXPECT_EQ(reader->info().layout.extra.size(), 700u);
    EXPECT_EQ(read_all(*reader).bytes, rows);
  }
}

TEST(Las, KeepsTheVersionAndHeaderOfItsInput) {
  const Folder folder;
  CloudSpec spec = fresh_spec(1);
  const std::vector<std::byte> rows = random_bytes(34 * 20, 3);
  write_rows(folder / "new.las", spec, rows);
  for (const std::uint8_t minor : {0, 1, 2, 3}) {
    CloudInfo info = open_cloud(folder / "new.las")->info();
    info.header = random_bytes(las::header_size(minor) + 5u, minor);
    info.version_minor = minor;
    write_rows(folder / "old.las", {info, {}, "ilot"}, rows);
    const CloudInfo back = open_cloud(folder / "old.las")->info();
    EXPECT_EQ(back.version_minor, minor);
    EXPECT_EQ(back.points, 20u);
    ASSERT_EQ(back.header.size(), info.header.size());
    EXPECT_TRUE(std::equal(&back.header[4], &back.header[24], &info.header[4])) << "source id, encoding, GUID";
    EXPECT_TRUE(std::equal(back.header.end() - 5, back.header.end(), info.header.end() - 5)) << "user bytes";
    EXPECT_EQ(load<std::uint32_t>(&back.header[90]), load<std::uint32_t>(&info.header[90])) << "date";
  }
}

TEST(Las, CountsReturnsAndMeasuresBounds) {
  const Folder folder;
  CloudSpec spec = fresh_spec(6);
  spec.appended.clear();
  std::vector<std::byte> rows(30 * 3);
  for (std::size_t i = 0; i < 3; ++i) {
    PointFields f;
    f.x = static_cast<std::int32_t>(i) * 1000 - 1000;
    f.y = 5;
    f.z = -7;
    f.return_number = static_cast<std::uint8_t>(i + 9);
    encode_fields(f, std::span(rows).subspan(30 * i, 30), 6);
  }
  write_rows(folder / "x.las", spec, rows);
  const CloudInfo info = open_cloud(folder / "x.las")->info();
  EXPECT_EQ(info.declared_min.x, -1000 * 0.001 + 700000);
  EXPECT_EQ(info.declared_max.x, 1000 * 0.001 + 700000);
  EXPECT_EQ(info.declared_min.z, -7 * 0.0001);
  EXPECT_EQ(load<std::uint32_t>(&info.header[las::kLegacyCount]), 0u);
  for (std::size_t i = 8; i < 11; ++i) EXPECT_EQ(load<std::uint64_t>(&info.header[las::kReturns + 8 * i]), 1u);
}

TEST(Las, SeveralThreadsFillOneFile) {
  const Folder folder;
  const CloudSpec spec = fresh_spec(7);
  const std::size_t length = 42, part = 501;
  const std::vector<std::byte> rows = random_bytes(length * part * 4, 8);
  write_rows(folder / "serial.las", spec, rows);

  LasFileWriter writer(folder / "parallel.las", spec);
  std::vector<PointStatistics> statistics(4);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 4; ++t)
    threads.emplace_back([&, t] {
      const auto mine = std::span(rows).subspan(t * part * length, part * length);
      writer.write_at(t * part, mine);
      statistics[t].add(mine, writer.layout());
    });
  for (std::thread& thread : threads) thread.join();
  PointStatistics total;
  for (std::size_t t = 4; t-- > 0;) total.merge(statistics[t]);
  writer.finish(total);
  EXPECT_EQ(slurp(folder / "parallel.las"), slurp(folder / "serial.las"));
}

TEST(Las, NothingStaysWithoutFinishOrWithRowsMissing) {
  const Folder folder;
  { create_cloud(folder / "x.las", fresh_spec(0))->write(random_bytes(26, 1)); }
  EXPECT_EQ(folder.files(), 0u);
  {
    LasFileWriter writer(folder / "y.las", fresh_spec(0));
    EXPECT_THROW(writer.finish(PointStatistics{.count = 1}), Error);
  }
  EXPECT_EQ(folder.files(), 0u);
  EXPECT_THROW(create_cloud(folder / "no" / "x.las", fresh_spec(0)), Error);
}

TEST(Las, TruncatedFileGivesItsWholePoints) {
  const Folder folder;
  const std::vector<std::byte> rows = random_bytes(36 * 100, 4);
  write_rows(folder / "x.las", fresh_spec(6), rows);
  std::vector<std::byte> bytes = slurp(folder / "x.las");
  bytes.resize(bytes.size() - 36 * 10 - 1);
  spill(folder / "x.las", bytes);
  const auto reader = open_cloud(folder / "x.las");
  EXPECT_EQ(reader->info().declared_points, 100u);
  EXPECT_EQ(reader->info().points, 89u);
  EXPECT_EQ(reader->info().warnings.size(), 1u);
  const Rows back = read_all(*reader);
  EXPECT_TRUE(std::equal(back.bytes.begin(), back.bytes.end(), rows.begin()));
  EXPECT_EQ(back.valid.size(), 89u);
}

struct Mutation {
  const char* what;
  std::function<void(std::vector<std::byte>&)> change;
  const char* expected;  // part of the sentence
};

TEST(Las, RefusesWhatCannotBeUnderstoodWithASentence) {
  const Folder folder;
  write_rows(folder / "good.las", fresh_spec(6), random_bytes(36 * 10, 4));
  const std::vector<std::byte> good = slurp(folder / "good.las");
  const auto set = [](std::size_t at, auto value) {
    return [=](std::vector<std::byte>& bytes) { store(&bytes[at], value); };
  };
  const std::vector<Mutation> mutations{
      {"empty", [](auto& b) { b.clear(); }, "is empty"},
      {"short", [](auto& b) { b.resize(100); }, "ends inside"},
      {"magic", set(0, 'X'), "not a LAS"},
      {"major", set(24, char{3}), "version 3.4"},
      {"minor", set(25, char{9}), "version 1.9"},
      {"small header", set(94, std::uint16_t{226}), "header size 226"},
      {"large header", set(94, std::uint16_t{65535}), "header size 65535"},
      {"points in header", set(96, std::uint32_t{374}), "place of the points"},
      {"points outside", set(96, std::uint32_t{4000000000u}), "place of the points"},
      {"format", set(104, char{11}), "point format 11"},
      {"old laz", set(104, char{0x46}), "pre-release"},
      {"laz", set(104, static_cast<unsigned char>(0x86)), "LASzip record"},
      {"record", set(105, std::uint16_t{29}), "record length 29"},
      {"no record", set(105, std::uint16_t{0}), "record length 0"},
      {"zero scale", set(131, 0.0), "scale of x"},
      {"nan scale", set(139, std::nan("")), "scale of y"},
      {"scale of no meaning", set(131, 1e-300), "scale of x at byte 131 is 1e-300; 1e-12 to 1000 are read"},
      {"scale below all", set(139, 9e-13), "scale of y"},
      {"scale above all", set(147, 1000.1), "scale of z"},
      {"huge scale", set(147, 1e308), "scale of z"},
      {"infinite offset", set(155, HUGE_VAL), "offset of x"},
  };
  for (const Mutation& mutation : mutations) {
    std::vector<std::byte> bytes = good;
    mutation.change(bytes);
    spill(folder / "bad.las", bytes);
    try {
      open_cloud(folder / "bad.las");
      ADD_FAILURE() << mutation.what << " was accepted";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(mutation.expected), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("bad.las"), std::string::npos) << error.what();
    }
  }
  EXPECT_THROW(open_cloud(folder / "missing.las"), Error);
  EXPECT_THROW(open_cloud(std::filesystem::temp_directory_path()), Error);
}

TEST(Las, AnyByteOfTheHeaderMayBeAnything) {
  const Folder folder;
  CloudSpec spec = fresh_spec(6);
  spec.like.vlrs.push_back(record("far", 9, 40, true));
  write_rows(folder / "good.las", spec, random_bytes(36 * 10, 4));
  const std::vector<std::byte> good = slurp(folder / "good.las");
  Rng rng(1);
  DamageTally tally;
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::byte> bytes = good;
    for (std::uint64_t n = 1 + rng.below(4); n > 0; --n)
      bytes[rng.below(bytes.size())] = static_cast<std::byte>(rng.below(2) ? 255 : rng.below(256));
    bytes.resize(bytes.size() - (rng.below(4) ? 0 : rng.below(bytes.size())));
    spill(folder / "bad.las", bytes);
    expect_refused_or_read(folder / "bad.las", DamageFound::at_open, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.read, 50);
  EXPECT_GT(tally.refused, 50);
}

}  // namespace
}  // namespace ilot
