// SPDX-License-Identifier: Apache-2.0
// Rows are read, labelled and written one buffer at a time. A record has up to 65,535 bytes, so buffers are bounded in
// bytes and not in rows.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ilot {

// Large enough that the cost of a call, a lock or a chunk is negligible.
constexpr std::size_t kRowBytes = std::size_t{4} << 20;

// Returns the number of rows of `record_length` > 0 bytes in a buffer: at most `most` rows, at most `bytes` bytes, but
// at least one row.
inline std::size_t rows_at_a_time(std::size_t record_length, std::size_t most = 1u << 16,
                                  std::size_t bytes = kRowBytes) {
  return std::clamp<std::size_t>(bytes / record_length, 1, most);
}

}  // namespace ilot
