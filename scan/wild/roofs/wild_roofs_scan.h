// SPDX-License-Identifier: Apache-2.0
// The scene `roofs-wild`: a town from the air with every fault of real airborne scans, its true solids and footprints.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "scan/scanners/airborne.h"
#include "scan/scenes.h"
#include "scan/wild/roofs/wild_roof_town.h"

namespace ilot::scan {

std::span<const SceneOption> wild_roofs_options();
extern const std::array<std::string_view, 1> kWildRoofsGroups;

// Values of true_class.
enum class RoofClass : std::uint8_t { ground = 1, roof = 2, wall = 3, vegetation = 4, installation = 5, car = 6 };

struct WildRoofsScanner {
  AirborneParams flight;
  double noise = 0.02;
  double strip_shift = 0;                        // metres, standard deviation per flight line
  double glass_echo = 0.3, glass_through = 0.5;  // shares of the pulses on glass
  double wet = 0;                                // share of flat roofs that mirror pulses away
  double wet_ground = 0;                         // share of the ground that does, in patches: water
  double ground_kept = 1;          // share of the ground that is in the cloud; what is missing is in patches
  double ground_dropped_near = 0;  // metres around buildings without ground
  double wrong_classes = 0, trees_as_building = 0, stray = 0;
  double car_there = 0.6;  // chance that a car is there in a flight line
  bool colour = true, intensity = true;
};

struct WildRoofsScan {
  WildRoofTown wild;
  WildRoofsScanner scanner;
  std::uint64_t seed = 0;
};

// Draws a town and how it is scanned; its extent gives about `points` points at the most.
WildRoofsScan plan_wild_roofs(Draws& draws, std::uint64_t seed, std::uint64_t points);

// Chooses the density that gives about this number of points.
void fit_wild_roofs(WildRoofsScan& scan, std::uint64_t points);

constexpr std::uint32_t kWildGround = 1, kFirstWildPlane = 2;  // true_plane of the ground; of plane 0 of the town
// true_element: building b (from 0) has b + 1; tree i has kFirstTreeElement + i.
constexpr std::uint32_t kFirstTreeElement = 100001;

// Passes records of coloured_layout(0.001) to `take`, tile by tile. The result does not depend on the threads.
void scan_wild_roofs(const WildRoofsScan& scan, const std::function<void(std::span<const std::byte>)>& take);

// Outlines as a register has them: shifted, with buildings missing and terraces merged.
struct WildFootprint {
  std::uint32_t id = 0;                  // of the first of its buildings
  std::vector<std::uint32_t> buildings;  // from 1
  std::vector<std::vector<Vec3>> rings;  // town; outline first
};
std::vector<WildFootprint> draw_footprints(const WildRoofTown& wild, Draws& draws);

// Writes the cloud, NAME.truth.json, NAME.truth.city.json and NAME.footprints.geojson.
ScanCounts scan_wild_roofs_scene(const ScanRequest& request);

}  // namespace ilot::scan
