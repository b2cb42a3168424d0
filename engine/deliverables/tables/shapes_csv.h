// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>

#include "engine/model/curved_segment.h"

namespace ilot {

// Writes shapes.csv: one line for each sphere, cylinder or cone. Columns: docs/outputs.md. The file is complete or
// absent.
void write_shapes_csv(const std::filesystem::path& path, std::span<const CurvedSegment> segments);

}  // namespace ilot
