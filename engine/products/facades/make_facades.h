// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/products/planes/make_planes.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

// Facades among the planes, each drawn from its own points, to the files of facade_files.h in the folder and a page,
// facades.html, over them. The planes have their areas (make_boundaries). Facades whose middle is not wanted are left
// out.
void make_facades(const Store& store, const PlanesResult& planes, const Settings& settings, const RunInputs& inputs,
                  const PassContext& context, const std::filesystem::path& folder, Progress& progress,
                  RunRecord& record);

}  // namespace ilot
