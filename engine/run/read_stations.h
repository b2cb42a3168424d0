// SPDX-License-Identifier: Apache-2.0
// Where scanners stood, from a file.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// A line a station: x y z in the units of the clouds (a name may stand before them), then azimuth_step_deg and
// elevation_step_deg (above 0, at most 5), then the axis it turned about as axis_x, axis_y, axis_z [0 0 1]; separated
// by blanks, tabs, commas or semicolons. A first line of these names (and name, point_source_id) gives other orders and
// leaves columns out. A station without a point_source_id has its name, where that is a whole number from 1 to 65535.
// Empty lines and those that begin with # are passed over. Error with ExitCode::usage and FILE:LINE.
std::vector<Station> read_stations(const std::filesystem::path& path);

}  // namespace ilot
