// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>

#include "engine/model/curved_segment.h"

namespace ilot {

// shapes.csv: one line a sphere, cylinder or cone. Columns: docs/outputs.md. Whole or not at all.
void write_shapes_csv(const std::filesystem::path& path, std::span<const CurvedSegment> segments);

}  // namespace ilot
