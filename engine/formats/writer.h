// SPDX-License-Identifier: Apache-2.0
// One way out: rows with a layout become a file, which appears whole under its name at finish() or not at all.
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

// What a file is to hold. Start from the input's CloudInfo to keep its header fields, VLRs and extra bytes.
struct CloudSpec {
  CloudInfo like;                    // header fields, VLRs, CRS and layout of the rows as given to write()
  std::vector<ExtraField> appended;  // ours: behind the input's extra bytes; offsets are filled in by the writer
  std::string software;              // "generating software" of LAS
  // Most that rows may take while they wait to be compressed together; never less than one chunk. No result depends on
  // it.
  std::uint64_t waiting_bytes = std::uint64_t{256} << 20;
};

class PointWriter {
 public:
  virtual ~PointWriter() = default;

  // Bytes of one row: like.layout.record_length plus the appended fields.
  virtual std::size_t record_length() const = 0;

  // Appends rows. Called in order by one thread; compression below may be parallel.
  virtual void write(std::span<const std::byte> records) = 0;

  // Patches counts and bounds, flushes, checks every write and renames into place. Without it nothing appears.
  virtual void finish() = 0;
};

// What labelled clouds are written as, and the memory that writing so many rows takes at least: a chunk of them, as it
// is and compressed, and its encoder.
constexpr const char* kCloudExtension = ".laz";
std::uint64_t cloud_writer_bytes(const RecordLayout& layout, std::uint64_t rows);

// By extension; .copc.laz is one, and the only one that does not keep the rows in order. Throws Error when the format
// is not one we write, with the list of those we do.
std::unique_ptr<PointWriter> create_cloud(const std::filesystem::path& path, const CloudSpec& spec);

// The name of a cloud without folder and extension; never ends in .copc, so that an extension can follow.
std::string cloud_stem(const std::filesystem::path& path);

// Names of what rows of this layout hold and a file of that extension cannot (opaque extra bytes, waveforms).
std::vector<std::string> fields_lost(const std::filesystem::path& path, const RecordLayout& layout);

}  // namespace ilot
