// SPDX-License-Identifier: Apache-2.0
// Bytes behind the records of a layered chunk, without coding the chunk again: its streams are independent, so that
// they are copied as they stand, and only those of the new bytes are coded. Memory only.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

// `layout`: of the chunk as it is. `records`: those of the chunk, decoded with any fields (the scanner channel counts).
// `appended`: as many rows of as many bytes, at least one. Appends to out the chunk of the longer records, which is
// byte for byte what ChunkEncoder gives for them where `chunk` came from it. False, and nothing appended: the chunk
// does not hold that many points, or is not layered. O(appended bytes).
bool extend_chunk(const ChunkLayout& layout, std::span<const std::byte> chunk, std::span<const std::byte> records,
                  std::span<const std::byte> appended, std::vector<std::byte>& out);

}  // namespace ilot::laz
