// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk_source.h"

#include <algorithm>

namespace ilot::laz {

namespace {

// Most chunks of 50,000 points fit and are read at once.
constexpr std::uint64_t kWindow = std::uint64_t{1} << 20;
// A window is used until its last quarter, so little is read twice.
constexpr std::uint64_t kReserve = kWindow / 4;

// A symbol uses at most 15 bits and is followed by at most 24 raw bits. No item has more than two symbols for each of
// its bytes. 64 more bytes cover the bits of changed fields, full GPS times and offsets of waveforms.
std::uint64_t most_bytes_of_point(const ChunkLayout& layout) {
  return 4u * layout.record_length + 64u;
}

}  // namespace

ChunkSource::ChunkSource(const InputFile& file, const ChunkLayout& layout)
    : file_(file), layout_(layout), decoder_(layout), most_bytes_(most_bytes_of_point(layout)) {}

bool ChunkSource::begin(std::uint64_t offset, std::uint64_t bytes, std::uint64_t points, std::uint32_t fields) {
  offset_ = offset;
  bytes_ = bytes;
  const std::uint64_t size = layout_.layered() ? bytes : std::min(bytes, std::max(kWindow, 2 * most_bytes_));
  return read_window(0, size) && decoder_.begin(window_, points, fields);
}

bool ChunkSource::next(std::span<std::byte> records) {
  const std::uint64_t length = layout_.record_length;
  while (!records.empty()) {
    std::uint64_t points = records.size() / length;
    if (window_end_ < bytes_) {
      points = std::min(points, std::max<std::uint64_t>(1, kReserve / most_bytes_));
      const std::uint64_t at = decoder_.consumed();
      if (at > window_end_) return false;
      if (window_end_ - at < points * most_bytes_) {
        if (!read_window(at, std::min<std::uint64_t>(bytes_ - at, window_.size()))) return false;
        decoder_.go_on(window_);
      }
    }
    if (!decoder_.next(records.first(points * length))) return false;
    records = records.subspan(points * length);
  }
  return true;
}

bool ChunkSource::read_window(std::uint64_t from, std::uint64_t size) {
  window_.resize(size);
  window_end_ = from + size;
  return file_.read_at(offset_ + from, window_) == size;
}

}  // namespace ilot::laz
