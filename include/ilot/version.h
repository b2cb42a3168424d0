// SPDX-License-Identifier: Apache-2.0
// What this build is, as found when it was configured. Constant time, safe from any thread, never throws Error.
//
//   std::printf("ilot %s, %s\n", ilot::version().c_str(), ilot::git_hash().c_str());
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace ilot {

std::string version();     // "0.1.0"
std::string git_hash();    // 40 digits, or "unknown" outside a checkout
std::string compiler();    // "GNU 12.2.0"
std::string build_type();  // "Release"

// Name and version of each library that this build uses, by name.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace ilot
