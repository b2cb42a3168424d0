// SPDX-License-Identifier: Apache-2.0
// The one interface for writing: rows with a layout become a file, which appears complete under its name at finish() or
// not at all.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// The content of a file to write. Start from the input's CloudInfo to keep its header fields, VLRs and extra bytes.
struct CloudSpec {
  CloudInfo like;                    // header fields, VLRs, CRS and layout of the rows as given to write()
  std::vector<ExtraField> appended;  // our fields behind the input's extra bytes; the writer fills in their offsets
  std::string software;              // "generating software" of LAS
  // Greatest memory for rows that wait to be compressed together; never less than one chunk. No result depends on it.
  std::uint64_t waiting_bytes = std::uint64_t{256} << 20;
  std::uint64_t octree_bytes = std::uint64_t{1} << 30;  // COPC: greatest memory for its rows and 16 bytes for each
};

class PointWriter {
 public:
  virtual ~PointWriter() = default;

  // Returns the bytes of one row: like.layout.record_length plus the appended fields.
  virtual std::size_t record_length() const = 0;

  // Appends rows. It is called in order by one thread; the compression may run in parallel.
  virtual void write(std::span<const std::byte> records) = 0;

  // Corrects counts and bounds, flushes, checks every write and renames the file to its final name. Without it no file
  // appears.
  virtual void finish() = 0;
};

// The extension of labelled clouds, and the least memory for writing this number of rows: a chunk of them, uncompressed
// and compressed, and its encoder.
constexpr const char* kCloudExtension = ".laz";
std::uint64_t cloud_writer_bytes(const RecordLayout& layout, std::uint64_t rows);

// The extension selects the format. .copc.laz is one extension, and the only format that does not keep the order of the
// rows. Throws Error when ilot does not write the format; the text lists those that it writes.
std::unique_ptr<PointWriter> create_cloud(const std::filesystem::path& path, const CloudSpec& spec);

// Returns the name of a cloud without folder and extension. It never ends in .copc, so an extension can follow.
std::string cloud_stem(const std::filesystem::path& path);

// Returns the names of fields that rows of this layout have and a file of that extension cannot store (opaque extra
// bytes, waveforms).
std::vector<std::string> fields_lost(const std::filesystem::path& path, const RecordLayout& layout);

}  // namespace ilot
