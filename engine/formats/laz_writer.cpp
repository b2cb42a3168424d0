// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "engine/error.h"
#include "engine/formats/las_plan.h"
#include "engine/formats/laz.h"
#include "engine/formats/laz/chunk_table.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

// What encodes one chunk of a batch.
struct Slot {
  explicit Slot(const laz::ChunkLayout& layout) : encoder(layout) {}
  laz::ChunkEncoder encoder;
  std::vector<std::byte> bytes;
  PointStatistics statistics;
};

class LazWriter final : public PointWriter {
 public:
  LazWriter(const std::filesystem::path& path, const CloudSpec& spec, const LazOptions& options)
      : file_(path),
        plan_(plan_las(spec)),
        chunk_bytes_(std::size_t{options.chunk_points} * plan_.layout.record_length) {
    compression_.layout = {plan_.layout.point_format, plan_.layout.record_length,
                           static_cast<std::uint8_t>(plan_.layout.point_format >= 6 ? 3 : 2)};
    compression_.chunk_size = options.chunk_points;
    plan_.vlrs.push_back(
        {laz::kLaszipUserId, laz::kLaszipRecordId, "compressed points", laz::laszip_record(compression_)});
    std::vector<std::byte> prefix = las_prefix(plan_);
    mark_compressed(prefix);
    mark_compressed(plan_.header);
    point_offset_ = prefix.size();
    file_.append(prefix);
    file_.append(std::vector<std::byte>(8));  // the place of the table, later
    const auto slots = static_cast<std::size_t>(2 * thread_count());
    for (std::size_t i = 0; i < slots; ++i) slots_.emplace_back(compression_.layout);
  }

  std::size_t record_length() const override { return plan_.layout.record_length; }

  void write(std::span<const std::byte> records) override {
    const std::size_t batch = chunk_bytes_ * slots_.size();
    while (!records.empty()) {
      const std::size_t part = std::min(records.size(), batch - pending_.size());
      pending_.insert(pending_.end(), records.begin(), records.begin() + static_cast<std::ptrdiff_t>(part));
      records = records.subspan(part);
      if (pending_.size() == batch) flush();
    }
  }

  void finish() override {
    flush();
    const std::uint64_t table = file_.position();
    file_.append(laz::encode_chunk_table(chunks_, false));
    std::byte place[8];
    store(place, table);
    file_.write_at(point_offset_, place);
    const std::uint64_t evlrs = file_.position();
    file_.append(las_suffix(plan_));
    finish_header(plan_, statistics_, evlrs);
    file_.write_at(0, plan_.header);
    file_.commit();
  }

 private:
  static void mark_compressed(std::vector<std::byte>& header) { header[las::kFormat] |= std::byte{0x80}; }

  void flush() {
    const std::size_t chunks = (pending_.size() + chunk_bytes_ - 1) / chunk_bytes_;
    parallel_for(chunks, [&](std::size_t i) { encode(slots_[i], i); });
    for (std::size_t i = 0; i < chunks; ++i) append(slots_[i]);
    pending_.clear();
  }

  void encode(Slot& slot, std::size_t chunk) const {
    const std::size_t begin = chunk * chunk_bytes_;
    const auto rows = std::span(pending_).subspan(begin, std::min(chunk_bytes_, pending_.size() - begin));
    slot.bytes.clear();
    slot.encoder.encode(rows, slot.bytes);
    slot.statistics = {};
    slot.statistics.add(rows, plan_.layout);
  }

  void append(const Slot& slot) {
    if (slot.bytes.size() > UINT32_MAX) {
      throw Error(file_.path().string() + ": a chunk grew beyond 4 GiB; write smaller chunks");
    }
    chunks_.push_back({0, static_cast<std::uint32_t>(slot.bytes.size())});
    statistics_.merge(slot.statistics);
    file_.append(slot.bytes);
  }

  OutputFile file_;
  LasPlan plan_;
  std::size_t chunk_bytes_;
  laz::Compression compression_;
  std::uint64_t point_offset_ = 0;
  std::vector<Slot> slots_;
  std::vector<std::byte> pending_;
  std::vector<laz::ChunkEntry> chunks_;
  PointStatistics statistics_;
};

}  // namespace

std::unique_ptr<PointWriter> create_laz(const std::filesystem::path& path, const CloudSpec& spec,
                                        const LazOptions& options) {
  if (options.chunk_points == 0 || options.chunk_points == laz::kVariableChunks) {
    throw Error(path.string() + ": chunks need a fixed number of points", ExitCode::usage);
  }
  return std::make_unique<LazWriter>(path, spec, options);
}

}  // namespace ilot
