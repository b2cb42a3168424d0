// SPDX-License-Identifier: Apache-2.0
// E57, the exchange format of terrestrial scanners: several scans in one file, each with its pose. (ASTM E2807-11)
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// Rows are the points of the scans, one scan after the other, in world coordinates. Points are cartesian or spherical
// and are moved by the pose of their scan. The point source id is the number of the scan from 1. Intensity and colours
// are stretched from their limits to 16 bits. rowIndex, columnIndex, timeStamp (seconds, as in the scan) and normals
// (rotated by the pose) become extra bytes; other fields are left out with a warning. Points in an invalid state are
// rejected rows. Stations are the poses.
//
// The file is read front to back by one thread. Opening reads the file once and tests the checksums of all pages that
// contain points. A damaged page ends its scan, with a warning, and info().points counts the complete points. At most
// 16 MiB of points and the XML section (at most 16 MiB) are in memory. Throws Error when the header or the XML is
// damaged or no point can be read.
std::unique_ptr<PointReader> open_e57(std::unique_ptr<InputFile> file);

bool looks_like_e57(std::span<const std::byte> beginning);

}  // namespace ilot
