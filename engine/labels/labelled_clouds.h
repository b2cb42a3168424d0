// SPDX-License-Identifier: Apache-2.0
// Labels back to the clouds they came from: every input again, in its own order and with all its fields, ours behind.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"
#include "engine/labels/row_labels.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// Throws Error where the rows of an input are too long to be compressed within the budget: those of 335 bytes need 20
// MiB, the longest 100. To be called before the work.
void check_labelled_clouds(const std::vector<std::unique_ptr<PointReader>>& inputs, const PassContext& context);

// The file name of each input's labelled cloud. Inputs of equal name get their folder's name in front, and a number
// behind where that is equal too.
std::vector<std::string> labelled_names(const std::vector<std::unique_ptr<PointReader>>& inputs);

// Writes a compressed folder/NAME for every input, NAME of labelled_names(). Returns the number of points with a plane,
// a unit, an object or a label.
std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    const LabelParams& params, const std::filesystem::path& folder,
                                    const PassContext& context);

}  // namespace ilot
