// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace ilot {

// Returns the message of the system for a file operation that failed with this errno, and what can be done: "No space
// left on device; free some space or choose another disk".
std::string system_reason(int error);

}  // namespace ilot
