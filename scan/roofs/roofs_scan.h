// SPDX-License-Identifier: Apache-2.0
// The scene `roofs`: a town of 445 roofs that two overlapping flight lines see from the air. Its model is the truth.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "scan/roofs/roof_town.h"
#include "scan/scanners/airborne.h"
#include "scan/scenes.h"

namespace ilot::scan {

std::span<const SceneOption> roofs_options();

struct RoofsScan {
  RoofTownParams town;
  AirborneParams flight;
  double noise = 0.02;                  // metres
  std::optional<std::uint64_t> points;  // approximate number; the density follows from it
};

// Makes the scan from options. Throws Error (usage) when both --points and scene.density are given.
RoofsScan plan_roofs(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points);

// Returns the pulses per square metre that give about this number of points, within 2%.
double density_for(const RoofTown& town, std::uint64_t points);

// The objects of the town that rays meet.
struct RoofsScene {
  std::vector<ConvexSolid> solids;
  // For each face of the solids: its building, and the faces of the building's solid that are in its plane.
  struct Target {
    std::uint32_t building = 0;
    std::vector<std::uint32_t> faces;
  };
  std::vector<Target> targets;
};
RoofsScene make_roofs_scene(const RoofTown& town);

// Returns the face of the building's solid that a ray met at a position, as seen from outside.
std::uint32_t face_met(const RoofTown& town, const RoofsScene::Target& target, Vec3 place);

// The true_plane of the ground, and that of plane 0 of the town.
constexpr std::uint32_t kTownGround = 1, kFirstTownPlane = 2;

// Scans the town tile by tile and passes records of coloured_layout(0.001) to `take` in order. Tiles are made in
// parallel, in batches of bounded size. The result does not depend on the number of threads.
void scan_roofs(const RoofsScan& scan, const RoofTown& town,
                const std::function<void(std::span<const std::byte>)>& take);

// Writes the cloud, NAME.truth.json and NAME.truth.city.json.
ScanCounts scan_roofs_scene(const ScanRequest& request);

}  // namespace ilot::scan
