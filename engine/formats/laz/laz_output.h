// SPDX-License-Identifier: Apache-2.0
// What stands around the chunks of a LAZ output: header, VLRs, the table of chunks. Used by all that make chunks.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/laz/chunk_table.h"

namespace ilot {

// How a planned output is compressed: what LASzip does by default with its rows.
laz::Compression compression_of(const LasPlan& plan, std::uint32_t chunk_points);

class LazOutput {
 public:
  // `compression.layout` is that of the plan's rows. Writes all that stands before the chunks.
  LazOutput(const std::filesystem::path& path, LasPlan plan, const laz::Compression& compression);

  const LasPlan& plan() const { return plan_; }

  // The next chunk and what its rows add to the header. Throws Error when it exceeds 4 GiB.
  void append(std::span<const std::byte> chunk, const PointStatistics& statistics);

  // The table, EVLRs and the header; renames into place. Nothing appears before that.
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
