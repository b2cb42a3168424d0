// SPDX-License-Identifier: Apache-2.0
// Writes the labels into copies of the input clouds: each copy has the order and all fields of its input, and the
// labels after these.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/reader.h"
#include "engine/labels/row_labels.h"
#include "engine/pass/context.h"
#include "engine/store/store.h"

namespace ilot {

// Throws Error where the rows of an input are too long to be compressed within the memory budget: rows of 335 bytes
// need 20 MiB, the longest rows 100 MiB. Call it before the work begins.
void check_labelled_clouds(const std::vector<std::unique_ptr<PointReader>>& inputs, const PassContext& context);

// The file name of the labelled cloud of each input. Inputs with equal names get the name of their folder in front, and
// a number at the end if that is equal too.
std::vector<std::string> labelled_names(const std::vector<std::unique_ptr<PointReader>>& inputs);
std::vector<std::string> labelled_names(std::span<const std::filesystem::path> clouds);  // of files alone

struct LabelledCloudParams {
  PassContext context = {};
  bool classes = false;  // true: points of the classes 0 and 1 with a label get class 2 (ground) or 6 (building)
  const RowsInMemory* rows = nullptr;  // none: the labels are read from the columns that rows_pass wrote
};

// Writes the labelled cloud of one input, whose rows have the number `file` in the store. Returns the number of points
// with a label.
std::uint64_t write_labelled_cloud(const Store& store, PointReader& input, std::uint32_t file,
                                   std::span<const ProductLabels> products, const std::filesystem::path& path,
                                   const LabelledCloudParams& params);

// Writes a compressed file folder/NAME for every input, with NAME from labelled_names(); of a cloud in memory the
// labels alone, as an array. Returns the number of points with a label.
std::uint64_t write_labelled_clouds(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                                    std::span<const ProductLabels> products, const std::filesystem::path& folder,
                                    const LabelledCloudParams& params);

}  // namespace ilot
