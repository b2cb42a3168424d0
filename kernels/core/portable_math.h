// SPDX-License-Identifier: Apache-2.0
// The few transcendental functions that the code needs, in plain arithmetic. The functions of the maths library differ
// between machines, and these values decide which points are inliers.
#pragma once

namespace ilot {

// Cosine of an angle in degrees, which is any finite value. The error is below 1e-15.
double cos_degrees(double degrees);

// Returns the angle in degrees from 0 to 90 whose cosine is c, by bisection of cos_degrees. c is clamped to [0, 1]. The
// error is below 1e-7 degrees near 0, where the cosine is flat, and below 1e-12 elsewhere.
double degrees_of_cosine(double c);

// Natural logarithm of a positive normal number. The relative error is below 1e-14.
double natural_log(double v);

// Returns e to the power of v, with a relative error below 1e-14. It returns 0 for v below -700, where the true value
// is less than 1e-304. v is at most 700.
double natural_exp(double v);

// Returns the direction of (x, y) in degrees from the x axis towards y, from 0 to below 360. It returns 0 for the zero
// vector. The error is below 1e-12.
double direction_degrees(double x, double y);

}  // namespace ilot
