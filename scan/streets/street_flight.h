// SPDX-License-Identifier: Apache-2.0
// The scene `street-air`: the street of the scene `street` and the gardens behind its houses, scanned from flight
// lines.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "scan/scanners/airborne.h"
#include "scan/streets/street_scan.h"

namespace ilot::scan {

std::span<const SceneOption> street_flight_options();

struct StreetFlight {
  StreetParams street;
  AirborneParams flight;
  double noise = 0.02;    // metres, standard deviation of the range
  double gardens = 4;     // objects behind the houses, per block and side
  double mirrored = 0.6;  // share of the pulses that the darkest paint of a car mirrors away
};

StreetFlight plan_street_flight(const SceneValues& values, std::uint64_t seed);

// Makes the street of scan_street with its gardens.
StreetStage set_stage(const StreetFlight& flight);

// Chooses the density that gives about this number of points.
void fit_points(StreetFlight& flight, const StreetStage& stage, std::uint64_t points);

// Passes records of coloured_layout(0.001) to `take`, up to the far end of the gardens. Glass mirrors two thirds of the
// pulses away. The paint of one car in three mirrors a share of its own away, which is drawn evenly up to `mirrored`.
// Tiles are scanned in parallel, in batches of bounded size. The result does not depend on the threads.
void scan_street_flight(const StreetFlight& flight, const StreetStage& stage,
                        const std::function<void(std::span<const std::byte>)>& take);

// Writes the cloud and NAME.truth.json.
ScanCounts scan_street_flight_scene(const ScanRequest& request);

}  // namespace ilot::scan
