// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/cloud/record.h"
#include "ilot/cloud_info.h"
#include "kernels/core/types.h"

namespace ilot {

// A variable-length record of a LAS file, kept verbatim so that it can be written back.
struct Vlr {
  std::string user_id;
  std::uint16_t record_id = 0;
  std::string description;
  std::vector<std::byte> payload;
  std::uint16_t reserved = 0;  // 0xAABB in old files
  bool extended = false;       // stood behind the points (EVLR)
};

// What is known of one point cloud after opening it and before reading its points. Declared values come from the
// header and are never trusted: index and info measure them.
struct CloudInfo {
  std::filesystem::path path;
  std::string format;   // "las", "laz", "copc", "ply", "text", "pcd", "e57", "ptx"
  std::string dialect;  // of text, for people: separators, decimal point or comma; else empty
  std::uint8_t version_major = 1, version_minor = 4;
  RecordLayout layout;
  std::uint64_t declared_points = 0;
  std::uint64_t points = 0;  // that can really be read
  Vec3 declared_min, declared_max;
  std::vector<std::byte> header;  // LAS family: the public header block verbatim; else empty
  std::vector<Vlr> vlrs;
  Crs crs;
  std::vector<Station> stations;
  std::vector<ScanPart> scans;        // of formats that hold several; else empty
  std::vector<std::string> warnings;  // oddities that do not stop the run; points < declared_points after salvage
};

}  // namespace ilot
