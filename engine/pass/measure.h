// SPDX-License-Identifier: Apache-2.0
// What a cloud really holds, as against what its header says.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "engine/formats/reader.h"

namespace ilot {

struct CloudMeasure {
  std::uint64_t points = 0;        // valid ones; 0: the rest is zero
  std::uint64_t rejected = 0;      // coordinates not finite or out of range
  std::uint64_t last_returns = 0;  // points that are the last echo of their pulse, or say nothing about echoes
  std::uint64_t with_colour = 0;   // points with any colour channel above 0
  std::uint64_t strays = 0;        // valid points that stand alone, far from all others (engine/store/strays.h)
  Vec3 min, max;                   // of the valid points without strays, in the units of the CRS
  Vec3 all_min, all_max;           // with them
  std::array<std::uint64_t, 256> classes{};  // points per class code

  // Horizontal, without strays, over the cells (16 points each on average, at most 512 x 512) that hold any point.
  double occupied_area = 0;  // square metres
  double density = 0;        // all returns per square metre
  double last_return_density = 0;
  double sampling_step = 0;  // metres; median distance to the nearest point elsewhere, over up to 32 windows
};

// Reads the cloud twice, three times where points stand alone, front to back, on the calling thread; holds less than 64
// MiB whatever its size. Strays are judged among all valid points, a run judges among those that it uses. The
// answer depends on the points and their order only. advance(points) is called as work proceeds, 2 x points
// in all (3 x with strays); ends with ExitCode::interrupted when a stop is requested.
CloudMeasure measure_cloud(PointReader& reader, const std::function<void(std::uint64_t)>& advance = {});

}  // namespace ilot
