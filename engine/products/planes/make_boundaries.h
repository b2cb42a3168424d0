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

// Those whose angular steps are known, in lattice units.
std::vector<Scanner> scanners_of(const std::vector<Station>& stations, double unit);

// Outlines of planes: planes.gpkg, the areas of the segments, the column "boundary"; density/ of the largest planes
// where it is asked for; outlines for those who hold some. Adds what `auto` stood for to the record.
void make_boundaries(const Store& store, PlanesResult& planes, const Settings& settings, const RunInputs& inputs,
                     const PassContext& context, const std::filesystem::path& folder, RunRecord& record);

}  // namespace ilot
