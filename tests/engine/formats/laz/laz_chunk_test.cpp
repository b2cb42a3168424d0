// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk.h"

#include "engine/formats/laz/point10_v1.h"

#include "tests/engine/formats/laz/laz_fixtures.h"

namespace ilot::laz {
namespace {

using test::OpenedLaz;
using test::PointMaker;

std::vector<std::byte> encoded(const ChunkLayout& layout, std::span<const std::byte> records) {
  std::vector<std::byte> out;
  ChunkEncoder(layout).encode(records, out);
  return out;
}

std::vector<ChunkLayout> all_layouts() {
  std::vector<ChunkLayout> layouts;
  for (std::uint8_t format = 0; format <= 10; ++format) {
    for (const std::uint16_t extra : {0, 1, 13}) {
      const auto length = static_cast<std::uint16_t>(standard_size(format) + extra);
      const bool layered = format >= 6;
      for (const int version : {layered ? 3 : 1, layered ? 4 : 2})
        layouts.push_back({format, length, static_cast<std::uint8_t>(version)});
    }
  }
  return layouts;
}

// By hand from the format: a raw point, and a stream in which nothing was coded.
TEST(LazChunk, OnePointIsRaw) {
  std::vector<std::byte> record(20, std::byte{7});
  std::vector<std::byte> expected = record;
  for (const int b : {1, 0, 0, 0}) expected.push_back(static_cast<std::byte>(b));
  EXPECT_EQ(encoded({0, 20, 2}, record), expected);

  record.resize(30, std::byte{7});
  expected = record;
  for (const int b : {1, 0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0}) expected.push_back(static_cast<std::byte>(b));
  expected.resize(30 + 4 + 9 * 4);
  for (int i = 0; i < 2; ++i) {
    for (const int b : {1, 0, 0, 0}) expected.push_back(static_cast<std::byte>(b));
  }
  EXPECT_EQ(encoded({6, 30, 3}, record), expected);
}

TEST(LazChunk, RoundTripOfEveryFormat) {
  std::uint64_t key = 1;
  for (const ChunkLayout& layout : all_layouts()) {
    ChunkEncoder encoder(layout);
    ChunkDecoder decoder(layout);
    for (const std::size_t count : {1, 2, 3, 100, 3000}) {
      SCOPED_TRACE(testing::Message() << "format " << int(layout.point_format) << " version "
                                      << int(layout.item_version) << " length " << layout.record_length << " n "
                                      << count);
      const auto records = PointMaker(layout, ++key).make(count);
      std::vector<std::byte> chunk, decoded(records.size());
      encoder.encode(records, chunk);
      ASSERT_TRUE(decode_chunk(decoder, chunk, decoded, layout.record_length));
      ASSERT_TRUE(decoded == records);
      EXPECT_EQ(chunk, encoded(layout, records)) << "a used encoder must write what a new one does";
    }
  }
}

// No file at hand has such bytes, so that the words of the format stand here once more: all of them by one codec of
// 8 bits, with a context for each.
TEST(LazChunk, ExtraBytesOfVersion1AreIntegersOf8Bits) {
  constexpr std::size_t kLength = 23, kCore = 20;
  const auto records = PointMaker({0, kLength, 1}, 21).make(500);
  Encoder encoder;
  encoder.start(1);
  const auto core = std::make_unique<Point10CodecV1<Encoder>>();
  const auto bytes = std::make_unique<IntegerCodec<Encoder, 8, kLength - kCore>>();
  core->start(load<Point10>(records.data()));
  for (std::size_t at = kLength; at < records.size(); at += kLength) {
    core->code(encoder, load<Point10>(&records[at]));
    for (std::uint32_t i = 0; i < kLength - kCore; ++i)
      bytes->code(encoder, std::to_integer<std::int32_t>(records[at - kLength + kCore + i]),
                  std::to_integer<std::int32_t>(records[at + kCore + i]), i);
  }
  std::vector<std::byte> expected(records.begin(), records.begin() + kLength);
  const auto stream = encoder.finish();
  expected.insert(expected.end(), stream.begin(), stream.end());
  EXPECT_EQ(encoded({0, kLength, 1}, records), expected);
}

TEST(LazChunk, CutIntoCallsAnyhow) {
  const ChunkLayout layout{8, 41, 3};
  const auto records = PointMaker(layout, 5).make(500);
  const auto chunk = encoded(layout, records);
  for (const std::size_t step : {1, 7, 499}) {
    ChunkDecoder decoder(layout);
    std::vector<std::byte> decoded(records.size());
    ASSERT_TRUE(decoder.begin(chunk, 500));
    for (std::size_t at = 0; at < 500; at += step) {
      ASSERT_TRUE(decoder.next(std::span(decoded).subspan(at * 41, std::min(step, 500 - at) * 41)));
    }
    EXPECT_TRUE(decoder.ended_well());
    EXPECT_TRUE(decoded == records);
    EXPECT_FALSE(decoder.next(std::span(decoded).first(41))) << "there is no point left";
  }
}

TEST(LazChunk, ConsumesItsOwnBytesOnly) {
  for (const ChunkLayout& layout : all_layouts()) {
    const auto records = PointMaker(layout, 9).make(200);
    auto chunk = encoded(layout, records);
    const std::size_t size = chunk.size();
    chunk.resize(size + 100, std::byte{0x5A});
    ChunkDecoder decoder(layout);
    std::vector<std::byte> decoded(records.size());
    ASSERT_TRUE(decoder.begin(chunk, 200));
    ASSERT_TRUE(decoder.next(decoded));
    EXPECT_EQ(decoder.consumed(), size);
    EXPECT_TRUE(decoded == records);
  }
}

TEST(LazChunk, FieldsNotAskedForDoNotDisturbTheOthers) {
  const ChunkLayout layout{8, 40, 3};
  const auto records = PointMaker(layout, 11).make(2000);
  const auto chunk = encoded(layout, records);
  ChunkDecoder decoder(layout);
  std::vector<std::byte> decoded(records.size());
  ASSERT_TRUE(decode_chunk(decoder, chunk, decoded, 40, kFieldZ | kFieldClass));
  for (std::size_t i = 0; i < 2000; ++i) {
    const std::byte *a = &decoded[40 * i], *b = &records[40 * i];
    ASSERT_EQ(std::memcmp(a, b, 12), 0) << i;
    ASSERT_EQ(a[14], b[14]) << i;
    ASSERT_EQ(a[16], b[16]) << i;
  }
}

TEST(LazChunk, DamageIsReportedOrHarmless) {
  Rng rng(77);
  for (const ChunkLayout& layout : all_layouts()) {
    const auto records = PointMaker(layout, 13).make(300);
    const auto chunk = encoded(layout, records);
    ChunkDecoder decoder(layout);
    std::vector<std::byte> decoded(records.size());
    for (int round = 0; round < 60; ++round) {
      // An exact copy on the heap, so that a sanitizer sees every byte read too many.
      std::vector<std::byte> damaged(
          chunk.begin(),
          chunk.begin() + static_cast<std::ptrdiff_t>(round % 3 ? chunk.size() : rng.below(chunk.size())));
      for (std::uint64_t i = rng.below(4); i < 4 && !damaged.empty(); ++i) {
        damaged[rng.below(damaged.size())] = static_cast<std::byte>(rng.below(256));
      }
      if (damaged.size() < chunk.size()) {
        EXPECT_FALSE(decode_chunk(decoder, damaged, decoded, layout.record_length) && decoded == records);
      } else {
        decode_chunk(decoder, damaged, decoded, layout.record_length);
      }
    }
    ASSERT_TRUE(decode_chunk(decoder, chunk, decoded, layout.record_length)) << "damage must not outlive its chunk";
    EXPECT_TRUE(decoded == records);
  }
}

TEST(LazChunk, ChunkTablesRoundTrip) {
  Rng rng(3);
  for (const bool variable : {false, true}) {
    for (const std::size_t count : {0, 1, 2, 1000}) {
      std::vector<ChunkEntry> chunks(count);
      for (auto& c : chunks) c = {variable ? rng.below(1u << 20) : 0, static_cast<std::uint32_t>(rng.next())};
      const auto bytes = encode_chunk_table(chunks, variable);
      const ChunkTable table = decode_chunk_table(bytes, variable, count);
      ASSERT_TRUE(table.ok);
      ASSERT_EQ(table.chunks.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(table.chunks[i].points, chunks[i].points);
        EXPECT_EQ(table.chunks[i].bytes, chunks[i].bytes);
      }
      EXPECT_EQ(count == 0 || !decode_chunk_table(bytes, variable, count - 1).ok, true) << "count out of bounds";
      if (count < 2) continue;
      EXPECT_FALSE(decode_chunk_table(std::span(bytes).first(bytes.size() - 3), variable, count).ok);
    }
  }
}

// The strongest test of both directions: every chunk of every real file, decoded and encoded again, has the
// bytes that LASzip (or whoever wrote the file) gave it, and so has the table.
TEST(LazChunk, RealChunksComeBackByteForByte) {
  ILOT_DATA_OR_SKIP(data);
  std::size_t files = 0, chunks = 0;
  for (const auto& path : test::laz_files(data)) {
    if (path.string().find("broken_") != std::string::npos) continue;
    SCOPED_TRACE(path);
    const auto laz = std::make_unique<OpenedLaz>(path);
    ++files;
    const ChunkLayout& layout = laz->compression.layout;
    ChunkDecoder decoder(layout);
    ChunkEncoder encoder(layout);
    std::vector<ChunkEntry> table;
    for (const ChunkPlace& place : laz->index.chunks) {
      const auto chunk = laz->bytes(place);
      std::vector<std::byte> records(place.points * layout.record_length), again;
      ASSERT_TRUE(decode_chunk(decoder, chunk, records, layout.record_length)) << "chunk at " << place.offset;
      encoder.encode(records, again);
      ASSERT_TRUE(again == chunk) << "chunk at " << place.offset << " of " << place.bytes << " came back as "
                                  << again.size();
      table.push_back({place.points, static_cast<std::uint32_t>(place.bytes)});
      ++chunks;
    }
    if (laz->compression.one_stream || table.empty()) continue;
    const auto expected = encode_chunk_table(table, laz->compression.chunk_size == kVariableChunks);
    std::vector<std::byte> found(expected.size());
    laz->file.read_at(laz->index.chunks.back().offset + laz->index.chunks.back().bytes, found);
    EXPECT_EQ(found, expected);
  }
  EXPECT_GT(files, 40u);
  RecordProperty("chunks", static_cast<int>(chunks));
}

}  // namespace
}  // namespace ilot::laz
