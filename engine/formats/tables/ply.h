// SPDX-License-Identifier: Apache-2.0
// PLY, ascii and binary of either byte order. The element "vertex" has the points; other elements are skipped.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

// Binary files are random access, ascii files are read front to back. Throws Error when the header is not understood,
// or when vertices have lists or lack x, y or z.
std::unique_ptr<PointReader> open_ply(std::unique_ptr<InputFile> file);

// Writes binary little endian: x, y, z as double, then the standard fields and extra bytes; 64-bit integers become
// doubles.
std::unique_ptr<PointWriter> create_ply(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
