// SPDX-License-Identifier: Apache-2.0
// A LAZ file again with our fields behind its rows. The streams of its own attributes are copied as they stand and only
// those of the new fields are coded, which takes a fraction of the time of decoding and encoding everything.
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
  // `spec` with fields appended to the input's rows. Null where streams cannot be copied: formats other than LAZ, point
  // formats 0 to 5, files of which not all declared points can be read, chunks of more than 500,000 points. `input`
  // must outlive it.
  static std::unique_ptr<LazExtender> open(const PointReader& input, const std::filesystem::path& path,
                                           const CloudSpec& spec);

  // Bytes of a row's new fields.
  std::size_t appended_length() const;

  struct Chunk {
    std::vector<std::byte> bytes;
    PointStatistics statistics;
  };
  // The chunk of that number, one for each two boundaries() of the input. Thread-safe. `records`: its rows, decoded at
  // least to their heights (kFieldZ); `appended`: as many rows of appended_length() bytes. Throws Error when the input
  // has changed since it was opened.
  Chunk extend(std::size_t chunk, std::span<const std::byte> records, std::span<const std::byte> appended) const;

  // Chunks in order, by one thread; nothing appears before finish().
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
