// SPDX-License-Identifier: Apache-2.0
// The parts of a LAZ file around the chunks: the LASzip record and the table of chunks. It works in memory only.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

constexpr std::uint32_t kVariableChunks = 0xFFFFFFFF;
constexpr std::uint32_t kDefaultChunkSize = 50000;  // points
constexpr std::uint16_t kLaszipRecordId = 22204;
constexpr const char* kLaszipUserId = "laszip encoded";

struct Compression {
  ChunkLayout layout;
  bool one_stream = false;                       // compressor 1: there are no chunks and no table
  std::uint32_t chunk_size = kDefaultChunkSize;  // points; kVariableChunks: the table gives the sizes
};

// Reads the payload of a LASzip record and compares it with the header's point format and record length. On failure
// `problem` gives the reason, as the continuation of "its LASzip record ".
struct ParsedCompression {
  Compression compression;
  std::string problem;
};
ParsedCompression parse_laszip_record(std::span<const std::byte> payload, std::uint8_t point_format,
                                      std::uint16_t record_length);

// Returns the payload that describes to readers how chunks of this layout are written.
std::vector<std::byte> laszip_record(const Compression& compression);

struct ChunkEntry {
  std::uint64_t points = 0;  // 0 in a decoded table of fixed chunks
  std::uint32_t bytes = 0;
};

// Decodes a table that starts at table[0] (8 bytes of version and count, then a stream). `most` bounds the count before
// memory is allocated. The result is empty with ok == false when the table is damaged.
struct ChunkTable {
  std::vector<ChunkEntry> chunks;
  bool ok = false;
};
ChunkTable decode_chunk_table(std::span<const std::byte> table, bool variable, std::uint64_t most);

std::vector<std::byte> encode_chunk_table(std::span<const ChunkEntry> chunks, bool variable);

}  // namespace ilot::laz
