// SPDX-License-Identifier: Apache-2.0
// The plan of the scene `street`: a straight street with pavements, blocks of houses on both sides, and cross streets
// between the blocks. In street coordinates, s runs along the street, t to the left of its axis and z up, in metres.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/optics/exact_math.h"
#include "scan/optics/material.h"
#include "scan/optics/solid.h"

namespace ilot::scan {

// The path of the scanning vehicle, and the turn of its scanning planes from straight across.
struct Viewpoint {
  double lane = -1.6, height = 2.6, turned_deg = 40;
};

struct StreetParams {
  std::uint64_t blocks = 30;
  double slope_percent = 2;  // rising with s
  double touching = 0.15;    // share of the objects that touch another
  double trees = 1.5;        // per block
  Viewpoint scanner;         // no object stands in its lane, and it sees a part of every object
  std::uint64_t seed = 0;
};

constexpr double kHalfRoad = 5.6, kHalfStreet = 9.6;  // the pavements lie between
constexpr double kKerb = 0.12;
constexpr double kCorner = 1.5;   // width of pavement around a block, along the cross streets
constexpr double kReveal = 0.25;  // depth of the windows in the wall
constexpr double kHouseDepth = 11;
constexpr double kCrossStreet = 45;  // distance from the axis to which pavements reach

struct StreetHouse {
  int side = 1;  // 1 = left, -1 = right
  double from = 0, to = 0;
  double base = 0;  // z of its threshold
  std::uint32_t floors = 4;
  double ground_floor = 4, storey = 3.1;  // heights
  std::uint32_t columns = 4;              // of windows
  double window_width = 1.1, window_height = 1.9;
  bool shop = false;
  Material wall = Material::limestone, roof = Material::zinc;
  double eave() const { return base + ground_floor + storey * (floors - 1); }
};

struct StreetBlock {
  std::uint32_t id = 0;  // from 1, along the street; both sides share it
  double from = 0, to = 0;
};

struct StreetTree {
  Vec3 foot;
  Crown crown;
};

struct Street {
  StreetParams params;
  double length = 0, slope = 0, base = 0;
  std::vector<StreetBlock> blocks;  // by s: the gaps between them are the cross streets
  std::vector<StreetHouse> houses;
  std::vector<StreetTree> trees;

  double road_height(double s) const { return base + slope * s; }
  bool on_pavement(double s, double t) const;
  double ground_height(double s, double t) const { return road_height(s) + (on_pavement(s, t) ? kKerb : 0); }
};

// Plans the street. The function is pure: the same parameters give the same street.
Street plan_street(const StreetParams& params);

// Street coordinates are turned and moved into metres in the scene. The street runs 23 degrees north of east.
SinCos street_heading();
constexpr double kStreetHeadingDeg = 23;
Vec3 street_to_scene(Vec3 p);

// The inverse functions. turned_to_street is for directions.
Vec3 scene_to_street(Vec3 p);
Vec3 turned_to_street(Vec3 v);

}  // namespace ilot::scan
