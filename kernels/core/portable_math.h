// SPDX-License-Identifier: Apache-2.0
// The few transcendental functions that parameters need, out of plain arithmetic: the maths library's own variants
// differ between classifiers, and these values decide which points are inliers.
#pragma once

namespace ilot {

// Cosine of an angle in degrees, any finite value; error below 1e-15.
double cos_degrees(double degrees);

// The angle in degrees from 0 to 90 whose cosine is c, by bisection of cos_degrees; c is clamped to [0, 1]. Error below
// 1e-7 degrees beside 0, where the cosine is flat, and below 1e-12 elsewhere.
double degrees_of_cosine(double c);

// Natural logarithm of a positive normal number; relative error below 1e-14.
double natural_log(double v);

// e to the power of v; relative error below 1e-14. 0 below -700, where it is less than 1e-304; v at most 700.
double natural_exp(double v);

// Direction of (x, y) in degrees from the x axis towards y, from 0 to below 360; 0 for no direction. Error below 1e-12.
double direction_degrees(double x, double y);

}  // namespace ilot
