// SPDX-License-Identifier: Apache-2.0
// Labels as one file of NumPy's format NPY 1.0: a structured array, which NumPy maps into memory.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/formats/writer.h"

namespace ilot {

constexpr const char* kNpyExtension = ".npy";

// Takes rows like every writer and writes the appended fields of each (spec.appended) as a record of packed
// little-endian values. spec.like.points is the number of rows that will come; finish() throws when others came.
std::unique_ptr<PointWriter> create_npy(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
