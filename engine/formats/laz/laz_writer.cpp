// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "engine/error.h"
#include "engine/formats/laz/laz.h"
#include "engine/formats/laz/laz_output.h"
#include "engine/formats/row_buffer.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

// Chunks of rows longer than 335 bytes have fewer rows, so that a chunk needs no more than this.
constexpr std::size_t kChunkBytes = std::size_t{16} << 20;

std::uint32_t rows_per_chunk(const RecordLayout& layout, std::uint32_t chunk_points) {
  return static_cast<std::uint32_t>(rows_at_a_time(layout.record_length, chunk_points, kChunkBytes));
}

// The data for encoding one chunk of a batch.
struct Slot {
  explicit Slot(const laz::ChunkLayout& layout) : encoder(layout) {}
  laz::ChunkEncoder encoder;
  std::vector<std::byte> bytes;
  PointStatistics statistics;
};

class LazWriter final : public PointWriter {
 public:
  LazWriter(const std::filesystem::path& path, const CloudSpec& spec, const LazOptions& options)
      : LazWriter(path, plan_las(spec), options, spec.waiting_bytes) {}

  std::size_t record_length() const override { return layout().record_length; }

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
    output_.finish();
  }

 private:
  LazWriter(const std::filesystem::path& path, const LasPlan& plan, const LazOptions& options,
            std::uint64_t waiting_bytes)
      : LazWriter(path, plan, compression_of(plan, rows_per_chunk(plan.layout, options.chunk_points)), waiting_bytes) {}

  LazWriter(const std::filesystem::path& path, const LasPlan& plan, const laz::Compression& compression,
            std::uint64_t waiting_bytes)
      : output_(path, plan, compression),
        chunk_bytes_(std::size_t{compression.chunk_size} * plan.layout.record_length) {
    const std::uint64_t each = 2 * chunk_bytes_ + laz::encoder_bytes(compression.layout);  // rows, raw and coded
    const auto slots =
        std::clamp<std::uint64_t>(waiting_bytes / each, 1, 2 * static_cast<std::uint64_t>(thread_count()));
    for (std::uint64_t i = 0; i < slots; ++i) slots_.emplace_back(compression.layout);
    pending_.reserve(chunk_bytes_ * slots_.size());  // growth would need twice the memory
  }

  const RecordLayout& layout() const { return output_.plan().layout; }

  void flush() {
    const std::size_t chunks = (pending_.size() + chunk_bytes_ - 1) / chunk_bytes_;
    parallel_for(chunks, [&](std::size_t i) { encode(slots_[i], i); });
    for (std::size_t i = 0; i < chunks; ++i) output_.append(slots_[i].bytes, slots_[i].statistics);
    pending_.clear();
  }

  void encode(Slot& slot, std::size_t chunk) const {
    const std::size_t begin = chunk * chunk_bytes_;
    const auto rows = std::span(pending_).subspan(begin, std::min(chunk_bytes_, pending_.size() - begin));
    slot.bytes.clear();
    slot.encoder.encode(rows, slot.bytes);
    slot.statistics = {};
    slot.statistics.add(rows, layout());
  }

  LazOutput output_;
  std::size_t chunk_bytes_;
  std::vector<Slot> slots_;
  std::vector<std::byte> pending_;
};

}  // namespace

std::uint64_t cloud_writer_bytes(const RecordLayout& layout, std::uint64_t rows) {
  const laz::ChunkLayout chunk{layout.point_format, layout.record_length};
  const std::uint64_t most = std::min<std::uint64_t>(rows, rows_per_chunk(layout, LazOptions().chunk_points));
  return laz::encoder_bytes(chunk) + 2 * most * layout.record_length;
}

std::unique_ptr<PointWriter> create_laz(const std::filesystem::path& path, const CloudSpec& spec,
                                        const LazOptions& options) {
  if (options.chunk_points == 0 || options.chunk_points == laz::kVariableChunks) {
    throw Error(path.string() + ": chunks need a fixed number of points", ExitCode::usage);
  }
  return std::make_unique<LazWriter>(path, spec, options);
}

}  // namespace ilot
