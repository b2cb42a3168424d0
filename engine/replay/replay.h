// SPDX-License-Identifier: Apache-2.0
// Computes one unit of a finished run again from its kept store, with all intermediate results.
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
  std::filesystem::path folder;  // folder of the output; empty = out/replay/UNIT
};

struct ReplayResult {
  std::filesystem::path folder;
  std::vector<std::string> differences;  // from what the run wrote of the unit; empty: there are none
  std::vector<Picture> pictures;         // the caller draws them into the folder
};

// Writes steps.gpkg, replay.json and the unit itself in the run's own format. The run and its store do not change.
// Throws a usage Error when there is no such unit.
ReplayResult replay(const ReplayOptions& options, Progress& progress);

// Returns one line for each unit: its name, place and size.
std::vector<std::string> units_to_replay(const KeptRunPlaces& places);

}  // namespace ilot
