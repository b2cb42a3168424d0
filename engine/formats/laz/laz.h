// SPDX-License-Identifier: Apache-2.0
// LAZ: LAS with compressed points, in chunks that decode independently. Reads every compressor and every version of
// its items; COPC files read like any other. Writes what LASzip writes for the same points, byte for byte.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "engine/formats/file.h"
#include "engine/formats/las/las_header.h"
#include "engine/formats/laz/chunk_index.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

// Takes a file that parse_las says is compressed. boundaries() are the chunks' first points. Reads are
// thread-safe, each with a decoder of its own from a pool (2 to 4 MB; for formats 6 to 10 the compressed chunk too); a
// read that goes on where another ended does not decode again. A damaged chunk ends a read before its first point; the
// next chunk can be read again. Files without a table of chunks (unfinished, cut off) are scanned for whole
// chunks when opened; those of one single stream (compressor 1) are always decoded once, and are not random
// access. Throws Error when no point can be read.
std::unique_ptr<PointReader> open_laz(std::unique_ptr<InputFile> file, LasContainer container);

// How the points of an opened file stand in it. Lives as long as the reader.
struct LazChunks {
  const InputFile& file;
  const laz::Compression& compression;
  const laz::ChunkIndex& index;
};
// Of a reader that open_laz made; none of any other.
std::optional<LazChunks> laz_chunks(const PointReader& reader);

struct LazOptions {
  std::uint32_t chunk_points = 50000;  // fewer of rows beyond 335 bytes: 16 MiB a chunk
};

// Rows in order; batches of chunks are compressed in parallel. Keeps two chunks of rows per thread and their encoders,
// but no more than 32 MiB beyond the first.
std::unique_ptr<PointWriter> create_laz(const std::filesystem::path& path, const CloudSpec& spec,
                                        const LazOptions& options = {});

}  // namespace ilot
