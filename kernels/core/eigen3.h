// SPDX-License-Identifier: Apache-2.0
// Eigenvalues of symmetric 3 x 3 matrices by arithmetic and square roots alone: no call into the maths library, so the
// same bits on every machine.
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

// Cyclic Jacobi rotations to full double precision; about 0.5 microseconds.
Eigen3 eigen_symmetric(const Symmetric3& m);

struct SmallestEigen {
  double value = 0;
  Vec3 vector;          // unit
  bool unique = false;  // false: the direction is undefined (two smallest values equal, or the zero matrix)
};

// The smallest eigenpair of a positive semi-definite matrix: Newton's iteration on the characteristic polynomial from
// below, where it converges monotonically, then the largest cross product of two rows. Relative error of the value
// about 1e-14 of the trace. About 40 nanoseconds.
SmallestEigen smallest_eigen(const Symmetric3& m);

}  // namespace ilot
