// SPDX-License-Identifier: Apache-2.0
// Clouds in memory as inputs of a run.
#pragma once
#include <memory>
#include <string>

#include "engine/formats/reader.h"
#include "ilot/array_cloud.h"

namespace ilot {

constexpr const char* kArrayFormat = "arrays";  // CloudInfo::format of these readers; the path is the cloud's name

// Random access. The arrays must live as long as the reader; they are looked at once here. Throws Error (usage) for
// arrays of different lengths, without points, with coordinates that are not finite or do not fit, and for a name that
// is no file name.
std::unique_ptr<PointReader> open_arrays(const ArrayCloud& cloud);

inline bool is_in_memory(const CloudInfo& info) {
  return info.format == kArrayFormat;
}

// What the arrays hold, their scale and CRS, as a number in 16 hexadecimal digits: to notice that they have changed. It
// is no safeguard against intent. O(points), on all threads.
std::string content_sum(const ArrayCloud& cloud);

}  // namespace ilot
