// SPDX-License-Identifier: Apache-2.0
// What a task does with points that go to the merge: it reads and sorts those of the cells that its area owns, and
// searches planes in them where a product needs planes.
#pragma once
#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/report/progress.h"
#include "engine/scale/plan.h"
#include "engine/scale/records.h"
#include "engine/store/store.h"

namespace ilot {

// The points around the cells of an area that are read, in lattice steps. For planes: the margin of the largest cells,
// and the neighbours from which normals in it follow. For labels of roofs: those from which the roles in them follow.
std::int64_t halo_of_cells(const Plan& plan, double unit_metres);

// Works on the cells whose corner lies in area.own, with the functions of a run, and adds each as a record. `inputs`
// are those of area.inputs; where labels of roofs are carried the store has the column "role". Returns the number of
// cells.
std::uint64_t write_cells(const Store& store, const RunInputs& inputs, const Plan& plan, const PlanArea& area,
                          const PassContext& context, Progress& progress, RecordFileWriter& part);

}  // namespace ilot
