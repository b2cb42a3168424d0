// SPDX-License-Identifier: Apache-2.0
// The few functions of mathematics a scene needs, made of IEEE basic operations only: libm's sin, tan and log
// differ between classifiers, and the same seed must give the same file everywhere.
#pragma once
#include <cstdint>

#include "kernels/core/rng.h"

namespace ilot::scan {

struct SinCos {
  double sin = 0, cos = 1;
};

// Sine and cosine of an angle in degrees within [-180, 180]; error below 1e-12.
SinCos sin_cos_deg(double degrees);

// Tangent of an angle in degrees within (-90, 90).
double tan_deg(double degrees);

// Angle in degrees whose tangent is given, for |tangent| <= 1; error below 1e-9 degrees.
double atan_deg(double tangent);

// A random number with mean 0 and variance 1, close to normal within four standard deviations and never
// beyond six: the sum of twelve uniform numbers of 16 bits. Takes three draws.
double gaussian(Rng& rng);

}  // namespace ilot::scan
