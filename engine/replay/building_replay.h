// SPDX-License-Identifier: Apache-2.0
// A building made again from its points.
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

// Everything that was found of a building.
struct BuildingReplay {
  PlannedSite planned;
  std::vector<PlannedSite> around;  // other outlines within reach
  std::vector<AroundPoint> points;  // all that were looked at, or some of very many
  SiteSteps steps;
  SiteResult result;
  CityJsonParams file;
};

// Throws a usage Error when the run had no such building.
BuildingReplay replay_building(const KeptRun& run, const std::string& id, Progress& progress);

// What of it is not as the run wrote it to roofs/ and to the column "roof"; none: all is the same.
std::vector<std::string> differences_of(const BuildingReplay& building, const KeptRun& run,
                                        const std::filesystem::path& model);

// The steps as tables: building, outlines, points, planes, lines, cells, faces, solid.
std::vector<Layer> layers_of(const BuildingReplay& building);

// The same as pictures, seen from above, in metres from the outline's anchor; and the solid from aside.
std::vector<Picture> pictures_of(const BuildingReplay& building);

// Names, places and sizes of the buildings in roofs/.
std::vector<std::string> buildings_to_replay(const std::filesystem::path& out, double metres_per_unit);

}  // namespace ilot
