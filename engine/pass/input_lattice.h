// SPDX-License-Identifier: Apache-2.0
// Finds one lattice for all inputs that is no finer than their coordinates need.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/store/lattice_rows.h"
#include "engine/store/strays.h"
#include "ilot/settings.h"

namespace ilot {

// Derived: rounding to it has a standard deviation of 0.03 mm, a thirtieth of the noise of the best scanners of
// buildings (1 mm). A cell of the lattice is at most 2^21 steps long (210 m); of 0.01 mm it was 21 m, less than planes
// of sparse clouds need.
constexpr double kFinestStep = IndexSettings{}.finest_step;  // metres

// Returns the finest scale of the inputs times the greatest whole number of which all coordinates are multiples. So a
// file that is written in steps of 1e-5, but whose coordinates are whole millimetres, has the same lattice as one
// written in millimetres. The result is made coarser up to a thousandth of the unit of the CRS only, and it is never
// finer than `finest_step` (metres); there points are rounded. The decision is based on 32 short stretches of each
// input, of which a tenth may disagree; see checked_lattice. Reads nothing when every scale is a thousandth or more.
InputLattice common_lattice(const std::vector<std::unique_ptr<PointReader>>& inputs, double metres_per_unit,
                            double finest_step = kFinestStep);

// Returns the lattice that the points really need after all of them are read: the one with which they were read, or a
// finer one with which they must be read again. `off_lattice` has the places beside the lattice of each part that was
// read (LatticeRowReader::off_lattice). Strays are not considered.
InputLattice checked_lattice(const InputLattice& lattice, const std::vector<std::unique_ptr<PointReader>>& inputs,
                             std::span<const std::vector<Index3>> off_lattice, const Strays& strays,
                             double metres_per_unit, double finest_step = kFinestStep);

}  // namespace ilot
