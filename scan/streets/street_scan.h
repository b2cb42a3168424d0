// SPDX-License-Identifier: Apache-2.0
// The scene `street`: blocks on both sides of a straight street and what stands on its pavements, scanned from a
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
  MobileParams drive;  // its ends follow from the street
};

StreetScan plan_street_scan(const SceneValues& values, std::uint64_t seed);

// All that a scan needs, ready to be scanned.
struct StreetStage {
  Street street;
  std::vector<StreetObject> objects;
  StreetModel model;
};
StreetStage set_stage(const StreetParams& street);
StreetStage set_stage(StreetScan& scan);  // and the ends of its drive

// What a record says of the surface that it lies on: classes, colour, material and truth; the place chooses the colour.
ColouredPoint labelled_point(const SurfaceLabel& label, Vec3 surface_place);

// Chooses the density of profiles and pulses so that about so many points come out, both scaled alike.
void fit_points(StreetScan& scan, const StreetStage& stage, std::uint64_t points);

// Scans from one end to the other and hands over records of coloured_layout(0.001) in order. Stretches of fixed length
// are scanned in parallel, a batch of bounded size at a time; what is handed over does not depend on the threads.
void scan_street(const StreetScan& scan, const StreetStage& stage,
                 const std::function<void(std::span<const std::byte>)>& take);

// Writes the cloud and NAME.truth.json.
ScanCounts scan_street_scene(const ScanRequest& request);

}  // namespace ilot::scan
