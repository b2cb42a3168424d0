// SPDX-License-Identifier: Apache-2.0
// Scenes scanned from tripods: their parts with the truth about them, and the scan, streamed in grains of fixed size.
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
#include "scan/scanners/station.h"
#include "scan/scenes.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

// The value of true_class of points that hang between two surfaces. They have no plane and no element.
constexpr std::uint8_t kMixedClass = 0;

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
  Box3<Vec3> keep;  // what lies outside is cut off, as an office cuts a facade out of its scan
};

struct TerrestrialScan {
  TerrestrialScene scene;
  BeamParams beam;
  double registration = 0;  // metres: standard deviation of each station's place, per axis; its points move along
  double grid = 0.0001;     // metres per coordinate unit
  std::uint64_t seed = 0;
};

// A scan without a scene, from the options that all terrestrial scenes share.
TerrestrialScan empty_scan(const SceneValues& values, std::uint64_t seed);

// Scales all angular steps so that about so many points come out: a sparse scan of the same scene is counted first.
// Exact to about 1 % from 100,000 points on.
void fit_points(TerrestrialScan& scan, std::uint64_t points);

// Scans station after station, from left to right, and hands the records of coloured_layout() over in order. Grains of
// a fixed number of pulses are scanned in parallel, a batch of bounded size at a time, on the threads of the calling
// arena; what is handed over does not depend on their number.
void scan_terrestrial(const TerrestrialScan& scan, const std::function<void(std::span<const std::byte>)>& take);

// Scans into a cloud and its truth, each whole or not at all. Memory does not grow with the points. Throws Error.
ScanCounts write_terrestrial(const TerrestrialScan& scan, const ScanRequest& request);

// The entry in the table of scenes of a terrestrial scene, from the function that plans it.
template <TerrestrialScan (*plan)(const SceneValues& values, std::uint64_t seed)>
ScanCounts scan_planned(const ScanRequest& request) {
  TerrestrialScan scan = plan(request.values, request.seed);
  if (request.points) fit_points(scan, *request.points);
  return write_terrestrial(scan, request);
}

}  // namespace ilot::scan
