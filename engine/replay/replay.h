// SPDX-License-Identifier: Apache-2.0
// One unit of a finished run made again from its kept store, with everything that was found on the way.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

struct ReplayOptions {
  KeptRunPlaces places;
  std::string unit;              // "building:ID", "facade:N", "tile:ROW,COLUMN", "cell:X,Y,Z"
  std::filesystem::path folder;  // for what is written; empty = out/replay/UNIT
};

struct ReplayResult {
  std::filesystem::path folder;
  std::vector<std::string> differences;  // to what the run wrote of the unit; none: it is the same
  std::vector<Picture> pictures;         // for the caller to draw into the folder
};

// Writes steps.gpkg, replay.json and the unit itself in the run's own format. The run and its store stay as they are.
// Throws a usage Error when there is no such unit.
ReplayResult replay(const ReplayOptions& options, Progress& progress);

// A line a unit: its name, where it is and how large it is.
std::vector<std::string> units_to_replay(const KeptRunPlaces& places);

}  // namespace ilot
