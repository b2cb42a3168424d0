// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/ply.h"

#include <algorithm>
#include <cstring>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

template <class T>
void put_value(std::string& out, T value, bool big) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (big) std::reverse(raw, raw + sizeof value);
  out.append(raw, sizeof value);
}

// Two points behind an element with lists.
std::string binary_ply(bool big) {
  std::string text = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                     "_endian 1.0\ncomment x\nelement face 2\nproperty list uchar int vertex_indices\n"
                     "property uchar flag\nelement vertex 2\nproperty double x\nproperty double y\nproperty float z\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty ushort intensity\n"
                     "property int id\nend_header\n";
  for (const int items : {3, 0}) {
    text.push_back(static_cast<char>(items));
    for (int i = 0; i < items; ++i) put_value(text, i, big);
    text.push_back('f');
  }
  for (const double x : {701362.56, 701363.0}) {
    put_value(text, x, big);
    put_value(text, 4485513.72, big);
    put_value(text, 1.5f, big);
    text += std::string("\xFF\x01\x00", 3);
    put_value(text, std::uint16_t{4000}, big);
    put_value(text, std::int32_t{-7}, big);
  }
  return text;
}

// A first vertex at 1e9 made all others unusable.
TEST(Ply, OneFarVertexDecidesNothing) {
  const Folder folder;
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3000\nproperty double x\nproperty double y\nproperty double "
      "z\nend_header\n1e9 1 1\n";
  for (int i = 1; i < 3000; ++i) text += std::to_string(i) + ".5 2 3\n";
  spill_text(folder / "a.ply", text);
  const auto reader = open_cloud(folder / "a.ply");
  const Rows rows = read_all(*reader, 500);
  EXPECT_EQ(rows.valid[0], 0);
  EXPECT_EQ(std::count(rows.valid.begin(), rows.valid.end(), 1), 2999);
  EXPECT_NEAR(world(rows, reader->info().layout, 1).x, 1.5, 1e-9);
}

TEST(Ply, BothByteOrdersGiveTheSameRows) {
  const Folder folder;
  spill_text(folder / "little.ply", binary_ply(false));
  spill_text(folder / "big.ply", binary_ply(true));
  const auto little = open_cloud(folder / "little.ply"), big = open_cloud(folder / "big.ply");
  const RecordLayout& layout = little->info().layout;
  EXPECT_EQ(layout.point_format, 7);
  EXPECT_TRUE(little->random_access());
  const Rows rows = read_all(*little);
  EXPECT_EQ(rows.bytes, read_all(*big).bytes);
  ASSERT_EQ(rows.valid.size(), 2u);
  EXPECT_NEAR(world(rows, layout, 0).x, 701362.56, 1e-9);
  EXPECT_EQ(world(rows, layout, 1).z, 1.5);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[12]), 4000);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[30]), 65535);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[32]), 257);
  EXPECT_EQ(load<std::int32_t>(&rows.bytes[36]), -7);
}

