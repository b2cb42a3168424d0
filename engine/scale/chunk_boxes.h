// SPDX-License-Identifier: Apache-2.0
// Where the chunks of the inputs lie. A plan knows it, because it has seen all points, so that a task decodes only the
// chunks that its area needs, whatever the format.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/formats/rows_in_box.h"
#include "engine/store/partition.h"

namespace ilot {

constexpr const char* kChunksFolder = "chunks";  // of a plan: chunks/N has the chunks of input N, from 1

// The chunks of one input, front to back.
struct ChunkBoxes {
  std::vector<std::uint64_t> rows;  // at which chunks start, and the number of all rows
  std::vector<IndexBox> boxes;      // of the points that are in the store, lattice steps; none: the chunk has none

  std::size_t chunk_of(std::uint64_t row) const;
  IndexBox all() const;
};

// The chunks of inputs, with empty boxes. An input without random access is one chunk.
std::vector<ChunkBoxes> chunks_of(const std::vector<std::unique_ptr<PointReader>>& inputs);

// The rows of chunks that meet the box: ascending, neighbours merged.
std::vector<RowRange> rows_that_meet(const ChunkBoxes& chunks, const IndexBox& box);

void write_chunks(const std::filesystem::path& path, const ChunkBoxes& chunks);

// Throws Error where the file is missing or damaged.
ChunkBoxes read_chunks(const std::filesystem::path& path);

}  // namespace ilot
