// SPDX-License-Identifier: Apache-2.0
// One chunk of a LAZ file, from bytes to records and back. Memory only: no file, no thread, no exception but
// bad_alloc.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/fields.h"

namespace ilot::laz {

struct ChunkLayout {
  std::uint8_t point_format = 0;     // 0-5: one stream for all; 6-10: a stream for each attribute
  std::uint16_t record_length = 20;  // bytes, at least the format's standard size; the rest are extra bytes
  std::uint8_t item_version = 2;     // 1 (before 2011) or 2 (formats 0-5), 3 or 4 (formats 6-10)
  bool layered() const { return point_format >= 6; }
};

// Decodes one chunk after the other. Keeps its models (1 to 2 MB, more with several scanner channels) between
// chunks and allocates nothing after the first ones. One thread at a time.
class ChunkDecoder {
 public:
  explicit ChunkDecoder(const ChunkLayout& layout);
  ~ChunkDecoder();
  ChunkDecoder(ChunkDecoder&&) noexcept;
  ChunkDecoder& operator=(ChunkDecoder&&) noexcept;

  // Sets out to decode `points` > 0 points. False: the chunk cannot hold them. `chunk` must stay until the
  // last next(). `fields`: attributes to decode, of layered chunks; x, y, returns and scanner channel always
  // are, and the others hold anything when not asked for. The chunk may be longer than it should (when
  // nothing tells its size): see consumed().
  bool begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t fields = kAllFields);

  // Chunks of formats 0-5 may be read a window at a time: `rest` begins with the chunk's byte number consumed(), takes
  // the place of what begin() was given, and must stay until the last next().
  void go_on(std::span<const std::byte> rest);

  // Decodes the next records.size() / record_length points. False: the chunk is damaged, the records are
  // worthless. O(points), about 25 to 60 ns each; the result is the same for any cut into calls.
  bool next(std::span<std::byte> records);

  // Bytes of the chunk that the points so far have used up (layered chunks: all of it, from begin() on).
  std::size_t consumed() const;

  // All points decoded: each stream ended where it should. False tells damage that next() could not see.
  bool ended_well() const;

  class Implementation;

 private:
  std::unique_ptr<Implementation> implementation_;
};

// The whole of one chunk at once: true when all records were decoded and every stream ended where it should.
bool decode_chunk(ChunkDecoder& decoder, std::span<const std::byte> chunk, std::span<std::byte> records,
                  std::uint16_t record_length, std::uint32_t fields = kAllFields);

// Points that a layered chunk says it holds, and its size in bytes; 0 when it is not whole. `head`: its
// beginning, at least the raw point and the sizes of the streams; `available`: bytes from its start to what
// bounds it.
struct LayeredExtent {
  std::uint64_t points = 0;
  std::uint64_t bytes = 0;
};
LayeredExtent layered_extent(const ChunkLayout& layout, std::span<const std::byte> head, std::uint64_t available);
// Bytes of the raw point and the sizes of the streams.
std::size_t layered_head(const ChunkLayout& layout);

// What an encoder keeps: models of the standard fields, and one of every extra byte.
std::size_t encoder_bytes(const ChunkLayout& layout);

// Encodes chunks; keeps its models and buffers between them. Bytes are those of LASzip for the same points.
class ChunkEncoder {
 public:
  explicit ChunkEncoder(const ChunkLayout& layout);
  ~ChunkEncoder();
  ChunkEncoder(ChunkEncoder&&) noexcept;
  ChunkEncoder& operator=(ChunkEncoder&&) noexcept;

  // Appends the chunk of these records (at least one) to out.
  void encode(std::span<const std::byte> records, std::vector<std::byte>& out);

  class Implementation;

 private:
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace ilot::laz
