// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>

#include "engine/model/segment.h"

namespace ilot {

// One line per pair of planes that touch, header line first. Columns and units: docs/outputs.md. Numbers are the
// shortest that read back to the same bits. Written whole or not at all.
void write_planes_neighbours_csv(const std::filesystem::path& path, std::span<const PlaneNeighbours> pairs);

}  // namespace ilot
