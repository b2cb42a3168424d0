// SPDX-License-Identifier: Apache-2.0
// Rows from arrays of coordinates and attributes.
#pragma once
#include <cstddef>
#include <span>

#include "engine/cloud/record.h"
#include "ilot/array_cloud.h"
#include "ilot/geometry.h"

namespace ilot {

// Returns the layout of rows with this scale and offset: point format 6, or 7 with colour.
RecordLayout array_layout(bool colour, double scale, Vec3 offset);

// Throws Error (usage) when an array that is not empty has another length than x.
void check_array_lengths(const ArrayCloud& cloud);

// Fills `rows` (a multiple of layout.record_length) with the points from `first` on. Throws Error (usage) for a
// coordinate that is not finite, or beyond 2^31 scales of the offset. O(rows).
void fill_rows(const ArrayCloud& cloud, const RecordLayout& layout, std::size_t first, std::span<std::byte> rows);

}  // namespace ilot
