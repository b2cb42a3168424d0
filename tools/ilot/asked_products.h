// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

namespace ilot {

// Returns what --products asks for in the order of the names, each name once, so that a result does not depend on how
// it was asked for. Throws Error with ExitCode::usage where a name is that of no product, or where there is none.
std::vector<std::string> asked_products(std::vector<std::string> given);

}  // namespace ilot
