// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace ilot {

// Returns the bytes compressed by zlib (RFC 1950). The same bytes and library give the same. Throws Error without
// memory.
std::string compressed(std::string_view bytes);

}  // namespace ilot
