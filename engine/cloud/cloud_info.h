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
  bool extended = false;       // it was stored behind the points (EVLR)
};

// What is known of a point cloud after it is opened and before its points are read. Declared values come from the
// header. They are never trusted: index and info measure them.
struct CloudInfo {
  std::filesystem::path path;
  std::string format;   // "las", "laz", "copc", "ply", "text", "pcd", "e57", "ptx"
  std::string dialect;  // text only, for people: separators, decimal point or comma; else empty
  std::uint8_t version_major = 1, version_minor = 4;
  RecordLayout layout;
  std::uint64_t declared_points = 0;
  std::uint64_t points = 0;  // number that can really be read
  Vec3 declared_min, declared_max;
  std::vector<std::byte> header;  // LAS family: the public header block verbatim; else empty
  std::vector<Vlr> vlrs;
  Crs crs;
  std::vector<Station> stations;
  std::vector<ScanPart> scans;        // for formats that contain several scans; else empty
  std::vector<std::string> warnings;  // irregularities that do not stop the run; points < declared_points after salvage
};

}  // namespace ilot
