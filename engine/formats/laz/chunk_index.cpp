// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk_index.h"

#include <algorithm>

#include "engine/cloud/record.h"
#include "engine/error.h"
#include "engine/formats/laz/chunk_source.h"

namespace ilot::laz {

namespace {

constexpr std::uint64_t kScanBlock = 1024;  // greatest number of points between two tests for the end of the stream
constexpr std::uint64_t kScanBytes = std::uint64_t{256} << 10;  // greatest number of their bytes

class Indexer {
 public:
  Indexer(const InputFile& file, std::uint64_t begin, std::uint64_t declared, const Compression& compression)
      : file_(file), begin_(begin), declared_(declared), compression_(compression), layout_(compression.layout) {}

  ChunkIndex run() {
    if (declared_ == 0) return {};
    if (compression_.one_stream) {
      scan_streams(begin_, declared_, true);
    } else if (begin_ + 8 <= file_.size() && !by_table()) {
      scan();
    }
    if (index_.points < declared_ && index_.warning.empty()) index_.warning = "some chunks are missing";
    return std::move(index_);
  }

 private:
  bool variable() const { return compression_.chunk_size == kVariableChunks; }

  std::uint64_t number_at(std::uint64_t offset) const {
    std::byte bytes[8] = {};
    file_.read_at(offset, bytes);
    return load<std::uint64_t>(bytes);
  }

  bool is_place(std::uint64_t table) const { return table >= begin_ + 8 && table <= file_.size() - 8; }

  // The first 8 bytes give the place of the table, or the last 8 bytes when the writer could not go back.
  bool by_table() {
    if (file_.size() < begin_ + 16) return false;
    for (const std::uint64_t place : {number_at(begin_), number_at(file_.size() - 8)}) {
      if (is_place(place) && take_table(place)) return true;
    }
    return false;
  }

  bool take_table(std::uint64_t place) {
    const std::uint64_t most = (place - begin_ - 8) / (layout_.record_length + 4u);
    std::vector<std::byte> bytes(std::min<std::uint64_t>(file_.size() - place, 64 + 12 * most));
    bytes.resize(file_.read_at(place, bytes));
    ChunkTable table = decode_chunk_table(bytes, variable(), most);
    if (!table.ok || !is_consistent(table, place)) return false;
    std::uint64_t offset = begin_ + 8;
    for (const ChunkEntry& chunk : table.chunks) {
      const std::uint64_t left = declared_ - std::min(index_.points, declared_);
      const std::uint64_t points = variable() ? chunk.points : std::min<std::uint64_t>(left, compression_.chunk_size);
      if (left == 0) {
        index_.warning = "it has more chunks than its header has points; the rest is left out";
        break;
      }
      add(points, offset, chunk.bytes);
      offset += chunk.bytes;
    }
    return true;
  }

  bool is_consistent(const ChunkTable& table, std::uint64_t place) const {
    std::uint64_t end = begin_ + 8;
    for (const ChunkEntry& chunk : table.chunks) {
      end += chunk.bytes;
      if (chunk.bytes < layout_.record_length + 4u || end > place || (variable() && chunk.points == 0)) return false;
    }
    return !table.chunks.empty();
  }

  void add(std::uint64_t points, std::uint64_t offset, std::uint64_t bytes) {
    index_.chunks.push_back({index_.points, points, offset, bytes});
    index_.points += points;
    if (index_.points > declared_) {
      index_.warning = "its chunks contain more points than its header says; the rest is left out";
      index_.points = declared_;
    }
  }

  void scan() {
    index_ = {};
    if (layout_.layered()) {
      scan_layers();
    } else if (variable()) {
      throw Error(file_.path().string() + ": the table of its chunks of variable size is missing (the file is cut off" +
                  " or was not finished) and nothing else says where they are; fetch the file again");
    } else {
      scan_streams(begin_ + 8, compression_.chunk_size, false);
    }
    index_.warning = "its table of chunks is missing (cut off or not finished); whole chunks were searched for";
  }

  void scan_layers() {
    std::vector<std::byte> head(layered_head(layout_));
    for (std::uint64_t offset = begin_ + 8; index_.points < declared_ && offset < file_.size();) {
      head.resize(file_.read_at(offset, head));
      const LayeredExtent extent = layered_extent(layout_, head, file_.size() - offset);
      const std::uint64_t left = declared_ - index_.points;
      const std::uint64_t expected =
          variable() ? extent.points : std::min<std::uint64_t>(left, compression_.chunk_size);
      if (extent.points == 0 || extent.points != expected || extent.points > left) break;
      add(extent.points, offset, extent.bytes);
      offset += extent.bytes;
    }
  }

  // The end of a stream is found only by decoding. A single stream that is cut off keeps its complete points.
  void scan_streams(std::uint64_t offset, std::uint64_t chunk_size, bool keep_part) {
    ChunkSource source(file_, layout_);
    while (index_.points < declared_ && offset < file_.size()) {
      const std::uint64_t points = std::min(chunk_size, declared_ - index_.points), left = file_.size() - offset;
      const std::uint64_t whole = count_whole(source, offset, left, points);
      if (whole < points && !keep_part) break;
      if (whole > 0) add(whole, offset, whole < points ? left : source.consumed());
      if (whole < points) break;
      offset += source.consumed();
    }
    if (keep_part && index_.points < declared_) index_.warning = "its stream of points breaks off";
  }

  // Returns the number of points before the stream ends, rounded to a multiple of the block.
  std::uint64_t count_whole(ChunkSource& source, std::uint64_t offset, std::uint64_t bytes,
                            std::uint64_t points) const {
    if (!source.begin(offset, bytes, points)) return 0;
    const std::uint64_t most = std::clamp<std::uint64_t>(kScanBytes / layout_.record_length, 1, kScanBlock);
    std::vector<std::byte> records(std::min(points, most) * layout_.record_length);
    for (std::uint64_t done = 0; done < points; done += most) {
      const std::uint64_t block = std::min(most, points - done);
      if (!source.next(std::span(records).first(block * layout_.record_length))) return done;
    }
    return points;
  }

  const InputFile& file_;
  std::uint64_t begin_, declared_;
  const Compression& compression_;
  const ChunkLayout& layout_;
  ChunkIndex index_;
};

}  // namespace

ChunkIndex index_chunks(const InputFile& file, std::uint64_t begin, std::uint64_t declared,
                        const Compression& compression) {
  return Indexer(file, begin, declared, compression).run();
}

}  // namespace ilot::laz
