// SPDX-License-Identifier: Apache-2.0
// Reconstructs a facade again from its points.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/model/layer.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/replay/kept_run.h"
#include "engine/replay/picture.h"

namespace ilot {

// A point of a facade in the axes of the wall, with what its ray shows of the wall.
struct WallPoint {
  Vec3 at;         // metres: along the wall, up, out of it
  Place2 crossed;  // where its ray crosses the wall
  std::uint32_t plane = 0;
  bool on_wall = false;
  RayOutcome met{};
};

// All intermediate results of a facade.
struct FacadeReplay {
  Facade facade;  // as it is drawn
  FacadeSite site;
  FacadeSteps steps;
  std::vector<WallPoint> points;     // all points, or a part of them when there are very many
  std::uint64_t changed_labels = 0;  // points that have another value in the column "facade"
};

// Facades depend on each other at corners and storeys, so all facades of the run are reconstructed again. Throws a
// usage Error when the run has no such facade.
FacadeReplay replay_facade(const KeptRun& run, const std::string& id, Progress& progress);

// Returns the differences from what the run wrote to facades/ and to the column "facade"; empty: there are none.
std::vector<std::string> differences_of(const FacadeReplay& facade, const KeptRun& run);

// Returns the steps as tables in the axes of the wall: wall, rings, points, cells, searches, found, drawn, elements.
std::vector<Layer> layers_of(const FacadeReplay& facade);

std::vector<Picture> pictures_of(const FacadeReplay& facade);

// Returns names, places and sizes of the facades in facades/.
std::vector<std::string> facades_to_replay(const std::filesystem::path& out);

}  // namespace ilot
