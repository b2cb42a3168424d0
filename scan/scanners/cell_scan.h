// SPDX-License-Identifier: Apache-2.0
// One cell of a district seen by the scanner: its points as LAS records.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/cloud/record.h"
#include "scan/districts/district.h"
#include "scan/scanners/airborne.h"
#include "scan/scanners/pulse_tracer.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {

// Point format 6 with the extra bytes true_class u8 and true_plane u32.
RecordLayout scan_layout();

// Reads true_plane of a record of that layout.
std::uint32_t true_plane_of(const std::byte* record);

// One echo of a pulse.
struct Return {
  double range = 0;  // metres, without noise
  Surface surface = Surface::ground;
  std::uint32_t plane = 0;  // true_plane: 0 = none
};

constexpr std::uint32_t kGroundPlane = 1;

// Traces the pulses aimed at one cell. Keeps a view of the cell; several threads need a tracer each.
class CellTracer {
 public:
  // The cell's plane p bears the id first_plane + p.
  CellTracer(const Cell& cell, const Ground& ground, std::uint32_t first_plane);

  // The echoes of one pulse, nearest first, at least one. `rng` decides what crowns let through.
  void trace(const Ray& ray, Rng& rng, std::vector<Return>& returns);

 private:
  const Cell& cell_;
  std::uint32_t first_plane_;
  RayScene scene_;
  PulseTracer tracer_;
  std::vector<PulseEcho> echoes_;
};

// Records of all the pulses aimed at the cell, in the order of the flight plan, echoes of a pulse nearest
// first. noise: standard deviation of the range in metres.
std::vector<std::byte> scan_cell(const Cell& cell, const FlightPlan& flight, const Ground& ground,
                                 std::uint32_t first_plane, double noise);

}  // namespace ilot::scan
