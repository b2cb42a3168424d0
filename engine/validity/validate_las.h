// SPDX-License-Identifier: Apache-2.0
// Checks whether the content of a LAS or LAZ file agrees with its header. It is judged by LAS 1.4 R15 and by its
// points, all of which are read.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/formats/reader.h"

namespace ilot {

// The rules, in the order of the findings: header-size, version, vlr-count, extra-bytes, wkt-flag, box-range,
// points-damaged, point-count, legacy-count, returns-count, return-number, gps-time, box, reader.
struct Finding {
  std::string rule;
  std::string text;    // one line: the value that was found and what it should be
  bool severe = true;  // breaks the standard or misleads readers; otherwise it is information, and the file is valid
};

// Checks a file. The box may be half a scale step wider or narrower than the points. There is one finding per rule and
// case, however many points break it. No finding means that the file agrees with its header. Warnings of the reader
// come last and are not severe. O(points), with 4 MiB of rows in memory. advance(points) is called as work proceeds.
// Throws Error when the cloud is not of the LAS family, and with ExitCode::interrupted when a stop is requested.
std::vector<Finding> validate_las(PointReader& reader, const std::function<void(std::uint64_t)>& advance = {});

}  // namespace ilot
