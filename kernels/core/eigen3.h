// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of symmetric 3 x 3 matrices. The code uses arithmetic and square roots only and does not call the maths
// library, so the bits are the same on every machine.
#pragma once
#include <array>

#include "kernels/core/types.h"

namespace ilot {

struct Symmetric3 {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

struct Eigen3 {
  std::array<double, 3> values{};  // ascending
  std::array<Vec3, 3> vectors{};   // unit, right-handed up to sign
};

// Uses cyclic Jacobi rotations to full double precision. It takes about 0.5 microseconds.
Eigen3 eigen_symmetric(const Symmetric3& m);

struct SmallestEigen {
  double value = 0;
  Vec3 vector;          // unit
  bool unique = false;  // false: the direction is undefined (two smallest values equal, or the zero matrix)
};

// Computes the smallest eigenpair of a positive semi-definite matrix. Newton's iteration on the characteristic
// polynomial starts from below, where it converges monotonically. The vector is the largest cross product of two rows.
// The relative error of the value is about 1e-14 of the trace. It takes about 40 nanoseconds.
SmallestEigen smallest_eigen(const Symmetric3& m);

}  // namespace ilot