TEST(Ply, AsciiSkipsOtherElementsAndCountsWhatIsThere) {
  const Folder folder;
  spill_text(folder / "a.ply",
             "ply\nformat ascii 1.0\nelement camera 2\nproperty float f\nelement vertex 3\nproperty float x\n"
             "property float y\nproperty float z\nelement face 1\nproperty list uchar int i\nend_header\n"
             "9\n9\n1 2 3\nnan 5 6\n7 8 9\n3 0 1 2\n");
  auto reader = open_cloud(folder / "a.ply");
  Rows rows = read_all(*reader);
  EXPECT_EQ(rows.valid, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_NEAR(world(rows, reader->info().layout, 2).y, 8, 1e-9);
  spill_text(folder / "b.ply",
             "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
             "end_header\n1 2 3\n");
  reader = open_cloud(folder / "b.ply");
  EXPECT_EQ(reader->info().points, 1u);
  EXPECT_EQ(reader->info().warnings.size(), 1u);
}

TEST(Ply, WritesWhatItReads) {
  const Folder folder;
  CloudSpec spec;
  spec.like.layout.point_format = 3;
  spec.like.layout.record_length = 34;
  spec.like.layout.offset = {1000, 2000, 0};
  spec.appended = {{"plane_id", "", FieldType::u32, 0, 4, 1, 0}, {"two words", "", FieldType::f32, 0, 4, 1, 0}};
  std::vector<std::byte> rows(42 * 5000);
  for (std::size_t i = 0; i < 5000; ++i) {
    std::byte* p = &rows[42 * i];
    PointFields f;
    f.x = static_cast<std::int32_t>(i);
    f.z = -3;
    f.return_number = 1;
    f.return_count = 2;
    f.classification = 9;
    encode_fields(f, {p, 42}, 3);
    store(p + 20, 0.25 * static_cast<double>(i));
    store(p + 28, static_cast<std::uint16_t>(i));
    store(p + 34, static_cast<std::uint32_t>(4000000000u + i));
  }
  const auto writer = create_cloud(folder / "x.ply", spec);
  writer->write(std::span(rows).first(42 * 10));
  writer->write(std::span(rows).subspan(42 * 10));
  writer->finish();
  const auto reader = open_cloud(folder / "x.ply");
  const RecordLayout& layout = reader->info().layout;
  ASSERT_EQ(reader->info().points, 5000u);
  const Rows back = read_all(*reader, 700);
  for (std::size_t i = 0; i < 5000; ++i) {
    const std::byte* p = &back.bytes[i * layout.record_length];
    EXPECT_NEAR(world(back, layout, i).x, 1000 + 0.001 * static_cast<double>(i), 1e-9);
    EXPECT_EQ(decode_fields({p, layout.record_length}, layout.point_format).classification, 9);
    EXPECT_EQ(load<double>(p + 22), 0.25 * static_cast<double>(i));
    EXPECT_EQ(load<std::uint16_t>(p + 30), i);
    EXPECT_EQ(load<std::uint32_t>(p + layout.extra[0].offset), 4000000000u + i);
  }
  EXPECT_EQ(layout.extra[1].name, "two_words");
}

TEST(Ply, RefusesWithASentence) {
  const Folder folder;
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string texts[] = {
      "ply\n",
      "ply\nformat ascii 1.0\nend_header\n",
      "ply\nformat text 1.0\nend_header\n",
      "ply\nelement vertex 1\n" + xyz + "end_header\n",
      "ply\nformat ascii 1.0\nelement vertex many\n" + xyz + "end_header\n",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty word x\nend_header\n1\n",
      "ply\nformat ascii 1.0\nproperty float x\nend_header\n1\n",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty list float int l\n" + xyz + "end_header\n1\n",
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int l\n" + xyz + "end_header\n1\n",
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nend_header\n",
      "ply\nformat binary_little_endian 1.0\nelement face 9999999999999999\nproperty list uint double l\n"
      "element vertex 1\n" +
          xyz + "end_header\n\xFF\xFF\xFF\xFF",
      "ply\nformat binary_little_endian 1.0\nelement e 9999999999999999999\nproperty double d\n"
      "element vertex 1\n" +
          xyz + "end_header\n",
  };
  for (const std::string& text : texts) {
    spill_text(folder / "bad.ply", text);
    EXPECT_THROW(open_cloud(folder / "bad.ply"), Error) << text;
  }
}

TEST(Ply, AnyByteMayBeAnything) {
  const Folder folder;
  const std::string good = binary_ply(false);
  Rng rng(3);
  DamageTally tally;
  for (int round = 0; round < 1000; ++round) {
    std::string text = good;
    for (std::uint64_t n = 1 + rng.below(4); n > 0; --n)
      text[rng.below(text.size())] = static_cast<char>(rng.below(256));
    text.resize(text.size() - (rng.below(3) ? 0 : rng.below(text.size())));
    spill_text(folder / "bad.ply", text);
    expect_refused_or_read(folder / "bad.ply", DamageFound::at_open, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.read, 50);
  EXPECT_GT(tally.refused, 50);
}

}  // namespace
}  // namespace ilot
