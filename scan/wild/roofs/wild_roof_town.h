// SPDX-License-Identifier: Apache-2.0
// The town of the scene `roofs-wild`: buildings with every form of roof, what stands on them, trees over and against
// them, and cars that move between the flight lines. Drawn from the group "roofs" of distributions.csv.
#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "scan/roofs/roof_town.h"
#include "scan/truth_writer.h"
#include "scan/wild/draws.h"
#include "scan/wild/roofs/wild_roof_forms.h"

namespace ilot::scan {

enum class RoofExtraKind : std::uint8_t { chimney, solar_panel, equipment, parapet, car, balustrade };
const char* name_of(RoofExtraKind kind);

// A solid that is no part of a building's model: on a roof, or a car on the ground.
struct RoofExtra {
  RoofExtraKind kind = RoofExtraKind::chimney;
  std::uint32_t building = 0;  // from 1; 0 = a car
  ConvexSolid solid;
  Material material = Material::brick;
  std::uint64_t key = 0;  // of a car: in which flight lines it is there
};

// What is known about a wing beside its planes.
struct WingSurface {
  std::uint32_t building = 0, wing = 0;  // indices
  std::size_t planes = 0;                // of its roof; the four sides follow
  std::optional<Quadric> curve;          // in the town
  bool glass = false;
  double below = 0;  // z of the lower layer
};

struct WildTree {
  TrueTree truth;
  bool at_house = false;
};

struct WildRoofTown {
  RoofTown town;
  std::vector<std::string_view> forms;  // of each building
  std::vector<std::uint32_t> group;     // of each building: those of a terrace share it
  std::vector<WingSurface> wings;       // in the order of the solids of make_roofs_scene
  std::vector<RoofExtra> extras;        // on roofs
  std::vector<RoofExtra> cars;
  std::vector<WildTree> trees;
  std::vector<std::uint32_t> tree_of_crown;  // index into trees
  double width = 0, heading_deg = 0;         // of the square that is built on, about the middle of the area
  bool holds(double x, double y, double beyond) const;
};

// Builds a town on a square of this side in metres.
WildRoofTown build_wild_town(Draws& draws, std::uint64_t seed, double width);

// Adds what stands on the roofs, trees and cars.
void add_roof_extras(WildRoofTown& town, Draws& draws);
void add_wild_trees(WildRoofTown& town, Draws& draws);
void add_cars(WildRoofTown& town, Draws& draws);

}  // namespace ilot::scan
