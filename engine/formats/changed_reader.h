// SPDX-License-Identifier: Apache-2.0
// Readers around other readers: the same rows with coordinates that the engine can work with.
#pragma once
#include <memory>

#include "engine/formats/reader.h"

namespace ilot {

// Heights in the unit of x and y: scale and offset of z are multiplied by `factor` (units of x and y per unit of z),
// the records stay as they are.
std::unique_ptr<PointReader> with_heights_in_unit(std::unique_ptr<PointReader> reader, double factor);

// The reader whose layout and CRS are those of its records: that within, where heights are in another unit.
const PointReader& reader_of_records(const PointReader& reader);

// Places moved from one CRS to another by PROJ; all else stays. The records have a scale of 1 mm in x and y (0.1 mm
// where the input's is finer than 0.5 mm) and an offset on a raster of 1000 units; z keeps its scale and offset unless
// PROJ changes heights. Rows that PROJ cannot move, or that 32 bits do not reach, are not valid. `near` (in the source
// CRS) is a place of the cloud. Throws Error when PROJ knows no way.
std::unique_ptr<PointReader> reprojected(std::unique_ptr<PointReader> reader, const Crs& source, const Crs& target,
                                         Vec3 near);

}  // namespace ilot
