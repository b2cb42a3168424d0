// SPDX-License-Identifier: Apache-2.0
// Reads the stations of scanners from a file.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Each line is a station: x y z in the units of the clouds (a name may be in front of them), then azimuth_step_deg and
// elevation_step_deg (above 0, at most 5), then the axis of rotation as axis_x, axis_y, axis_z [0 0 1]; separated by
// blanks, tabs, commas or semicolons. A first line with these names (and name, point_source_id) gives another order and
// may omit columns. A station without a point_source_id takes its name as the id when the name is a whole number from 1
// to 65535. Empty lines and lines that begin with # are skipped. Throws Error with ExitCode::usage and FILE:LINE.
std::vector<Station> read_stations(const std::filesystem::path& path);

}  // namespace ilot
