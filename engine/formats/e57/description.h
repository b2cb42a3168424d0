// SPDX-License-Identifier: Apache-2.0
// The description of the scans in the XML section of an E57 file.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernels/core/types.h"

namespace ilot::e57 {

// The fields of a point that are read.
enum Use : std::size_t {
  kX,
  kY,
  kZ,
  kRange,
  kAzimuth,
  kElevation,
  kCartesianState,
  kSphericalState,
  kIntensity,
  kIntensityState,
  kRed,
  kGreen,
  kBlue,
  kColourState,
  kRow,
  kColumn,
  kReturnIndex,
  kReturnCount,
  kTime,
  kTimeState,
  kNormalX,
  kNormalY,
  kNormalZ,
  kUses
};

enum class Coding : std::uint8_t { f32, f64, integer, text };

struct Range {
  double low = 0, high = 0;
};

// One stream of a scan. For integers value = (minimum + stored) * scale + offset.
struct Field {
  std::string name;
  Coding coding = Coding::f64;
  std::size_t use = kUses;  // kUses: not read
  unsigned bits = 64;       // per point, 0 to 64
  std::int64_t minimum = 0;
  double scale = 1, offset = 0;
  std::optional<Range> range;  // of the values, when the file gives it
};

// world = rotation * local + translation
struct Pose {
  std::array<Vec3, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // rows
  Vec3 translation;
};

struct Scan {
  std::string name;
  std::uint64_t declared = 0;  // points
  std::uint64_t points = 0;    // that are complete; the reader counts them
  std::uint64_t section = 0;   // physical place of the points
  std::vector<Field> fields;
  std::array<std::optional<std::size_t>, kUses> places;  // index in fields
  std::optional<Pose> pose;
  Range intensity{0, 1};
  std::array<Range, 3> colour{{{0, 255}, {0, 255}, {0, 255}}};
  std::string problem;  // why the points cannot be read; empty when they can

  bool has(Use use) const { return places[use].has_value(); }
  bool cartesian() const { return has(kX) && has(kY) && has(kZ); }
  bool spherical() const { return has(kRange) && has(kAzimuth) && has(kElevation); }
};

struct Description {
  std::vector<Scan> scans;
  std::string coordinates;  // WKT, or empty
  std::vector<std::string> warnings;
};

// Throws Error that names the file when the XML is not well-formed or not E57. A scan that cannot be interpreted gets a
// problem. O(bytes).
Description parse_description(const std::filesystem::path& path, const std::string& xml);

}  // namespace ilot::e57
