// SPDX-License-Identifier: Apache-2.0
// Does a LAS or LAZ file hold what its header says? Judged by LAS 1.4 R15 and by its points, all of which are read.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/formats/reader.h"

namespace ilot {

// Rules, in the order in which findings come: header-size, version, vlr-count, extra-bytes, wkt-flag, box-range,
// points-damaged, point-count, legacy-count, returns-count, return-number, gps-time, box, reader.
struct Finding {
  std::string rule;
  std::string text;    // one line: what stands there, what it should be
  bool severe = true;  // breaks the standard or misleads readers; else worth knowing, and the file is valid
};

// The box may be half a scale step wider or narrower than the points. One finding per rule and case, however many
// points break it; none: the file is as it says. What the reader warns of comes last, as not severe. O(points), 4 MiB
// of rows in memory; advance(points) is called as work proceeds. Throws Error when the cloud is not of the LAS
// family, and with ExitCode::interrupted when a stop is requested.
std::vector<Finding> validate_las(PointReader& reader, const std::function<void(std::uint64_t)>& advance = {});

}  // namespace ilot
