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

// Returns the layout: point format 6 with the extra bytes true_class u8 and true_plane u32.
RecordLayout scan_layout();

// Reads true_plane of a record in that layout.
std::uint32_t true_plane_of(const std::byte* record);

// One echo of a pulse.
struct Return {
  double range = 0;  // metres, without noise
  Surface surface = Surface::ground;
  std::uint32_t plane = 0;  // true_plane: 0 = none
};

constexpr std::uint32_t kGroundPlane = 1;

// Traces the pulses that are aimed at one cell. It keeps a view of the cell. Each thread needs its own tracer.
class CellTracer {
 public:
  // Plane p of the cell gets the id first_plane + p.
  CellTracer(const Cell& cell, const Ground& ground, std::uint32_t first_plane);

  // Finds the echoes of one pulse, nearest first. There is at least one. `rng` decides what crowns let through.
  void trace(const Ray& ray, Rng& rng, std::vector<Return>& returns);

 private:
  const Cell& cell_;
  std::uint32_t first_plane_;
  RayScene scene_;
  PulseTracer tracer_;
  std::vector<PulseEcho> echoes_;
};

// Returns the records of all pulses that are aimed at the cell, in the order of the flight plan. Echoes of a pulse are
// nearest first. `noise` is the standard deviation of the range in metres.
std::vector<std::byte> scan_cell(const Cell& cell, const FlightPlan& flight, const Ground& ground,
                                 std::uint32_t first_plane, double noise);

}  // namespace ilot::scan
