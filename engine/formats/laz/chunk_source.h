// SPDX-License-Identifier: Apache-2.0
// A chunk of a file that is decoded while it is read. A chunk of formats 0-5 is one stream and passes through a window
// of bounded size, whatever its length (files before 2011 are one single chunk). Layered chunks are read whole.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

// Has the functions of ChunkDecoder: it decodes one chunk after the other, for one thread at a time.
class ChunkSource {
 public:
  ChunkSource(const InputFile& file, const ChunkLayout& layout);

  // Starts the chunk of `points` > 0 points in [offset, offset + bytes) of the file. False: it cannot contain them.
  bool begin(std::uint64_t offset, std::uint64_t bytes, std::uint64_t points, std::uint32_t fields = kAllFields);
  bool next(std::span<std::byte> records);
  std::uint64_t consumed() const { return decoder_.consumed(); }
  bool ended_well() const { return window_end_ == bytes_ && decoder_.ended_well(); }

 private:
  bool read_window(std::uint64_t from, std::uint64_t size);

  const InputFile& file_;
  ChunkLayout layout_;
  ChunkDecoder decoder_;
  std::uint64_t most_bytes_;  // greatest number of bytes that a point can use
  std::uint64_t offset_ = 0, bytes_ = 0;
  std::uint64_t window_end_ = 0;  // in the chunk
  std::vector<std::byte> window_;
};

}  // namespace ilot::laz
