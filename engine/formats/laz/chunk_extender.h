// SPDX-License-Identifier: Apache-2.0
// Appends bytes to the records of a layered chunk without coding the chunk again. Its streams are independent, so they
// are copied unchanged, and only those of the new bytes are coded. It works in memory only.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

// `layout` is that of the chunk as it is. `records` are those of the chunk, decoded with any fields (the scanner
// channel is used). `appended` has one row of equal length for each of them, at least one row. Appends to out the chunk
// of the longer records. It is byte for byte what ChunkEncoder gives for them if `chunk` came from ChunkEncoder.
// Returns false and appends nothing when the chunk does not contain that many points or is not layered. O(appended
// bytes).
bool extend_chunk(const ChunkLayout& layout, std::span<const std::byte> chunk, std::span<const std::byte> records,
                  std::span<const std::byte> appended, std::vector<std::byte>& out);

}  // namespace ilot::laz
