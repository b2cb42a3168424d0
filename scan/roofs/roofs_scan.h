// SPDX-License-Identifier: Apache-2.0
// The scene `roofs`: a town of 445 roofs seen from the air by two overlapping flight lines, with its model as truth.
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
  std::optional<std::uint64_t> points;  // about so many: the density follows
};

// From options. Throws Error (usage) when both --points and scene.density are given.
RoofsScan plan_roofs(const SceneValues& values, std::uint64_t seed, std::optional<std::uint64_t> points);

// Pulses per square metre that give about so many points, within 2%.
double density_for(const RoofTown& town, std::uint64_t points);

// The town as what rays meet.
struct RoofsScene {
  std::vector<ConvexSolid> solids;
  // Per face of the solids: its building, and the faces of the building's solid that lie in its plane.
  struct Target {
    std::uint32_t building = 0;
    std::vector<std::uint32_t> faces;
  };
  std::vector<Target> targets;
};
RoofsScene make_roofs_scene(const RoofTown& town);

// The face of the building's solid that was met at a place, seen from outside.
std::uint32_t face_met(const RoofTown& town, const RoofsScene::Target& target, Vec3 place);

// true_plane of the ground, and of the town's plane 0.
constexpr std::uint32_t kTownGround = 1, kFirstTownPlane = 2;

// Scans the town, tile by tile, and hands over records of coloured_layout(0.001) in order. Tiles are made in parallel,
// a batch of bounded size at a time; what is handed over does not depend on the number of threads.
void scan_roofs(const RoofsScan& scan, const RoofTown& town,
                const std::function<void(std::span<const std::byte>)>& take);

// Writes the cloud, NAME.truth.json and NAME.truth.city.json.
ScanCounts scan_roofs_scene(const ScanRequest& request);

}  // namespace ilot::scan
