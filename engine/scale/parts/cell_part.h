// SPDX-License-Identifier: Apache-2.0
// What a task does for all products but roofs: it reads and sorts the points of the cells that its area owns, and
// searches planes in them where a product needs planes.
#pragma once
#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/report/progress.h"
#include "engine/scale/plan.h"
#include "engine/scale/records.h"
#include "engine/store/store.h"

namespace ilot {

// The points around the cells of an area that the search in these cells reads, in lattice steps: the margin of the
// largest cells, and the neighbours from which normals in it follow.
std::int64_t halo_of_cells(const Settings& settings, double unit_metres);

// Works on the cells whose corner lies in area.own, with the functions of a run, and adds each as a record. `inputs`
// are those of area.inputs. Returns the number of cells.
std::uint64_t write_cells(const Store& store, const RunInputs& inputs, const Plan& plan, const PlanArea& area,
                          const PassContext& context, Progress& progress, RecordFileWriter& part);

}  // namespace ilot
