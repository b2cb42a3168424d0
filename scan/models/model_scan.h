// SPDX-License-Identifier: Apache-2.0
// Scans a model that somebody made, with any number of scanners at once, into one cloud with its truth.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scan/models/model_places.h"
#include "scan/models/model_stage.h"
#include "scan/models/pulse_plan.h"
#include "scan/scenes.h"

namespace ilot::scan {

std::span<const SceneOption> model_options();

// The scanners of a scan. An empty path means that they are placed automatically. Without any of the three, stations
// are placed automatically.
struct ModelScanners {
  std::optional<std::filesystem::path> stations;  // as `ilot run --stations` reads them
  std::optional<std::filesystem::path> vehicle;   // places of the heads one after the other, in the same form
  bool flight = false;
};

struct ModelScan {
  ModelStage stage;
  std::vector<StationParams> stations;
  std::optional<VehicleParams> vehicle;
  std::optional<FlightParams> flight;
  ScannerBeam station_beam, vehicle_beam, flight_beam;
  double registration = 0;     // metres: standard deviation of each station's position, per axis
  double grid = 0.0001;        // metres per coordinate unit
  double intensity_noise = 0;  // standard deviation, as a share of the intensity
  std::uint64_t seed = 0;
  std::vector<std::string> notes;  // what was assumed and where scanners stand, for people
};

// Reads the model and places the scanners. Throws Error.
ModelScan plan_model_scan(const ModelInput& input, const ModelScanners& scanners, const SceneValues& values,
                          std::uint64_t seed);

// Scales angular steps, distances between profiles and the density of flights by one factor, so that the scan gives
// about this number of points. It first counts a sparse scan. Within about 2 % from 100,000 points on.
void fit_points(ModelScan& scan, std::uint64_t points);

// Scans one scanner after the other and passes records of coloured_layout() to `take` in order. Grains are scanned in
// parallel, in batches of bounded size. The result does not depend on the number of threads. Returns how many pulses
// met each element first, by id.
std::vector<std::uint64_t> scan_model(const ModelScan& scan,
                                      const std::function<void(std::span<const std::byte>)>& take);

// Scans into a cloud, its truth and, where there are stations, their file. Each file is written whole or not at all.
// `request.scene` is not used. Throws Error.
ScanCounts write_model_scan(ModelScan& scan, const ModelInput& input, const ScanRequest& request);

}  // namespace ilot::scan
