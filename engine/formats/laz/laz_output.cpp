// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/laz_output.h"

#include "engine/error.h"
#include "engine/formats/las/las_header.h"

namespace ilot {
namespace {

void mark_compressed(std::vector<std::byte>& header) {
  header[las::kFormat] |= std::byte{0x80};
}

}  // namespace

laz::Compression compression_of(const LasPlan& plan, std::uint32_t chunk_points) {
  laz::Compression compression;
  compression.layout = {plan.layout.point_format, plan.layout.record_length,
                        static_cast<std::uint8_t>(plan.layout.point_format >= 6 ? 3 : 2)};
  compression.chunk_size = chunk_points;
  return compression;
}

LazOutput::LazOutput(const std::filesystem::path& path, LasPlan plan, const laz::Compression& compression)
    : file_(path), plan_(std::move(plan)), compression_(compression) {
  plan_.vlrs.push_back(
      {laz::kLaszipUserId, laz::kLaszipRecordId, "compressed points", laz::laszip_record(compression_)});
  std::vector<std::byte> prefix = las_prefix(plan_);
  mark_compressed(prefix);
  mark_compressed(plan_.header);
  point_offset_ = prefix.size();
  file_.append(prefix);
  file_.append(std::vector<std::byte>(8));  // space for the place of the table, which is written later
}

void LazOutput::append(std::span<const std::byte> chunk, const PointStatistics& statistics) {
  if (chunk.size() > UINT32_MAX) {
    throw Error(file_.path().string() + ": a chunk grew beyond 4 GiB; write smaller chunks");
  }
  chunks_.push_back({statistics.count, static_cast<std::uint32_t>(chunk.size())});
  statistics_.merge(statistics);
  file_.append(chunk);
}

void LazOutput::finish() {
  const std::uint64_t table = file_.position();
  file_.append(laz::encode_chunk_table(chunks_, compression_.chunk_size == laz::kVariableChunks));
  std::byte place[8];
  store(place, table);
  file_.write_at(point_offset_, place);
  const std::uint64_t evlrs = file_.position();
  file_.append(las_suffix(plan_));
  finish_header(plan_, statistics_, evlrs);
  file_.write_at(0, plan_.header);
  file_.commit();
}

}  // namespace ilot
