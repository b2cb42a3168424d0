// SPDX-License-Identifier: Apache-2.0
// The scene `street`: blocks on both sides of a straight street and the objects on its pavements, scanned from a
// vehicle.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "scan/scanners/mobile.h"
#include "scan/scanners/scan_record.h"
#include "scan/scenes.h"
#include "scan/streets/street_model.h"

namespace ilot::scan {

std::span<const SceneOption> street_options();

struct StreetScan {
  StreetParams street;
  MobileParams drive;  // its ends are computed from the street
};

StreetScan plan_street_scan(const SceneValues& values, std::uint64_t seed);

// All data that a scan needs.
struct StreetStage {
  Street street;
  std::vector<StreetObject> objects;
  StreetModel model;
};
StreetStage set_stage(const StreetParams& street);
StreetStage set_stage(StreetScan& scan);  // also sets the ends of the drive

// Returns a point with what a record states about its surface: classes, colour, material and truth. The position
// determines the colour.
ColouredPoint labelled_point(const SurfaceLabel& label, Vec3 surface_place);

// Chooses the density of profiles and pulses that gives about this number of points. Both are scaled by the same
// factor.
void fit_points(StreetScan& scan, const StreetStage& stage, std::uint64_t points);

// Scans from one end to the other and passes records of coloured_layout(0.001) to `take` in order. Stretches of fixed
// length are scanned in parallel, in batches of bounded size. The result does not depend on the threads.
void scan_street(const StreetScan& scan, const StreetStage& stage,
                 const std::function<void(std::span<const std::byte>)>& take);

// Writes the cloud and NAME.truth.json.
ScanCounts scan_street_scene(const ScanRequest& request);

}  // namespace ilot::scan
