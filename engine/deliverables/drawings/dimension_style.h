// SPDX-License-Identifier: Apache-2.0
// What dimensions look like, in millimetres of paper: for their picture, and for programs that draw them anew.
#pragma once

namespace ilot {

constexpr double kDimensionText = 1.8;    // height of the digits
constexpr double kDimensionTick = 0.8;    // a stroke goes so far to all sides
constexpr double kDimensionOffset = 2;    // from the measured place to where its line begins
constexpr double kDimensionBeyond = 1.2;  // lines of measured places go so far beyond the line of the dimension
constexpr double kDimensionGap = 0.8;     // between that line and the digits

}  // namespace ilot
