// SPDX-License-Identifier: Apache-2.0
// The files that people receive of the facades of a run.
#pragma once
#include <filesystem>

#include "engine/products/facades/make_facades.h"

namespace ilot {

// Writes the files of each facade (facade_files.h), several at once, and a sheet of each row of houses into the folder.
// Reads the colours of the points for the images where an input has them. O(points of the facades).
void write_facade_drawings(const FacadesOfRun& run, const Settings& settings, const RunInputs& inputs,
                           const PassContext& context, const std::filesystem::path& folder, Progress& progress);

}  // namespace ilot
