// SPDX-License-Identifier: Apache-2.0
// Reconstructs a building again from its points.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/layer.h"
#include "engine/products/roofs/roof_setup.h"
#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

// All intermediate results of a building.
struct BuildingReplay {
  PlannedSite planned;
  std::vector<PlannedSite> around;  // other outlines within reach
  std::vector<AroundPoint> points;  // all points that were used, or a part of them when there are very many
  SiteSteps steps;
  SiteResult result;
  CityJsonParams file;
};

// Throws a usage Error when the run has no such building.
BuildingReplay replay_building(const KeptRun& run, const std::string& id, Progress& progress);

// Returns the differences from what the run wrote to roofs/ and to the column "roof"; empty: there are none.
std::vector<std::string> differences_of(const BuildingReplay& building, const KeptRun& run,
                                        const std::filesystem::path& model);

// Returns the steps as tables: building, outlines, points, planes, lines, cells, faces, solid.
std::vector<Layer> layers_of(const BuildingReplay& building);

// Returns the steps as pictures, seen from above, in metres from the anchor of the outline, and the solid seen from the
// side.
std::vector<Picture> pictures_of(const BuildingReplay& building);

// Returns names, places and sizes of the buildings in roofs/.
std::vector<std::string> buildings_to_replay(const std::filesystem::path& out, double metres_per_unit);

}  // namespace ilot
