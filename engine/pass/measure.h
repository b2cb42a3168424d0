// SPDX-License-Identifier: Apache-2.0
// Measures the real content of a cloud, in contrast to what its header declares.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "engine/formats/reader.h"

namespace ilot {

// Reads the cloud twice, or three times when it has isolated points, front to back, on the calling thread. Uses less
// than 64 MiB for a cloud of any size. Strays are determined among all valid points, while a run determines them among
// the points that it uses. The result depends only on the points and their order. advance(points) is called during the
// work, 2 x points in all (3 x with strays). Ends with ExitCode::interrupted when a stop is requested.
CloudMeasure measure_cloud(PointReader& reader, const std::function<void(std::uint64_t)>& advance = {});

}  // namespace ilot
