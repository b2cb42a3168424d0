// SPDX-License-Identifier: Apache-2.0
// One lattice for all inputs, no finer than their coordinates need.
#pragma once
#include <memory>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/store/sorted_run.h"
#include "engine/store/strays.h"

namespace ilot {

constexpr double kFinestStep = 1e-5;  // metres

// The finest scale of the inputs, times the largest whole number that all coordinates are multiples of: a file written
// in steps of 1e-5 whose coordinates are whole millimetres has the lattice of one written in millimetres. Made coarser
// up to a thousandth of the unit of the CRS only, and finer than `finest_step` (metres) never: there points are
// rounded. Judged by 32 short stretches of each input, of which a tenth may disagree; see checked_lattice. Reads
// nothing where every scale is a thousandth or more.
InputLattice common_lattice(const std::vector<std::unique_ptr<PointReader>>& inputs, double metres_per_unit,
                            double finest_step = kFinestStep);

// The lattice that the points really need, once all are read: the one they were read with, or a finer one, with which
// they must be read again. Points that stand alone are not asked.
InputLattice checked_lattice(const InputLattice& lattice, const std::vector<std::unique_ptr<PointReader>>& inputs,
                             const std::vector<SortedRun>& runs, const Strays& strays, double metres_per_unit,
                             double finest_step = kFinestStep);

}  // namespace ilot
