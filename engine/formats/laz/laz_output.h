// SPDX-License-Identifier: Apache-2.0
// The parts of a LAZ output around the chunks: header, VLRs, the table of chunks. All code that makes chunks uses it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/laz/chunk_table.h"

namespace ilot {

// Returns the compression of a planned output: the default of LASzip for its rows.
laz::Compression compression_of(const LasPlan& plan, std::uint32_t chunk_points);

class LazOutput {
 public:
  // `compression.layout` is that of the plan's rows. Writes everything before the chunks.
  LazOutput(const std::filesystem::path& path, LasPlan plan, const laz::Compression& compression);

  const LasPlan& plan() const { return plan_; }

  // Appends the next chunk; `statistics` are what its rows add to the header. Throws Error when the chunk exceeds 4
  // GiB.
  void append(std::span<const std::byte> chunk, const PointStatistics& statistics);

  // Writes the table, EVLRs and the header, and renames the file to its final name. No file appears before that.
  void finish();

 private:
  OutputFile file_;
  LasPlan plan_;
  laz::Compression compression_;
  std::uint64_t point_offset_ = 0;
  std::vector<laz::ChunkEntry> chunks_;
  PointStatistics statistics_;
};

}  // namespace ilot
