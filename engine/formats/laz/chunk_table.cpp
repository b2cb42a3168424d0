// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk_table.h"

#include <memory>

#include "engine/cloud/record.h"
#include "engine/formats/laz/integer_codec.h"

namespace ilot::laz {

namespace {

constexpr std::size_t kFixedRecord = 34, kItemBytes = 6;
constexpr std::uint16_t kOneStream = 1, kChunked = 2, kLayered = 3;

struct Item {
  std::uint16_t type, size, version;
};
enum ItemType : std::uint16_t {
  kByte = 0,
  kPoint10 = 6,
  kGps11 = 7,
  kRgb12 = 8,
  kWave13 = 9,
  kPoint14 = 10,
  kRgb14 = 11,
  kRgbNir14 = 12,
  kWave14 = 13,
  kByte14 = 14
};

// Returns the items of a point format, in the version of the layout; waveform packets of formats 4 and 5 have only
// version 1.
std::vector<Item> items_of(const ChunkLayout& layout) {
  const std::uint8_t f = layout.point_format;
  const std::uint16_t v = layout.item_version;
  std::vector<Item> items;
  if (layout.layered()) {
    items.push_back({kPoint14, 30, v});
    if (f == 7) items.push_back({kRgb14, 6, v});
    if (f == 8 || f == 10) items.push_back({kRgbNir14, 8, v});
    if (f >= 9) items.push_back({kWave14, 29, v});
  } else {
    items.push_back({kPoint10, 20, v});
    if (gps_time_offset(f)) items.push_back({kGps11, 8, v});
    if (rgb_offset(f)) items.push_back({kRgb12, 6, v});
    if (f >= 4) items.push_back({kWave13, 29, 1});
  }
  const auto extra = static_cast<std::uint16_t>(layout.record_length - standard_size(f));
  if (extra > 0) items.push_back({layout.layered() ? kByte14 : kByte, extra, v});
  return items;
}

std::string check_item(const Item& found, const Item& expected, bool layered) {
  const std::string name = "item type " + std::to_string(found.type);
  if (found.type > kByte14 || (found.type > kByte && found.type < kPoint10)) return "names the unknown " + name;
  if (found.type != expected.type || found.size != expected.size) {
    return "has " + name + " of " + std::to_string(found.size) + " bytes where the point format wants type " +
           std::to_string(expected.type) + " of " + std::to_string(expected.size);
  }
  const bool known = layered ? found.version >= 2 && found.version <= 4 : found.version == expected.version;
  if (known) return "";
  if (!layered && (found.version == 1 || found.version == 2) && found.type != kWave13) return "mixes versions of items";
  return "has unknown version " + std::to_string(found.version) + " of " + name;
}

std::string check_frame(std::span<const std::byte> payload, bool layered) {
  if (payload.size() < kFixedRecord) return "is too short";
  const auto compressor = load<std::uint16_t>(payload.data());
  const auto coder = load<std::uint16_t>(payload.data() + 2);
  if (compressor < kOneStream || compressor > kLayered)
    return "names the unknown compressor " + std::to_string(compressor);
  if (coder != 0) return "names the unknown coder " + std::to_string(coder);
  if (layered != (compressor == kLayered)) {
    return "names compressor " + std::to_string(compressor) + ", which the point format does not allow";
  }
  const auto count = load<std::uint16_t>(payload.data() + 32);
  if (payload.size() < kFixedRecord + kItemBytes * count)
    return "is shorter than its " + std::to_string(count) + " items";
  return {};
}

Item item_at(std::span<const std::byte> payload, std::size_t i) {
  const std::byte* p = payload.data() + kFixedRecord + kItemBytes * i;
  return {load<std::uint16_t>(p), load<std::uint16_t>(p + 2), load<std::uint16_t>(p + 4)};
}

using SizeDecoder = IntegerCodec<Decoder, 32, 2>;
using SizeEncoder = IntegerCodec<Encoder, 32, 2>;

template <class Codec, class Coder>
std::uint32_t code_size(Codec& codec, Coder& coder, std::uint64_t predicted, std::uint64_t real,
                        std::uint32_t context) {
  return static_cast<std::uint32_t>(codec.code(coder, static_cast<std::int32_t>(static_cast<std::uint32_t>(predicted)),
                                               static_cast<std::int32_t>(static_cast<std::uint32_t>(real)), context));
}

}  // namespace

ParsedCompression parse_laszip_record(std::span<const std::byte> payload, std::uint8_t point_format,
                                      std::uint16_t record_length) {
  ParsedCompression out;
  ChunkLayout& layout = out.compression.layout;
  layout = {point_format, record_length, static_cast<std::uint8_t>(point_format >= 6 ? 3 : 2)};
  out.problem = check_frame(payload, layout.layered());
  if (!out.problem.empty()) return out;
  const auto count = load<std::uint16_t>(payload.data() + 32);
  if (!layout.layered() && count > 0 && item_at(payload, 0).version == 1) layout.item_version = 1;
  const std::vector<Item> expected = items_of(layout);
  for (std::size_t i = 0; i < count && out.problem.empty(); ++i) {
    const Item found = item_at(payload, i);
    out.problem = check_item(found, i < expected.size() ? expected[i] : Item{0, 0, 0}, layout.layered());
    if (layout.layered() && found.version != item_at(payload, 0).version) out.problem = "mixes versions of items";
    if (layout.layered() && found.version == 4) layout.item_version = 4;
  }
  if (out.problem.empty() && count != expected.size()) {
    out.problem =
        "lists " + std::to_string(count) + " items where the point format has " + std::to_string(expected.size());
  }
  out.compression.one_stream = load<std::uint16_t>(payload.data()) == kOneStream;
  out.compression.chunk_size = load<std::uint32_t>(payload.data() + 12);
  if (out.compression.chunk_size == 0) out.compression.chunk_size = kVariableChunks;
  return out;
}

std::vector<std::byte> laszip_record(const Compression& compression) {
  const std::vector<Item> items = items_of(compression.layout);
  std::vector<std::byte> payload(kFixedRecord + kItemBytes * items.size());
  std::byte* p = payload.data();
  store(p, compression.layout.layered() ? kLayered : compression.one_stream ? kOneStream : kChunked);
  store(p + 4, std::uint8_t{3});
  store(p + 5, std::uint8_t{4});
  store(p + 6, std::uint16_t{3});
  store(p + 12, compression.chunk_size);
  store(p + 16, std::int64_t{-1});
  store(p + 24, std::int64_t{-1});
  store(p + 32, static_cast<std::uint16_t>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) store(p + kFixedRecord + kItemBytes * i, items[i]);
  return payload;
}

ChunkTable decode_chunk_table(std::span<const std::byte> table, bool variable, std::uint64_t most) {
  ChunkTable out;
  if (table.size() < 8 || load<std::uint32_t>(table.data()) != 0) return out;
  const auto count = load<std::uint32_t>(table.data() + 4);
  if (count > most) return out;
  out.ok = true;
  if (count == 0) return out;
  Decoder decoder;
  decoder.start(table, table.subspan(8), 1);
  const auto sizes = std::make_unique<SizeDecoder>();
  ChunkEntry last;
  out.chunks.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (variable) last.points = code_size(*sizes, decoder, last.points, 0, 0);
    last.bytes = code_size(*sizes, decoder, last.bytes, 0, 1);
    out.chunks.push_back(last);
  }
  if (decoder.overrun()) out = {};
  return out;
}

std::vector<std::byte> encode_chunk_table(std::span<const ChunkEntry> chunks, bool variable) {
  std::vector<std::byte> out(8);
  store(out.data() + 4, static_cast<std::uint32_t>(chunks.size()));
  if (chunks.empty()) return out;
  Encoder encoder;
  encoder.start(1);
  const auto sizes = std::make_unique<SizeEncoder>();
  ChunkEntry last;
  for (const ChunkEntry& chunk : chunks) {
    if (variable) code_size(*sizes, encoder, last.points, chunk.points, 0);
    code_size(*sizes, encoder, last.bytes, chunk.bytes, 1);
    last = chunk;
  }
  const auto stream = encoder.finish();
  out.insert(out.end(), stream.begin(), stream.end());
  return out;
}

}  // namespace ilot::laz
