// SPDX-License-Identifier: Apache-2.0
// Finds the rows of a file that a box needs, for files that describe the places of their points.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"

namespace ilot {

struct RowRange {
  std::uint64_t first = 0, end = 0;  // end is not part of it
};

// Returns rows that may contain points of the area's box (closed; its rings are not used): whole chunks, ascending,
// neighbours merged. It trusts the file that each node contains only points of its cube. Returns all rows when the file
// is not COPC, when its hierarchy is damaged or when the hierarchy does not describe exactly the existing chunks. Reads
// the hierarchy from reader.info().path. O(nodes log nodes) time, 64 bytes a node. Throws Error when the file can no
// longer be read.
std::vector<RowRange> rows_in_box(const PointReader& reader, const Area& area);

}  // namespace ilot
