// SPDX-License-Identifier: Apache-2.0
// Joins planes of neighbouring cells that touch and agree. Cells end where the lattice ends them, but surfaces
// continue.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/products/planes/cells/planes_pass.h"

namespace ilot {

// How often points of plane a have points of plane b, of another cell, among their nearest neighbours within the
// connectivity.
struct Contact {
  std::uint32_t a = 0, b = 0;  // indices into the cell planes, a < b
  std::uint32_t count = 0;
};

// Finds the contacts between planes of different cells, in ascending order of (a, b). They are written per block as
// "contacts".
std::vector<Contact> contact_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                                  const PassContext& context);

// A plane over all cells. Lengths are in lattice units, coordinates are relative to `anchor`.
struct JoinedPlane {
  Index3 anchor;  // corner of its first cell
  Plane plane;
  double epsilon = 0;
  std::uint32_t min_points = 3;  // smallest number of points that any of its cells asks for
  std::uint64_t points = 0;
  bool too_small = false;  // after the extension of planes: it has fewer than min_points points
};

struct JoinedPlanes {
  std::vector<JoinedPlane> planes;        // ordered by their first cell plane, so in global order
  std::vector<std::uint32_t> of_segment;  // for each cell plane: 0 = dropped (too small), else 1 + index into `planes`
};

struct JoinParams {
  double min_cos = 0;  // cosine of the greatest angle between two planes that join
};

// Joins greedily, pairs with the most contacts first (ties by index). Two groups become one if the angle between them
// is small and each stays within half of its own epsilon (root mean square) of their common least-squares plane. The
// group gets the larger epsilon. Only exact sums are used, so the result depends on the set of cells and contacts
// alone. The result of a group does not depend on groups that it does not touch. O(contacts log contacts).
JoinedPlanes join_planes(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                         std::vector<Contact> contacts, const JoinParams& params);

}  // namespace ilot
