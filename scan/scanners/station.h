// SPDX-License-Identifier: Apache-2.0
// A terrestrial scanner on its tripod: pulses in equal steps of azimuth and elevation.
#pragma once
#include <cstdint>
#include <vector>

#include "kernels/geometry/box3.h"
#include "scan/optics/exact_math.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// Angles in degrees, relative to the forward direction of the station. Azimuth is positive to the right, elevation
// upwards. |azimuth| < 180, |elevation| < 90.
struct AngleWindow {
  double left = 0, right = 0, low = 0, high = 0;
};

struct StationParams {
  std::uint16_t id = 1;  // point_source_id
  Vec3 position;
  Vec3 forward{0, 1, 0};  // horizontal, unit length
  double step_horizontal_deg = 0.03, step_vertical_deg = 0.03;
  AngleWindow window;
};

// Returns a station that looks at the middle of a box and scans all of it, up to 88 degrees above and below the
// horizon. The box must not contain the station.
StationParams station_towards(std::uint16_t id, Vec3 position, const Box3<Vec3>& target, double step_deg);

// The direction of a pulse: the axis of the beam and two directions perpendicular to it, all of unit length.
struct Aim {
  Vec3 axis, right, up;
};

// The pulses of a station: columns from left to right, rows upwards. The angles of a pulse are integer multiples of the
// steps and do not depend on the window.
class StationGrid {
 public:
  explicit StationGrid(const StationParams& params);

  std::uint64_t columns() const { return columns_; }
  std::uint64_t rows() const { return rows_.size(); }

  // The sine and cosine of the azimuth of a column are computed once for all its rows.
  SinCos azimuth(std::uint64_t column) const;
  Aim aim(const SinCos& azimuth, std::uint64_t row) const;

  // Returns a key that depends on the angles only and not on the window.
  std::uint64_t key(std::uint64_t column, std::uint64_t row) const;

 private:
  StationParams params_;
  Vec3 right_;
  std::int64_t first_column_ = 0, first_row_ = 0;
  std::uint64_t columns_ = 0;
  std::vector<SinCos> rows_;
};

}  // namespace ilot::scan
