// SPDX-License-Identifier: Apache-2.0
// The town of the scene `roofs`. It has four quarters around two avenues. Each quarter has streets in its own
// direction, detached and adjoining buildings with every kind of roof, and trees beside them.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/districts/district.h"
#include "scan/optics/material.h"
#include "scan/optics/solid.h"
#include "scan/roofs/roof_solid.h"
#include "scan/roofs/roof_styles.h"

namespace ilot::scan {

struct RoofTownParams {
  std::uint64_t buildings = 445;  // of which 128 of 445 are gables and 52 of 445 hips
  double adjoining = 0.4;         // chance that a building adjoins the one before it
  double chimneys = 0;            // share of the buildings that have one
  double trees = 25;              // per hectare
  double slope_percent = 2;       // of the ground
  std::uint64_t seed = 0;
};

// The frame of a building: its position and direction. Its u runs along `heading`. Heights are absolute.
struct RoofFrame {
  double x = 0, y = 0;
  SinCos heading;
  Vec3 to_town(Vec3 local) const;
  Vec3 to_local(Vec3 place) const;
  Vec3 direction_to_town(Vec3 local) const;
};

struct RoofBuilding {
  RoofKind kind = RoofKind::gable;
  std::vector<Wing> wings;
  RoofSolid solid;
  RoofFrame frame;
  Material roof = Material::tile, wall = Material::render;
  std::vector<std::uint32_t> face_plane;  // per face of the solid, 0-based in the town; none for the floor
  double eave = 0, ridge = 0, floor = 0;  // z
};

// The number of roofs of each kind in a given number of buildings, in the proportion 128 : 52 : 265.
struct RoofCounts {
  std::uint64_t gable = 0, hip = 0, complex = 0;
};
RoofCounts roof_counts(std::uint64_t buildings);

struct RoofTown {
  Ground ground;
  Rect area;
  std::vector<RoofBuilding> buildings;
  std::uint32_t plane_count = 0;  // for all faces except the floors; connected coplanar faces of neighbours share one
  std::vector<Crown> crowns;
};

constexpr std::uint32_t kNoPlane = ~0u;

// Builds the town. The function is pure: the same parameters give the same town. Every solid is sound. No two faces are
// so close to one plane, without being in it, that they cannot be distinguished.
RoofTown build_roof_town(const RoofTownParams& params);

// Returns what covers the ground at a position: asphalt on streets, paving beside them, grass elsewhere.
Material ground_cover(const RoofTown& town, double x, double y);

// Returns the horizontal distance in metres from a position to the nearest wing of a building; 0 inside.
double distance_to_building(const RoofBuilding& building, double x, double y);

}  // namespace ilot::scan
