// SPDX-License-Identifier: Apache-2.0
// What a run found on streets, read back from its folder. Positions in the CRS of the inputs and its units; names that
// end in _m, _m2 and _deg are metres, square metres and degrees.
//
//   for (const ilot::StreetObject& o : ilot::read_streets("out").objects)
//     if (o.label == ilot::PointLabel::car) std::printf("%g %g\n", o.base.x, o.base.y);
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "ilot/cloud_info.h"
#include "ilot/geometry.h"

namespace ilot {

// Something that stands on the ground.
struct StreetObject {
  std::uint32_t id = 0;  // from 1
  PointLabel label = PointLabel::other;
  std::string class_name;  // of the label; a class of one's own where the run was trained with one (--train)
  double probability = 0;  // of that class; 1 where a person decided it
  Vec3 base;               // on the ground
  Vec3 middle;             // of its extent, on the ground
  double height_m = 0, length_m = 0, width_m = 0;
  double heading_deg = 0;  // of the length, from x towards y, 0 to below 180
  double area_m2 = 0;
  std::uint64_t points = 0;
  std::uint32_t stretch = 0, block = 0;  // the nearest; 0 = none
  bool by_hand = false;                  // a person decided its class or its extent (RunOptions::edits)
};

// A part of a line of facades: a block, or the gap between two.
struct FacadePart {
  std::uint32_t stretch = 0, number = 0;  // from 1; along the stretch
  Vec3 from, to;                          // on the ground
  double length_m = 0, height_m = 0;
};

// A tree, of at least three metres.
struct StreetTree {
  std::uint32_t id = 0;       // from 1
  Vec3 position;              // of the trunk's axis at the ground; of the middle of the crown where no trunk was seen
  bool trunk_seen = false;    // something narrow stands below the crown and reaches up to it
  double height_m = 0;        // of the highest point above the ground at the position
  double crown_radius_m = 0;  // of the circle with the area of the crown in plan
  double crown_base_m = 0;    // above the ground; a tenth of the crown in plan reaches lower
  double trunk_radius_m = 0;  // at 0.3 to 3.3 m above the ground; 0 = no trunk was seen
  double unseen_share = 0;    // of the crown's sides: parts of 45 degrees and half a metre without a point
  std::uint64_t points = 0;   // of the crown
};

// A step of the ground between road and pavement, or a part of it that was not seen.
struct StreetKerb {
  std::uint32_t id = 0;           // from 1
  bool seen = true;               // false: the straight line between the ends of two seen kerbs
  std::vector<Vec3> line;         // on the upper edge
  std::vector<double> heights_m;  // of the step at each vertex of the line
  double height_m = 0;            // their median
  double length_m = 0;            // in plan
};

// What ends a pavement on the side away from the road.
enum class PavementEnd : std::uint8_t {
  open,     // nothing that was seen: the pavement is at least as wide as ground was seen
  unsure,   // something that no width within two metres of kerb on either side confirms
  wall,     // a building
  barrier,  // a fence, a free-standing wall or a hedge, or three metres of other objects without a gap
  step,     // a step of the ground: another kerb, stairs, the wall of a terrace
};

// "open", "unsure", "wall", "barrier", "step": as pavements.gpkg has it.
const char* pavement_end_name(PavementEnd end);

// The width of a pavement across one metre of a kerb.
struct PavementWidth {
  std::uint32_t kerb = 0;    // id of the kerb
  std::uint32_t number = 0;  // along the kerb, from 1
  Vec3 from, to;             // on the kerb's upper edge and at the end, on the ground
  bool kerb_seen = true;     // that of the kerb
  PavementEnd end = PavementEnd::open;
  double width_m = 0;          // in plan, from the kerb to the end; of an open end to the last ground that was seen
  double error_m = 0;          // nine in ten widths are as near to the true one, if this is what ends the pavement
  double passable_m = 0;       // the widest part of it that no object reaches into, up to 2.2 m above the ground
  double passable_from_m = 0;  // where that part begins, from the kerb
  double unseen_share = 0;     // of the width: neither ground nor an object was seen there
  double road_m = 0;           // from the kerb across the carriageway to the kerb on its other side; 0 = none in 30 m
};

// Pavement between a kerb and what ends it, along places whose widths have an end.
struct Pavement {
  std::uint32_t id = 0;     // from 1
  std::uint32_t kerb = 0;   // id of the kerb
  std::vector<Vec3> ring;   // along the kerb, then back along the ends
  double length_m = 0;      // along the kerb
  double area_m2 = 0;       // in plan
  double width_m = 0;       // median of its widths
  double passable_m = 0;    // the least of its passable widths
  double unseen_share = 0;  // mean over its widths
};

// Road between kerbs that face each other, in plan: its vertices have no height (those of its kerbs have).
struct Carriageway {
  std::uint32_t id = 0;                  // from 1
  std::vector<Vec3> ring;                // along the kerbs, counter-clockwise
  std::vector<std::vector<Vec3>> holes;  // islands, and what no kerb faces
  double area_m2 = 0;
  double width_m = 0;      // median of the ways across, from kerb to kerb, at each metre of the kerbs on both sides
  double narrowest_m = 0;  // the least of them
  double seen_share = 0;   // of the ways across: both kerbs were seen
};

struct StreetPlan {
  std::vector<StreetObject> objects;
  std::vector<FacadePart> blocks, gaps;
  std::vector<StreetTree> trees;
  std::vector<StreetKerb> kerbs;
  std::vector<PavementWidth> widths;
  std::vector<Pavement> pavements;
  std::vector<Carriageway> carriageways;
};

// Reads the layers in streets/ of a run with the product streets. `middle` is that of the written
// extent, at the height of the base; blocks and gaps lie at z = 0, as they are written. O(bytes). Several threads may
// read at once. Error (usage) when there are no streets in the folder; a damaged file is an Error that names it.
StreetPlan read_streets(const std::filesystem::path& run_folder);

}  // namespace ilot
