// SPDX-License-Identifier: Apache-2.0
// The places of the chunks in a file and the points that they contain.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/laz/chunk_table.h"

namespace ilot::laz {

struct ChunkPlace {
  std::uint64_t first = 0;  // number of the first point
  std::uint64_t points = 0;
  std::uint64_t offset = 0;  // in the file
  std::uint64_t bytes = 0;
};

struct ChunkIndex {
  std::vector<ChunkPlace> chunks;
  std::uint64_t points = 0;  // readable points: at most the declared ones
  std::string warning;       // empty when everything is as declared
};

// Finds the chunks of `declared` points from `begin` (the place of the points) on. Uses the table of chunks when it is
// plausible. Otherwise it searches for whole chunks, which decodes formats 0-5. Throws Error when that is impossible.
ChunkIndex index_chunks(const InputFile& file, std::uint64_t begin, std::uint64_t declared,
                        const Compression& compression);

}  // namespace ilot::laz
