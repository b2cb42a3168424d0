// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

namespace ilot::scan {

// Returns the content of distributions.csv as it was when the program was built.
std::string_view distributions_text();

}  // namespace ilot::scan
