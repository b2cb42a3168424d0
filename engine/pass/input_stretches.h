// SPDX-License-Identifier: Apache-2.0
// Divides the rows of all inputs among the tasks that read them.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/formats/rows_in_box.h"

namespace ilot {

// Rows that one task reads: a part of a random-access file, or all of any other file.
struct InputStretch {
  std::uint32_t file = 0;
  std::uint64_t first = 0, count = 0;
};

// Returns stretches of about `most` rows that begin and end where the files are cut (PointReader::boundaries): all of
// the given rows, input by input, front to back. `rows` has the ranges of each input, whole chunks; of an input
// without random access all rows are read. Small inputs are divided too, so that all threads have work. The result
// does not depend on the number of threads: a run that is resumed with another number finds its stretches again.
std::vector<InputStretch> cut_inputs(const std::vector<std::unique_ptr<PointReader>>& inputs,
                                     std::span<const std::vector<RowRange>> rows, std::uint64_t most);

// Only these fields are read of all inputs from here on (PointReader::limit_to).
void limit_inputs(const std::vector<std::unique_ptr<PointReader>>& inputs, std::uint32_t fields);

}  // namespace ilot
