// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "engine/columns/run_inputs.h"
#include "engine/model/facade_opening.h"
#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_gathering.h"
#include "engine/products/planes/make_planes.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// All facades of a run. Refers to the store and the planes.
struct FacadesOfRun {
  FacadesOfRun(const Store& store, const PlanesResult& planes, const RunInputs& inputs, const PassContext& context);
  FacadesOfRun(const FacadesOfRun&) = delete;
  FacadesOfRun& operator=(const FacadesOfRun&) = delete;

  std::vector<Vec3> stations;
  std::vector<FacadeStation> steps;
  FacadeWork work;
  std::vector<WallGroup> walls;
  std::vector<FoundFacade> found;  // per wall; facade.id from 1
};

// Inspects one of the facades while they are found.
struct FacadeObserver {
  std::uint32_t facade = 0;  // its id
  FacadeSteps& steps;
  std::function<void(const RaySamples&)> look;  // receives the rays of the facade
};

// Finds the facades among the planes, each from its own points. Then finds how they join and how the points prove them.
// The planes must have their areas (make_boundaries). Begins the stage "facades". Facades whose middle is not wanted
// are left out.
std::unique_ptr<FacadesOfRun> find_facades(const Store& store, const PlanesResult& planes, const Settings& settings,
                                           const RunInputs& inputs, const PassContext& context, Progress& progress,
                                           RunRecord& record, const FacadeObserver* observer = nullptr);

// Calls find_facades and writes the column "facade". Writes the files of facade_files.h into the folder, and a page
// that shows them, facades.html. The planes must have their areas (make_boundaries). Facades whose middle is not wanted
// are left out. Returns the openings of all facades.
std::vector<FacadeOpening> make_facades(const Store& store, const PlanesResult& planes, const Settings& settings,
                                        const RunInputs& inputs, const PassContext& context,
                                        const std::filesystem::path& folder, Progress& progress, RunRecord& record);

}  // namespace ilot
