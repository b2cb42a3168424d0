// SPDX-License-Identifier: Apache-2.0
// PTX, the text format of gridded terrestrial scans: blocks of columns, rows, scanner position, axes, a 4 x 4 matrix,
// and a line per cell of the grid.
#pragma once
#include <memory>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// Points are moved by the matrix of their block (row vectors: p' = p M); point source id is the block's number from 1.
// Intensities from 0 to 1 become 16 bits, colours are multiplied by 257. Cells without a return (0 0 0) and lines that
// are not numbers are rejected rows. Stations: the scanners' positions.
//
// Read front to back by one thread; opening reads the file once to count. A block whose lines or head are missing or
// damaged ends the file: what stands before is kept, with a warning. Throws Error when the first block is no PTX.
std::unique_ptr<PointReader> open_ptx(std::unique_ptr<InputFile> file, const OpenOptions& options = {});

}  // namespace ilot
