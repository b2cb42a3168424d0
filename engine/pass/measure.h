// SPDX-License-Identifier: Apache-2.0
// What a cloud really holds, as against what its header says.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "engine/formats/reader.h"

namespace ilot {

// Reads the cloud twice, three times where points stand alone, front to back, on the calling thread; holds less than 64
// MiB whatever its size. Strays are judged among all valid points, a run judges among those that it uses. The
// answer depends on the points and their order only. advance(points) is called as work proceeds, 2 x points
// in all (3 x with strays); ends with ExitCode::interrupted when a stop is requested.
CloudMeasure measure_cloud(PointReader& reader, const std::function<void(std::uint64_t)>& advance = {});

}  // namespace ilot
