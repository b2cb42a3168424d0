// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace ilot {

// Returns text that is escaped for HTML and SVG.
std::string escaped_markup(std::string_view text);

}  // namespace ilot
