// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ilot {

// Throws Error (usage) when ILOT_FORCE_ISA names no instruction set that this machine and this build have. The message
// lists those that can be named.
void check_forced_isa();

}  // namespace ilot
