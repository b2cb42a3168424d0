// SPDX-License-Identifier: Apache-2.0
// Which rows of a file a box needs, for files that say where their points lie.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"

namespace ilot {

struct RowRange {
  std::uint64_t first = 0, end = 0;  // end is not part of it
};

// Rows that may hold points of the area's box (closed; its rings are not looked at): whole chunks, ascending,
// neighbours merged. That nodes hold the points of their cube only is taken from the file. All rows when it is not
// COPC, when its hierarchy is damaged or when it does not describe exactly the chunks that are there. Reads the
// hierarchy from reader.info().path; O(nodes log nodes) time, 64 bytes a node. Throws Error when the file cannot be
// read any more.
std::vector<RowRange> rows_in_box(const PointReader& reader, const Area& area);

}  // namespace ilot
