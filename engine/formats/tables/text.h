// SPDX-License-Identifier: Apache-2.0
// Text: .xyz .txt .csv .pts .asc in any dialect, with or without a line of column names or a line with the count.
#pragma once
#include <filesystem>
#include <memory>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"
#include "engine/formats/writer.h"

namespace ilot {

// Without names, columns are x y z, then they depend on their number: 4: intensity; 6: red green blue, or a normal when
// no value exceeds 1; 7: intensity and colours. Other columns have their number as name. In .pts files intensities
// range from -2048 to 2047 and are stored as (i + 2048) * 16, and a later line with a single count begins another
// block. Throws Error when no columns x, y and z are found, with ExitCode::usage when the beginning (1000 rows) can be
// read in two ways. Later rows in another dialect or with another number of columns are rejected.
std::unique_ptr<PointReader> open_text(std::unique_ptr<InputFile> file, const OpenOptions& options = {});

// Writes comma separated values with a line of names: world coordinates, standard fields, then extra bytes. Every
// number is the shortest one that is read back as the same double (coordinates: raw * scale + offset).
std::unique_ptr<PointWriter> create_csv(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
