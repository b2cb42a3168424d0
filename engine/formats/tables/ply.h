// SPDX-License-Identifier: Apache-2.0
// PLY, ascii and binary of either byte order. The element "vertex" holds the points; other elements are skipped.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

// Binary files are random access, ascii ones are read front to back. Throws Error when the header is not understood,
// vertices have lists or no x, y and z.
std::unique_ptr<PointReader> open_ply(std::unique_ptr<InputFile> file);

// Binary little endian: double x, y, z, then the standard fields and extra bytes; 64-bit integers become doubles.
std::unique_ptr<PointWriter> create_ply(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
