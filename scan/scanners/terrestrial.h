// SPDX-License-Identifier: Apache-2.0
// Scenes that are scanned from tripods: their parts with the truth about them, and the scan, which runs in grains of
// fixed size.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernels/geometry/box3.h"
#include "scan/optics/part_scene.h"
#include "scan/scanners/beam.h"
#include "scan/scanners/echo_point.h"
#include "scan/scanners/station.h"
#include "scan/scenes.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

struct TerrestrialScene {
  SceneModel model;
  std::map<int, std::string> classes;
  // Counts of points are filled in after the scan; planes and shapes share their ids.
  std::vector<TruePlane> planes;
  std::vector<TrueShape> shapes;
  std::vector<TrueElement> elements;
  std::vector<TrueOpening> openings;
  std::vector<TrueControlPoint> control_points;
  std::vector<TrueBuilding> buildings;
  std::vector<StationParams> stations;
  Box3<Vec3> keep;  // points outside are removed, as an office cuts a facade out of its scan
};

struct TerrestrialScan {
  TerrestrialScene scene;
  BeamParams beam;
  double registration = 0;  // metres: standard deviation of each station's position, per axis; its points move with it
  double grid = 0.0001;     // metres per coordinate unit
  std::uint64_t seed = 0;
};

// Returns a scan without a scene, from the options that all terrestrial scenes share.
TerrestrialScan empty_scan(const SceneValues& values, std::uint64_t seed);

// Scales all angular steps so that the scan gives about this number of points. To do so, it first counts a sparse scan
// of the same scene. The result is within about 1 % from 100,000 points on.
void fit_points(TerrestrialScan& scan, std::uint64_t points);

// Scans the stations one after the other, each from left to right, and passes the records of coloured_layout() to
// `take` in order. Grains of a fixed number of pulses are scanned in parallel, in batches of bounded size, on the
// threads of the calling arena. The result does not depend on the number of threads.
void scan_terrestrial(const TerrestrialScan& scan, const std::function<void(std::span<const std::byte>)>& take);

// Scans into a cloud and its truth. Each file is written whole or not at all. Memory does not grow with the points.
// Throws Error.
ScanCounts write_terrestrial(const TerrestrialScan& scan, const ScanRequest& request);

// Makes the entry of a terrestrial scene in the table of scenes from the function that plans it.
template <TerrestrialScan (*plan)(const SceneValues& values, std::uint64_t seed)>
ScanCounts scan_planned(const ScanRequest& request) {
  TerrestrialScan scan = plan(request.values, request.seed);
  if (request.points) fit_points(scan, *request.points);
  return write_terrestrial(scan, request);
}

}  // namespace ilot::scan
