// SPDX-License-Identifier: Apache-2.0
// Readers that wrap other readers: they give the same rows with coordinates that the engine can use.
#pragma once
#include <memory>

#include "engine/formats/reader.h"

namespace ilot {

// Says that the records are in this CRS, whatever the cloud itself says. The records do not change.
std::unique_ptr<PointReader> in_crs(std::unique_ptr<PointReader> reader, const Crs& crs);

// Converts heights to the unit of x and y. Scale and offset of z are multiplied by `factor` (units of x and y per unit
// of z); the records do not change.
std::unique_ptr<PointReader> with_heights_in_unit(std::unique_ptr<PointReader> reader, double factor);

// Returns the reader whose layout and CRS are those of the records. For heights in another unit this is the wrapped
// reader.
const PointReader& reader_of_records(const PointReader& reader);

// Returns the reader that opened the file, where the records are those of the file.
const PointReader& reader_of_file(const PointReader& reader);

// Moves places from one CRS to another with PROJ; everything else stays. The records have a scale of 1 mm in x and y
// (0.1 mm where the scale of the input is finer than 0.5 mm) and an offset on a raster of 1000 units. Unless PROJ
// changes heights, only their unit becomes that of the target; z keeps its steps. Rows are not valid when PROJ cannot
// move them or when 32 bits are not enough. `near` (in the source CRS) is a place of the cloud. Throws Error when PROJ
// knows no transformation.
std::unique_ptr<PointReader> reprojected(std::unique_ptr<PointReader> reader, const Crs& source, const Crs& target,
                                         Vec3 near);

}  // namespace ilot
