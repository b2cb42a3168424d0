// SPDX-License-Identifier: Apache-2.0
// Internal to the raster kernels: flat zones as runs of rows, before they are painted.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/rasters/image.h"

namespace ilot {

// Pixels [from, to) of a row.
struct PixelRun {
  std::uint32_t from, to;
};

struct ZoneRuns {
  std::uint32_t width = 0, height = 0;
  std::uint32_t count = 0;                // of zones
  std::vector<PixelRun> runs = {};        // row by row, from left to right
  std::vector<std::uint32_t> first = {};  // the runs of row y go from first[y] to first[y + 1]
  std::vector<std::uint32_t> zone = {};   // of each run, from 1, numbered by first pixel
};

// Returns the zones that flat_zones labels. Two pixels of a row are in one run when they are neighbours within lambda.
ZoneRuns zone_runs(const Image& image, Height lambda, Adjacency adjacency);

// Returns the regions of pixels that are flagged (not 0), given row by row, joined across sides, or across corners too.
ZoneRuns flagged_runs(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> flags,
                      Adjacency adjacency);

// Returns the regions of pixels without a height.
ZoneRuns missing_runs(const Image& image, Adjacency adjacency);

// Returns 1 for the zones that have a pixel on the border of the image. [0] is unused.
std::vector<std::uint8_t> zones_on_border(const ZoneRuns& zones);

PixelLabels painted(const ZoneRuns& zones);

// Calls take(zone, y, run) for all runs.
template <class Take>
void for_each_run(const ZoneRuns& zones, const Take& take) {
  for (std::uint32_t y = 0; y < zones.height; ++y)
    for (std::uint32_t r = zones.first[y]; r < zones.first[y + 1]; ++r) take(zones.zone[r], y, zones.runs[r]);
}

}  // namespace ilot
