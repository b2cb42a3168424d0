// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/products/planes/make_planes.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// The stations whose angular steps are known, in lattice units.
std::vector<Scanner> scanners_of(const std::vector<Station>& stations, double unit);

// Makes the outlines of planes: planes.gpkg, the areas of the segments, and the column "boundary". Writes density/ of
// the largest planes where it is asked for. Keeps outlines in `planes` where a later product needs them. Adds the
// values that were used for `auto` to the record.
void make_boundaries(const Store& store, PlanesResult& planes, const Settings& settings, const RunInputs& inputs,
                     const PassContext& context, const std::filesystem::path& folder, RunRecord& record);

}  // namespace ilot
