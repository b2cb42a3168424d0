// SPDX-License-Identifier: Apache-2.0
// What the targets of readers share: bytes become a file in memory, its rows are read to the end.
#pragma once
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "engine/error.h"
#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot::fuzz {

// Path of a file that holds these bytes, one per process and extension, overwritten each time. Empty on a fault.
inline std::string as_file(const std::uint8_t* data, std::size_t size, const std::string& extension) {
  const std::string path = "/dev/shm/ilot_fuzz_" + std::to_string(getpid()) + extension;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return "";
  const bool whole = std::fwrite(data, 1, size, file) == size;
  return std::fclose(file) == 0 && whole ? path : "";
}

// At most 20,000 rows, front to back in pieces of at most 100 and 1 MiB.
inline void read_rows(PointReader& reader) {
  const std::size_t length = reader.info().layout.record_length;
  const std::size_t piece = std::clamp<std::size_t>((std::size_t{1} << 20) / length, 1, 100);
  std::vector<std::byte> records(piece * length);
  std::vector<std::uint8_t> valid(piece);
  for (std::uint64_t first = 0; first < 20000;) {
    const std::size_t got = reader.read(first, records, valid);
    if (got > piece) __builtin_trap();
    first += got;
    if (got < piece) break;
  }
}

// Opens the bytes with one reader's own function and reads; faults of the input are Errors and nothing else.
template <class Open>
int read_bytes(const std::uint8_t* data, std::size_t size, const std::string& extension, Open open) {
  const std::string path = as_file(data, size, extension);
  if (path.empty()) return 0;
  try {
    read_rows(*open(std::make_unique<InputFile>(path)));
  } catch (const Error&) {
  }
  std::remove(path.c_str());
  return 0;
}

}  // namespace ilot::fuzz
