// SPDX-License-Identifier: Apache-2.0
// Finds what stands out of the wall: sills, bands, balconies, bulges.
#pragma once
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

struct ReliefParams {
  double least_size = 0.03;   // metres; nothing narrower is drawn
  double least_depth = 0.01;  // metres that it must stand out of the wall
  double least_fill = 0.5;    // share of its rectangle that its points must cover
};

// Finds the planes that are parallel to the wall and in front of it. Each is returned as the rectangle that ends at its
// sides. Pieces that lie on one plane and in line are joined where nothing was seen between them. The result is ordered
// by the id of the first piece. O(n log n).
std::vector<FoundRectangle> find_relief(const RaySamples& samples, const ReliefParams& params = {});

struct StoneParams {
  double joint_from = 0.004, joint_to = 0.014;  // metres; depths in a joint at which the side faces of stones are seen
  double joint_width = 0.06;                    // metres; wider gaps are no joints
};

// Finds the stones of a wall, which joints separate from each other. The segments of the wall are cut at the joints
// that go through them. The pieces that fill their rectangle are stones, if there are at least four. The order is that
// of find_relief().
std::vector<FoundRectangle> find_stones(const RaySamples& samples, const StoneParams& params = {});

// Leaves out stones that reach into an opening: such a piece is a course between two bands, and windows interrupt it.
// Leaves out all stones where fewer than four remain. O(stones x openings).
void drop_pierced_stones(const std::vector<FoundRectangle>& openings, std::vector<FoundRectangle>& stones);

}  // namespace ilot
