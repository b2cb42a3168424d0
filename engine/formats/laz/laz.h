// SPDX-License-Identifier: Apache-2.0
// LAZ: LAS with compressed points, in chunks that can be decoded independently. It reads every compressor and every
// version of its items; COPC files are read like any other. It writes what LASzip writes for the same points, byte for
// byte.
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

// Takes a file that parse_las found to be compressed. boundaries() are the first points of the chunks. Reads are
// thread-safe; each uses a decoder of its own from a pool (2 to 4 MB; for formats 6 to 10 also the compressed chunk). A
// read that continues where another ended does not decode again. A damaged chunk ends a read before its first point;
// the next chunk can be read again. Files without a table of chunks (unfinished, cut off) are searched for whole chunks
// when they are opened. Files of one single stream (compressor 1) are always decoded once and are not random access.
// Throws Error when no point can be read.
std::unique_ptr<PointReader> open_laz(std::unique_ptr<InputFile> file, LasContainer container);

// The layout of the points in an opened file. It is valid as long as the reader.
struct LazChunks {
  const InputFile& file;
  const laz::Compression& compression;
  const laz::ChunkIndex& index;
};
// Returns the chunks of a reader that open_laz made; nullopt for any other reader.
std::optional<LazChunks> laz_chunks(const PointReader& reader);

struct LazOptions {
  std::uint32_t chunk_points = 50000;  // fewer for rows beyond 335 bytes: 16 MiB a chunk
};

// Rows are written in order; batches of chunks are compressed in parallel. Keeps two chunks of rows for each thread and
// their encoders, but no more than 32 MiB beyond the first.
std::unique_ptr<PointWriter> create_laz(const std::filesystem::path& path, const CloudSpec& spec,
                                        const LazOptions& options = {});

}  // namespace ilot
