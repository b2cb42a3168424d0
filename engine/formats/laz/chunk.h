// SPDX-License-Identifier: Apache-2.0
// Converts one chunk of a LAZ file from bytes to records and back. It works in memory only, without files or threads,
// and throws no exception except bad_alloc.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/fields.h"

namespace ilot::laz {

inline void append(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  out.insert(out.end(), bytes.begin(), bytes.end());
}

struct ChunkLayout {
  std::uint8_t point_format = 0;     // 0-5: one stream for all; 6-10: one stream for each attribute
  std::uint16_t record_length = 20;  // bytes, at least the standard size of the format; the rest are extra bytes
  std::uint8_t item_version = 2;     // 1 (before 2011) or 2 (formats 0-5), 3 or 4 (formats 6-10)
  bool layered() const { return point_format >= 6; }
};

// Decodes one chunk after the other. Keeps its models (1 to 2 MB, more with several scanner channels) between chunks
// and allocates nothing after the first chunks. For one thread at a time.
class ChunkDecoder {
 public:
  explicit ChunkDecoder(const ChunkLayout& layout);
  ~ChunkDecoder();
  ChunkDecoder(ChunkDecoder&&) noexcept;
  ChunkDecoder& operator=(ChunkDecoder&&) noexcept;

  // Prepares to decode `points` > 0 points. False: the chunk cannot contain them. `chunk` must stay valid until the
  // last next(). `fields` are the attributes to decode in layered chunks. x, y, returns and scanner channel are always
  // decoded; the others are undefined unless they are asked for. The chunk may be longer than its content (when its
  // size is not known): see consumed().
  bool begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t fields = kAllFields);

  // Chunks of formats 0-5 may be read one window at a time. `rest` begins with byte number consumed() of the chunk,
  // replaces the bytes that begin() was given, and must stay valid until the last next().
  void go_on(std::span<const std::byte> rest);

  // Decodes the next records.size() / record_length points. False: the chunk is damaged and the records are not usable.
  // O(points), about 25 to 60 ns each. The result does not depend on how the points are divided into calls.
  bool next(std::span<std::byte> records);

  // Returns the bytes of the chunk that the decoded points have used (layered chunks: all bytes, from begin() on).
  std::size_t consumed() const;

  // True when all points are decoded and each stream ended where it should. False means damage that next() could not
  // detect.
  bool ended_well() const;

  class Implementation;

 private:
  std::unique_ptr<Implementation> implementation_;
};

// Decodes a whole chunk at once. True when all records were decoded and every stream ended where it should.
bool decode_chunk(ChunkDecoder& decoder, std::span<const std::byte> chunk, std::span<std::byte> records,
                  std::uint16_t record_length, std::uint32_t fields = kAllFields);

// The number of points that a layered chunk declares and its size in bytes; 0 when it is not complete. `head` is its
// beginning, at least the raw point and the sizes of the streams. `available` is the number of bytes from its start to
// the limit.
struct LayeredExtent {
  std::uint64_t points = 0;
  std::uint64_t bytes = 0;
};
LayeredExtent layered_extent(const ChunkLayout& layout, std::span<const std::byte> head, std::uint64_t available);
// Returns the bytes of the raw point and of the sizes of the streams.
std::size_t layered_head(const ChunkLayout& layout);

// Returns the memory of an encoder: models of the standard fields, and one for every extra byte.
std::size_t encoder_bytes(const ChunkLayout& layout);

// Encodes chunks; keeps its models and buffers between them. The bytes are those that LASzip writes for the same
// points.
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
