// SPDX-License-Identifier: Apache-2.0
// The few mathematical functions that a scene needs, made of basic IEEE operations only. The sin, tan and log of libm
// differ between machines, but the same seed must give the same file everywhere.
#pragma once
#include <cstdint>

#include "kernels/core/rng.h"

namespace ilot::scan {

struct SinCos {
  double sin = 0, cos = 1;
};

// Returns the sine and cosine of an angle in degrees within [-180, 180]. The error is below 1e-12.
SinCos sin_cos_deg(double degrees);

// Returns the tangent of an angle in degrees within (-90, 90).
double tan_deg(double degrees);

// Returns the angle in degrees that has the given tangent, for |tangent| <= 1. The error is below 1e-9 degrees.
double atan_deg(double tangent);

// Returns a random number with mean 0 and variance 1. It is the sum of twelve uniform numbers of 16 bits, so it is
// close to normal within four standard deviations and never beyond six. The function takes three draws from rng.
double gaussian(Rng& rng);

}  // namespace ilot::scan
