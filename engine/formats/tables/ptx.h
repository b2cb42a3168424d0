// SPDX-License-Identifier: Apache-2.0
// PTX, the text format of gridded terrestrial scans: blocks of columns, rows, scanner position, axes, a 4 x 4 matrix,
// and one line for each cell of the grid.
#pragma once
#include <memory>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// Points are moved by the matrix of their block (row vectors: p' = p M). The point source id is the number of the block
// from 1. Intensities from 0 to 1 are scaled to 16 bits, colours are multiplied by 257. Cells without a return (0 0 0)
// and lines that are not numbers are rejected rows. Stations are the positions of the scanners.
//
// The file is read front to back by one thread; opening reads it once to count. A block whose lines or header are
// missing or damaged ends the file: everything before it is kept, with a warning. Throws Error when the first block is
// not PTX.
std::unique_ptr<PointReader> open_ptx(std::unique_ptr<InputFile> file, const OpenOptions& options = {});

}  // namespace ilot
