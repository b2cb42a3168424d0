// SPDX-License-Identifier: Apache-2.0
// The unit that scenes of whole numbers and the clouds of most scenes are in.
#pragma once

namespace ilot::scan {

inline constexpr double kUnit = 0.001;  // metres for one step of a coordinate

}  // namespace ilot::scan
