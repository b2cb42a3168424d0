// SPDX-License-Identifier: Apache-2.0
// Writes a LAZ file again with our fields appended to its rows. The streams of its own attributes are copied unchanged
// and only those of the new fields are coded. This takes a fraction of the time for decoding and encoding everything.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/laz/laz.h"
#include "engine/formats/laz/laz_output.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

class LazExtender {
 public:
  // `spec` has fields that are appended to the rows of the input. Returns null when streams cannot be copied: for
  // formats other than LAZ, point formats 0 to 5, files of which not all declared points can be read, and chunks of
  // more than 500,000 points. `input` must outlive it.
  static std::unique_ptr<LazExtender> open(const PointReader& input, const std::filesystem::path& path,
                                           const CloudSpec& spec);

  // Returns the bytes of the new fields of a row.
  std::size_t appended_length() const;

  struct Chunk {
    std::vector<std::byte> bytes;
    PointStatistics statistics;
  };
  // Returns the chunk of that number; there is one chunk between each two neighbouring boundaries() of the input.
  // Thread-safe. `records` are its rows, decoded at least up to their heights (kFieldZ). `appended` has as many rows of
  // appended_length() bytes. Throws Error when the input has changed since it was opened.
  Chunk extend(std::size_t chunk, std::span<const std::byte> records, std::span<const std::byte> appended) const;

  // Takes chunks in order from one thread. No file appears before finish().
  void append(const Chunk& chunk) { output_.append(chunk.bytes, chunk.statistics); }
  void finish() { output_.finish(); }

 private:
  LazExtender(const LazChunks& input, const RecordLayout& before, const std::filesystem::path& path, LasPlan plan,
              const laz::Compression& compression);

  LazChunks input_;
  RecordLayout before_;
  LazOutput output_;
};

}  // namespace ilot
