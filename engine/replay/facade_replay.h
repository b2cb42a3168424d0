// SPDX-License-Identifier: Apache-2.0
// A facade found again from its points.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/model/layer.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

// A point of a facade in the wall's axes, with what its ray tells of the wall.
struct WallPoint {
  Vec3 at;         // metres: along the wall, up, out of it
  Place2 crossed;  // where its ray crosses the wall
  std::uint32_t plane = 0;
  bool on_wall = false;
  RayOutcome met{};
};

// Everything that was found of a facade.
struct FacadeReplay {
  Facade facade;  // as it is drawn
  FacadeSite site;
  FacadeSteps steps;
  std::vector<WallPoint> points;     // all of it, or some of very many
  std::uint64_t changed_labels = 0;  // points that the column "facade" says something else of
};

// Facades depend on each other at corners and storeys, so all of the run are found again. Throws a usage Error when the
// run had no such facade.
FacadeReplay replay_facade(const KeptRun& run, const std::string& id, Progress& progress);

// What of it is not as the run wrote it to facades/ and to the column "facade"; none: all is the same.
std::vector<std::string> differences_of(const FacadeReplay& facade, const KeptRun& run);

// The steps as tables in the wall's axes: wall, rings, points, cells, searches, found, drawn, elements.
std::vector<Layer> layers_of(const FacadeReplay& facade);

std::vector<Picture> pictures_of(const FacadeReplay& facade);

// Names, places and sizes of the facades in facades/.
std::vector<std::string> facades_to_replay(const std::filesystem::path& out);

}  // namespace ilot
