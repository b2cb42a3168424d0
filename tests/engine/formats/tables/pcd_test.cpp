// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/pcd.h"

#include <cmath>
#include <cstring>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

std::vector<std::byte> bytes_of(std::initializer_list<int> values) {
  std::vector<std::byte> bytes;
  for (const int v : values) bytes.push_back(static_cast<std::byte>(v));
  return bytes;
}

std::string header(const std::string& data, int points) {
  const std::string n = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z rgb _ curvature\nSIZE 4 4 4 4 1 8\n"
         "TYPE F F F U U F\nCOUNT 1 1 1 1 3 2\nWIDTH " +
         n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + n + "\nDATA " + data + "\n";
}

template <class T>
void put_little(std::string& out, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  out.append(raw, sizeof value);
}

std::string binary_pcd() {
  std::string text = header("binary", 3);
  for (const float x : {1.f, NAN, 3.f}) {
    for (const float v : {x, 2.f, 0.5f}) put_little(text, v);
    put_little(text, std::uint32_t{0xFF0180FF});
    text += "___";
    put_little(text, 0.25);
    put_little(text, 0.75);
  }
  return text;
}

// The same points, field after field, in literal runs only.
std::string compressed_file() {
  std::string fields, packed, text = header("binary_compressed", 3);
  for (const float v : {1.f, NAN, 3.f, 2.f, 2.f, 2.f, 0.5f, 0.5f, 0.5f}) put_little(fields, v);
  for (int i = 0; i < 3; ++i) put_little(fields, std::uint32_t{0xFF0180FF});
  fields += "_________";
  for (int i = 0; i < 3; ++i) {
    put_little(fields, 0.25);
    put_little(fields, 0.75);
  }
  for (std::size_t at = 0; at < fields.size(); at += 32) {
    const std::string run = fields.substr(at, 32);
    packed.push_back(static_cast<char>(run.size() - 1));
    packed += run;
  }
  put_little(text, static_cast<std::uint32_t>(packed.size()));
  put_little(text, static_cast<std::uint32_t>(fields.size()));
  return text + packed;
}

TEST(Pcd, LzfCopiesOverlapAndStayInside) {
  std::vector<std::byte> out(11);
  EXPECT_TRUE(expand_lzf(bytes_of({1, 'a', 'b', 0xE0, 0, 1}), out));
  EXPECT_EQ(out, bytes_of({'a', 'b', 'a', 'b', 'a', 'b', 'a', 'b', 'a', 'b', 'a'}));
  out.resize(4);
  EXPECT_TRUE(expand_lzf(bytes_of({0, 'x', 0x20, 0}), out));
  EXPECT_EQ(out, bytes_of({'x', 'x', 'x', 'x'}));
  for (const auto& bad :
       {bytes_of({5, 'a'}), bytes_of({0x20, 0}), bytes_of({0, 'x', 0x20, 1}), bytes_of({0, 'x', 0xE0}),
        bytes_of({0, 'x', 0x20}), bytes_of({0, 'x', 0xE0, 255, 0}), bytes_of({0, 'x'})})
    EXPECT_FALSE(expand_lzf(bad, out));
}

TEST(Pcd, AllCodingsGiveTheSameRows) {
  const Folder folder;
  spill_text(folder / "b.pcd", binary_pcd());
  spill_text(folder / "c.pcd", compressed_file());
  const auto reader = open_cloud(folder / "b.pcd");
  const RecordLayout& layout = reader->info().layout;
  const Rows rows = read_all(*reader, 2);
  EXPECT_EQ(rows.valid, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(rows.bytes, read_all(*open_cloud(folder / "c.pcd")).bytes);
  EXPECT_EQ(layout.point_format, 7);
  EXPECT_NEAR(world(rows, layout, 2).x, 3, 1e-12);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[30]), 257);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[32]), 0x80 * 257);
  EXPECT_EQ(load<std::uint16_t>(&rows.bytes[34]), 65535);
  ASSERT_EQ(layout.extra.size(), 2u);
  EXPECT_EQ(layout.extra[1].name, "curvature_1");
  EXPECT_EQ(load<double>(&rows.bytes[layout.extra[1].offset]), 0.75);

  spill_text(
      folder / "a.pcd",
      "VERSION .7\nFIELDS x y z rgb\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nHEIGHT 1\nDATA ascii\n1 2 3 4.2108e+06\n");
  const auto ascii = open_cloud(folder / "a.pcd");
  const Rows text = read_all(*ascii);
  EXPECT_EQ(text.valid, std::vector<std::uint8_t>{1});
  EXPECT_EQ(load<std::uint16_t>(&text.bytes[30]), 0x80 * 257) << "4.2108e+06 is 0x4A8080E0 as float";
  EXPECT_EQ(load<std::uint16_t>(&text.bytes[34]), 0xE0 * 257);
}

TEST(Pcd, TruncatedBinaryGivesItsWholePoints) {
  const Folder folder;
  std::string text = binary_pcd();
  text.pop_back();
  spill_text(folder / "b.pcd", text);
  const auto reader = open_cloud(folder / "b.pcd");
  EXPECT_EQ(reader->info().points, 2u);
  EXPECT_EQ(reader->info().warnings.size(), 1u);
}

TEST(Pcd, AnyByteMayBeAnything) {
  const Folder folder;
  const std::string files[] = {binary_pcd(), compressed_file()};
  Rng rng(4);
  DamageTally tally;
  for (int round = 0; round < 1000; ++round) {
    std::string text = files[round % 2];
    for (std::uint64_t n = 1 + rng.below(4); n > 0; --n)
      text[rng.below(text.size())] = static_cast<char>(rng.below(256));
    text.resize(text.size() - (rng.below(3) ? 0 : rng.below(text.size())));
    spill_text(folder / "bad.pcd", text);
    expect_refused_or_read(folder / "bad.pcd", DamageFound::at_open, tally);
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(tally.read, 50);
  EXPECT_GT(tally.refused, 50);
}

}  // namespace
}  // namespace ilot
