// SPDX-License-Identifier: Apache-2.0
// E57, the exchange format of terrestrial scanners: several scans in one file, each with its pose. (ASTM E2807-11)
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// Rows are the points of the scans one after the other, in world coordinates: cartesian or spherical, moved by the pose
// of their scan. Point source id: number of the scan from 1. Intensity and colours are stretched from their limits to
// 16 bits. rowIndex, columnIndex, timeStamp (seconds, as in the scan) and normals (turned by the pose) become extra
// bytes; other fields are left out with a warning. Points in an invalid state are rejected rows. Stations: the poses.
//
// Read front to back by one thread. Opening reads the file once and tests the checksums of all pages that hold points:
// a damaged page ends its scan, with a warning, and info().points counts what is whole. Holds at most 16 MiB of points
// and the XML section (at most 16 MiB). Throws Error when header or XML are damaged or no point can be read.
std::unique_ptr<PointReader> open_e57(std::unique_ptr<InputFile> file);

bool looks_like_e57(std::span<const std::byte> beginning);

}  // namespace ilot
