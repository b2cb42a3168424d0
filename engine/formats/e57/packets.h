// SPDX-License-Identifier: Apache-2.0
// The points of a scan as E57 stores them: packets, each with a piece of the byte stream of every field.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/formats/e57/description.h"
#include "engine/formats/e57/pages.h"

namespace ilot::e57 {

// Gives the data packets of a scan in their order. Index packets and empty packets are skipped. One packet (at most 64
// KiB) is in memory. Pages and scan must outlive it.
class Packets {
 public:
  Packets(Pages& pages, const Scan& scan);

  // Gives one piece for each field, valid until the next call. False at the end of the section or at damage: see
  // problem().
  bool next(std::vector<std::span<const std::byte>>& pieces);

  const std::string& problem() const { return problem_; }
  std::uint64_t walked() const { return at_ - begin_; }  // logical bytes

 private:
  bool fail(const std::string& why);
  bool read_section(const Scan& scan);
  bool split(std::vector<std::span<const std::byte>>& pieces);

  Pages* pages_;
  std::size_t fields_;
  std::uint64_t begin_ = 0, at_ = 0, end_ = 0;  // logical
  std::vector<std::byte> packet_;
  std::string problem_;
};

struct Extent {
  std::uint64_t points = 0;  // that can be read
  std::string problem;       // why not all declared points can be read; empty when all can
};

// Reads the packets of a scan and tests their pages until the points are complete. Subtracts the bytes read from
// `budget` and stops when it is used up, because the sections of a sound file do not overlap. Also stops when more than
// 16 MiB would have to be in memory because one field runs ahead of another. O(bytes of the scan).
Extent measure_scan(Pages& pages, const Scan& scan, std::uint64_t& budget);

// Values of up to kBatch points, by use. NaN never means that a value is absent; use Scan::has for that.
constexpr std::size_t kBatch = 1024;
using Batch = std::array<std::array<double, kBatch>, kUses>;

// Decodes the first scan.points points of a scan, front to back.
class ScanReader {
 public:
  ScanReader(Pages& pages, const Scan& scan);

  // Decodes the next points, at most `most` and kBatch. Returns 0 at their end, or when the file has changed.
  std::size_t next(std::size_t most, Batch& batch);

  bool finished() const { return left_ == 0; }

 private:
  struct Stream {
    std::vector<std::byte> bytes;  // followed by kPadding bytes of zero
    std::uint64_t bit = 0;         // next bit, counted from the beginning of bytes
  };
  std::uint64_t available() const;
  void append(std::size_t field, std::span<const std::byte> piece);
  void decode(std::size_t field, std::size_t count, std::array<double, kBatch>& values);

  const Scan* scan_;
  Packets packets_;
  std::vector<Stream> streams_;
  std::vector<std::span<const std::byte>> pieces_;
  std::uint64_t left_;
};

}  // namespace ilot::e57
