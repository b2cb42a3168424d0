// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/laz_extender.h"

#include <algorithm>

#include "engine/error.h"
#include "engine/formats/laz/chunk_extender.h"

namespace ilot {
namespace {

// Limits for a chunk; a few decoded chunks are in memory.
constexpr std::uint64_t kMostPoints = 500'000, kMostBytes = std::uint64_t{32} << 20;

// A chunk that was found without the table may differ from the declaration in the record of the compression.
bool is_as_declared(const laz::ChunkPlace& chunk, const LazChunks& input) {
  const std::uint32_t size = input.compression.chunk_size;
  if (chunk.points > kMostPoints || chunk.points * input.compression.layout.record_length > kMostBytes) return false;
  return size == laz::kVariableChunks || chunk.points == size || chunk.first + chunk.points == input.index.points;
}

bool can_be_extended(const LazChunks& input, const CloudInfo& info) {
  return input.compression.layout.layered() && input.index.warning.empty() && info.points == info.declared_points &&
         std::all_of(input.index.chunks.begin(), input.index.chunks.end(),
                     [&](const laz::ChunkPlace& c) { return is_as_declared(c, input); });
}

}  // namespace

std::unique_ptr<LazExtender> LazExtender::open(const PointReader& input, const std::filesystem::path& path,
                                               const CloudSpec& spec) {
  const std::optional<LazChunks> chunks = laz_chunks(input);
  if (!chunks || spec.appended.empty() || !can_be_extended(*chunks, input.info())) return nullptr;
  LasPlan plan = plan_las(spec);
  laz::Compression compression = chunks->compression;
  compression.layout.record_length = plan.layout.record_length;
  return std::unique_ptr<LazExtender>(
      new LazExtender(*chunks, input.info().layout, path, std::move(plan), compression));
}

LazExtender::LazExtender(const LazChunks& input, const RecordLayout& before, const std::filesystem::path& path,
                         LasPlan plan, const laz::Compression& compression)
    : input_(input), before_(before), output_(path, std::move(plan), compression) {}

std::size_t LazExtender::appended_length() const {
  return std::size_t{output_.plan().layout.record_length} - before_.record_length;
}

LazExtender::Chunk LazExtender::extend(std::size_t chunk, std::span<const std::byte> records,
                                       std::span<const std::byte> appended) const {
  const laz::ChunkPlace& place = input_.index.chunks[chunk];
  std::vector<std::byte> bytes(place.bytes);
  Chunk out;
  if (input_.file.read_at(place.offset, bytes) != bytes.size() ||
      !laz::extend_chunk(input_.compression.layout, bytes, records, appended, out.bytes))
    throw Error(input_.file.path().string() + ": can no longer be read in full; the file changed during the run");
  out.statistics.add(records, before_);
  return out;
}

}  // namespace ilot
