// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "engine/model/segment.h"

namespace ilot {

// One line per plane, by id, header line first. Columns and units: docs/outputs.md. Numbers are the shortest that read
// back to the same bits. Written whole or not at all.
void write_planes_csv(const std::filesystem::path& path, std::span<const Segment> segments);

// The way back. Columns are found by name, so that more of them do no harm; what a Segment has and the file has not
// stays zero, but id, plane and centroid must be there. Error names file and line.
std::vector<Segment> read_planes_csv(const std::filesystem::path& path);

// planes_neighbours.csv. All columns must be there. Error names file and line.
std::vector<PlaneNeighbours> read_planes_neighbours_csv(const std::filesystem::path& path);

}  // namespace ilot
