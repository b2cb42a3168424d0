// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "engine/model/segment.h"

namespace ilot {

// Writes a header line, then one line for each plane, by id. Columns and units: docs/outputs.md. Numbers are the
// shortest ones that are read back as the same bits. The file is complete or absent.
void write_planes_csv(const std::filesystem::path& path, std::span<const Segment> segments);

// Reads the file. Columns are found by name, so that additional columns are allowed. Fields of Segment that the file
// lacks stay zero, but id, plane and centroid are required. An Error names the file and the line.
// The first calls use() line by line, for files of any length.
void for_each_plane(const std::filesystem::path& path, const std::function<void(const Segment&)>& use);
std::vector<Segment> read_planes_csv(const std::filesystem::path& path);

// Reads planes_neighbours.csv. All columns are required. An Error names the file and the line.
std::vector<PlaneNeighbours> read_planes_neighbours_csv(const std::filesystem::path& path);

}  // namespace ilot
