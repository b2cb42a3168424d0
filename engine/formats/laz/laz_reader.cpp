// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <mutex>
#include <string>

#include "engine/error.h"
#include "engine/formats/laz/chunk_source.h"
#include "engine/formats/laz/laz.h"

namespace ilot {
namespace {

// The greatest number of points, and of bytes, that are decoded at a time to reach the first wanted point.
constexpr std::uint64_t kSkipBlock = 512, kSkipBytes = std::uint64_t{64} << 10;

// A decoder in the middle of a chunk, ready to continue.
struct Cursor {
  Cursor(const InputFile& file, const laz::ChunkLayout& layout) : source(file, layout) {}
  laz::ChunkSource source;
  std::vector<std::byte> skipped;
  std::uint64_t at = UINT64_MAX;   // next point
  std::uint64_t end = UINT64_MAX;  // of the chunk
};

class LazReader final : public PointReader {
 public:
  LazReader(std::unique_ptr<InputFile> file, LasContainer container, const laz::Compression& compression)
      : file_(std::move(file)),
        info_(std::move(container.info)),
        compression_(compression),
        index_(laz::index_chunks(*file_, container.point_offset, info_.declared_points, compression)) {
    info_.points = index_.points;
    if (!index_.warning.empty()) {
      info_.warnings.push_back(file_->path().string() + ": " + std::to_string(info_.points) + " of " +
                               std::to_string(info_.declared_points) + " points can be read: " + index_.warning);
    }
    if (info_.points == 0 && info_.declared_points > 0) {
      throw Error(file_->path().string() + ": none of its " + std::to_string(info_.declared_points) +
                  " points can be read (" + index_.warning + "); fetch the file again");
    }
  }

  LazChunks chunks() const { return {*file_, compression_, index_}; }

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return !compression_.one_stream; }
  void limit_to(std::uint32_t fields) override {
    fields_ = fields;
    idle_.clear();  // they are in chunks that were begun with other fields
  }

  std::vector<std::uint64_t> boundaries() const override {
    std::vector<std::uint64_t> result;
    for (const laz::ChunkPlace& chunk : index_.chunks) result.push_back(chunk.first);
    if (result.empty()) result.push_back(0);
    if (result.back() != info_.points) result.push_back(info_.points);
    return result;
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    if (first >= info_.points) return 0;
    const std::size_t length = info_.layout.record_length;
    const std::uint64_t asked = std::min(records.size() / length, valid.size());
    const std::uint64_t rows = std::min(asked, info_.points - first);
    std::unique_ptr<Cursor> cursor = borrow(first);
    std::uint64_t done = 0;
    while (done < rows && (cursor->at == first + done || seek(*cursor, first + done))) {
      const std::uint64_t part = std::min(rows - done, cursor->end - cursor->at);
      if (!advance(*cursor, records.subspan(done * length, part * length))) break;
      done += part;
    }
    give_back(std::move(cursor));
    std::fill_n(valid.begin(), done, std::uint8_t{1});
    return done;
  }

 private:
  // Returns a decoder that is at `first`, if there is one.
  std::unique_ptr<Cursor> borrow(std::uint64_t first) {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::make_unique<Cursor>(*file_, compression_.layout);
    auto it = std::find_if(idle_.begin(), idle_.end(), [&](const auto& c) { return c->at == first; });
    if (it == idle_.end()) it = idle_.begin();
    std::unique_ptr<Cursor> cursor = std::move(*it);
    idle_.erase(it);
    return cursor;
  }
  // A decoder at the end of its chunk is no longer useful and takes half a megabyte, and there may be thousands of
  // inputs.
  void give_back(std::unique_ptr<Cursor> cursor) {
    if (cursor->at == UINT64_MAX) return;
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(cursor));
  }

  bool seek(Cursor& c, std::uint64_t point) {
    c.at = c.end = UINT64_MAX;
    const auto after = std::upper_bound(index_.chunks.begin(), index_.chunks.end(), point,
                                        [](std::uint64_t p, const laz::ChunkPlace& chunk) { return p < chunk.first; });
    const laz::ChunkPlace& place = *(after - 1);
    if (!c.source.begin(place.offset, place.bytes, place.points, fields_)) return false;
    c.at = place.first;
    c.end = place.first + place.points;
    const std::uint64_t length = info_.layout.record_length;
    const std::uint64_t most = std::clamp<std::uint64_t>(kSkipBytes / length, 1, kSkipBlock);
    c.skipped.resize(std::min(point - c.at, most) * length);
    while (c.at < point) {
      const std::uint64_t block = std::min(most, point - c.at);
      if (!advance(c, std::span(c.skipped).first(block * length))) return false;
    }
    return true;
  }

  // A single stream has no size of its own and may have been cut.
  bool advance(Cursor& c, std::span<std::byte> records) {
    c.at += records.size() / info_.layout.record_length;
    const bool ended = c.at == c.end;
    const bool whole = c.source.next(records) && (!ended || compression_.one_stream || c.source.ended_well());
    if (ended || !whole) c.at = c.end = UINT64_MAX;
    return whole;
  }

  std::unique_ptr<InputFile> file_;
  CloudInfo info_;
  laz::Compression compression_;
  laz::ChunkIndex index_;
  std::uint32_t fields_ = kAllFields;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Cursor>> idle_;
};

const Vlr& laszip_vlr(const InputFile& file, const CloudInfo& info) {
  for (const Vlr& vlr : info.vlrs) {
    if (vlr.user_id == laz::kLaszipUserId && vlr.record_id == laz::kLaszipRecordId) return vlr;
  }
  throw Error(file.path().string() + ": is marked as LAZ but has no LASzip record; " + "fetch the file again");
}

}  // namespace

std::unique_ptr<PointReader> open_laz(std::unique_ptr<InputFile> file, LasContainer container) {
  const RecordLayout& layout = container.info.layout;
  const Vlr& vlr = laszip_vlr(*file, container.info);
  const laz::ParsedCompression parsed =
      laz::parse_laszip_record(vlr.payload, layout.point_format, layout.record_length);
  if (!parsed.problem.empty()) throw Error(file->path().string() + ": its LASzip record " + parsed.problem);
  return std::make_unique<LazReader>(std::move(file), std::move(container), parsed.compression);
}

std::optional<LazChunks> laz_chunks(const PointReader& reader) {
  const auto* laz = dynamic_cast<const LazReader*>(&reader);
  if (laz == nullptr) return std::nullopt;
  return laz->chunks();
}

}  // namespace ilot
