// SPDX-License-Identifier: Apache-2.0
// What the environment asks for. Programs check it once at their start, because kernels report no faults.
#pragma once
#include <string>
#include <vector>

namespace ilot::simd {

// The names of the instruction sets that this machine and this build have, from the baseline to the best.
std::vector<std::string> available_isas();

// Returns the value of ILOT_FORCE_ISA if it is not one of available_isas(), else an empty text. chosen_isa() is the
// baseline then. A variable that is empty asks for nothing.
std::string unavailable_forced_isa();

}  // namespace ilot::simd
