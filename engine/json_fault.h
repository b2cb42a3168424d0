// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

namespace ilot {

// Returns the message of an exception of the JSON library without its number in brackets, for the user.
inline std::string json_fault(const std::string& what) {
  const std::size_t end = what.starts_with('[') ? what.find("] ") : std::string::npos;
  return end == std::string::npos ? what : what.substr(end + 2);
}

}  // namespace ilot
