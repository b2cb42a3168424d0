// SPDX-License-Identifier: Apache-2.0
// The position of the scenes on the French national grid, and the record format of the points of coloured scenes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/formats/writer.h"
#include "scan/optics/material.h"

namespace ilot::scan {

// World coordinates of the origin of every scene, on the French national grid (EPSG:2154).
constexpr double kEastOrigin = 651000, kNorthOrigin = 6861000;
constexpr Vec3 kSceneOrigin{kEastOrigin, kNorthOrigin, 0};

// EPSG:2154.
Crs lambert_93();

// Where a scene is in the world: its origin in whole metres, and its CRS. An unknown CRS has neither wkt nor epsg.
struct ScenePlace {
  Vec3 origin = kSceneOrigin;
  Crs crs = lambert_93();
};

// Returns the layout: point format 7 (RGB) with the extra bytes true_class u8, true_plane u32 and true_element u32. The
// user data contain the true material. `grid` is in metres per coordinate unit.
RecordLayout coloured_layout(double grid, Vec3 origin = kSceneOrigin);

// Returns the same layout without colours: point format 6.
RecordLayout uncoloured_layout(double grid);

// Returns the specification of a cloud for records of that layout.
CloudSpec cloud_spec(const RecordLayout& layout, const Crs& crs = lambert_93());

inline constexpr std::size_t kGpsTime = 22;  // byte of the GPS time in point formats 6 and 7

struct ColouredPoint {
  Vec3 place;  // metres in the scene
  std::uint16_t intensity = 0;
  std::uint8_t return_number = 1, return_count = 1;
  std::uint8_t classification = 0;  // ASPRS
  std::uint16_t source = 0;
  double scan_angle_deg = 0;
  double gps_time = 0;
  Rgb16 rgb{};
  std::uint8_t material = 0;  // user data: 1 + Material, 0 = none
  std::uint8_t true_class = 0;
  std::uint32_t true_plane = 0, true_element = 0;
};

// Appends a record of either layout.
void append_record(std::vector<std::byte>& records, const ColouredPoint& point, const RecordLayout& layout);

// The truth in a record of that layout.
struct RecordTruth {
  std::uint8_t true_class = 0;
  std::uint32_t true_plane = 0, true_element = 0;
};
RecordTruth truth_of(const std::byte* record, const RecordLayout& layout);

// Returns the position of the record, in metres in the scene.
Vec3 place_of(const std::byte* record, const RecordLayout& layout);

}  // namespace ilot::scan
