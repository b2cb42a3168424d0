// SPDX-License-Identifier: Apache-2.0
// Settings whose defaults rarely need a change. In text they are keys of their section: roofs.advanced.normal_angle is
// roofs.normal_angle. Where a default is from: docs/constants.md.
#pragma once

namespace ilot {

struct AdvancedRoofs {
  // metres; points so near to the surface of the ground are ground, where classes are found by shape
  double ground_within = 0.5;
  double least_height = 2;      // metres; lower points are no buildings, where classes are found by shape
  double smoothness = 0.06;     // greatest curvature of the points of a roof, where classes are found by shape
  double normal_angle = 25;     // degrees; greatest angle between a point's normal and that of its roof face
  double same_angle = 3.5;      // degrees; roof faces that touch are joined up to this angle
  double least_epsilon = 0.08;  // metres; least value of roofs.epsilon where it is auto
  double most_epsilon = 0.3;    // metres; greatest value of roofs.epsilon where it is auto
  // m2; without superstructures, faces below this and below roofs.main_roof_share are left out
  double main_roof_area = 12;
  double main_roof_share = 0.15;  // share of the largest face, see roofs.main_roof_area
  double border_cost = 0.3;   // m2; cost of a metre of border between two faces, in area of points that contradict it
  double wall_cost = 0.1;     // m2; cost of a square metre of wall between two faces, up to a height of 0.5 m
  double overshoot = 0.5;     // metres; height to which a face may rise above its highest point
  double block_height = 0.7;  // quantile of the heights of the points that gives the top of a block of LoD1.2
};

struct AdvancedStreets {
  double gap_step = 0.2;      // metres; greatest difference in height between the two sides of a gap between scan lines
  double highest_kerb = 0.3;  // metres; greatest height of a plateau that is pavement
  double least_pavement = 1;  // m2; smaller plateaus are objects, not pavement
  double facade_height = 2.5;  // metres; lower pixels show no facade, where the blocks of the city are found
  double facade_length = 20;   // metres; lines with less facade along them are left out
  // metres; a cross street cuts at least this deep into the heights along a line of facades
  double cross_street_depth = 5;
  double cross_street_width = 3;  // metres; narrower gaps in a line of facades are no cross streets
  double block_distance = 30;     // metres; objects farther from all lines of facades belong to no block
};

struct AdvancedFacades {
  double lean = 5;             // degrees; greatest angle of a facade to the vertical
  double relief_behind = 1;    // metres; planes along a facade that are this far behind it or less belong to it
  double large_part = 1;       // m2; smaller planes beside the plane of a facade are relief, whatever facades.bias
  double shadow = 0.5;         // metres; parts of an opening are joined across shadows up to this width
  double least_reveal = 0.04;  // metres; shallower holes in the wall are no openings
  double room_depth = 4;       // metres; points farther behind the wall are not used to find openings
  // metres; the same where no stations are known and rays are taken to be perpendicular to the wall
  double room_depth_square = 2.5;
  // metres; the wall must continue within this distance above an opening: signs and blinds can hide it
  double hidden_above = 1.5;
  // greatest residuals of a circle at the top of an opening, as a share of those of a level line
  double arch_misfit = 0.35;
  double door_height = 1.8;         // metres; lower openings are no doors
  double door_sill = 0.4;           // metres; openings that begin higher above the foot of the wall are no doors
  double balcony_depth = 0.3;       // metres; elements that stand out less are no balconies
  double balcony_width = 0.5;       // metres; narrower elements that stand out so far are brackets
  double balcony_height = 1.5;      // metres; higher elements that stand out so far are protrusions
  double least_relief = 0.01;       // metres; planes that stand out less are part of the wall
  double least_relief_size = 0.03;  // metres; narrower or lower relief is not drawn
  double most_relief = 2.5;         // metres; what is farther before or behind the wall does not belong to it
  // metres; the sides of stones are found from points at this depth in their joints or deeper
  double joint_depth_from = 0.004;
  // metres; the sides of stones are found from points at this depth in their joints or less
  double joint_depth_to = 0.014;
  double joint_width = 0.06;     // metres; wider gaps between stones are no joints
  double bulge = 0.08;           // metres; greatest height or depth of a bulge or hollow of the wall
  double bulge_area = 0.04;      // m2; smaller bulges and hollows are not drawn
  double line_up = 0.25;         // metres; greatest distance between the middles of the elements of one column
  double dormer_width = 0.6;     // metres; narrower upright planes in a roof are no dormers
  double dormer_height = 0.5;    // metres; lower upright planes in a roof are no dormers
  double dormer_most_width = 6;  // metres; wider upright planes in a roof are storeys that are set back
  double dormer_behind = 3;      // metres; greatest distance of a dormer behind its facade
  double dormer_reach = 6;       // metres; greatest height of dormers above the top of their facade
  double corner_reach = 0.3;     // metres; facades that end so near to the line in which they meet are joined there
  double corner_angle = 20;      // degrees; facades that turn by less do not form a corner
  double storey_step = 2.5;      // metres; greatest distance between two walls of one front, one above the other
};

}  // namespace ilot
