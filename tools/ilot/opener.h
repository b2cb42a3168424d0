// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace ilot {

// Returns the program that opens addresses in the browser (xdg-open), found along PATH; empty where there is none.
std::string browser_opener();

}  // namespace ilot
