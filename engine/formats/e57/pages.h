// SPDX-License-Identifier: Apache-2.0
// An E57 file is a sequence of pages, each of which ends in its own checksum. Places in the file are of two kinds:
// physical (checksums counted) and logical (checksums not counted).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/formats/file.h"

namespace ilot::e57 {

constexpr std::size_t kChecksum = 4;  // bytes at the end of each page, big endian

// CRC-32C (Castagnoli), reflected; initial and final value are all ones. O(bytes), eight bytes a step.
std::uint32_t crc32c(std::span<const std::byte> bytes);

// Reads logical bytes and tests every page that it reads. Keeps a window of 128 KiB. The file must outlive it; for one
// thread.
class Pages {
 public:
  // page_size is a power of two from 256 to 65536.
  Pages(const InputFile& file, std::size_t page_size);

  std::uint64_t size() const { return pages_ * payload_; }  // logical bytes in whole pages

  // nullopt when the place is in a checksum or behind the last complete page.
  std::optional<std::uint64_t> logical(std::uint64_t physical) const;

  // False when a page is missing or damaged; the content of `out` is then undefined.
  bool read(std::uint64_t offset, std::span<std::byte> out);

  // Frees the window; the next read allocates a new one.
  void release();

  // Returns the physical place of the page at which the last read failed.
  std::uint64_t failed_at() const { return failed_ * page_size_; }

 private:
  bool fill(std::uint64_t page);

  const InputFile* file_;
  std::size_t page_size_, payload_;
  std::uint64_t pages_;
  std::uint64_t first_ = 0, count_ = 0, failed_ = 0;  // pages in the window
  std::vector<std::byte> window_;
};

}  // namespace ilot::e57
