// SPDX-License-Identifier: Apache-2.0
// Cells end where the lattice says, surfaces do not: planes of neighbouring cells that touch and agree become one.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/planes/cells/planes_pass.h"

namespace ilot {

// How often points of plane a have points of plane b (of another cell) among their nearest within the connectivity.
struct Contact {
  std::uint32_t a = 0, b = 0;  // indices into the cell planes, a < b
  std::uint32_t count = 0;
};

// Contacts between planes of different cells, ascending by (a, b). Written per block as "contacts".
std::vector<Contact> contact_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                                  const PassContext& context);

// A plane over all cells. Lengths in lattice units, coordinates relative to `anchor`.
struct JoinedPlane {
  Index3 anchor;  // corner of its first cell
  Plane plane;
  double epsilon = 0;
  std::uint32_t min_points = 3;  // the fewest that any of its cells asks for
  std::uint64_t points = 0;
};

struct JoinedPlanes {
  std::vector<JoinedPlane> planes;        // by their first cell plane, so in global order
  std::vector<std::uint32_t> of_segment;  // per cell plane: 0 = dropped (too small), else 1 + index into planes
};

struct JoinParams {
  double min_cos = 0;  // of the angle between two planes that join
};

// Joins greedily, most contacts first (ties by index): two groups become one when the angle between them is small and
// each stays within half its own epsilon (root mean square) of their common least-squares plane; the larger epsilon is
// the group's. Only exact sums enter, so
// the answer depends on the set of cells and contacts alone; a group's outcome does not depend on groups that it does
// not touch. O(contacts log contacts).
JoinedPlanes join_planes(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                         std::vector<Contact> contacts, const JoinParams& params);

}  // namespace ilot
