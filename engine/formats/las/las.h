// SPDX-License-Identifier: Apache-2.0
// LAS 1.0 to 1.4, not compressed, point formats 0 to 10.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>

#include "engine/formats/file.h"
#include "engine/formats/las/las_header.h"
#include "engine/formats/las/las_plan.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

// Takes a file that parse_las found to be uncompressed. Random access; each read is one pread without state.
std::unique_ptr<PointReader> open_las(std::unique_ptr<InputFile> file, LasContainer container);

// Fills one LAS file from several threads. Every row is written once, at any place. Each thread measures its rows with
// its own PointStatistics (add takes layout()). The merged statistics are passed to finish(). No file appears before
// that.
class LasFileWriter {
 public:
  LasFileWriter(const std::filesystem::path& path, const CloudSpec& spec);

  const RecordLayout& layout() const { return plan_.layout; }
  std::size_t record_length() const { return plan_.layout.record_length; }

  // Thread-safe. `records` is a multiple of record_length(). The rows are written to [first_row, first_row + rows).
  void write_at(std::uint64_t first_row, std::span<const std::byte> records);

  // Writes EVLRs and header and renames the file to its final name. Throws Error when statistics.count is not the
  // number of rows written.
  void finish(const PointStatistics& statistics);

 private:
  OutputFile file_;
  LasPlan plan_;
  std::uint64_t point_offset_ = 0;
  std::atomic<std::uint64_t> rows_{0};
};

// Writes rows in order and measures the statistics at the same time.
std::unique_ptr<PointWriter> create_las(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
