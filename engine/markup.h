// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <string_view>

namespace ilot {

// Text as HTML and SVG want it.
std::string escaped_markup(std::string_view text);

}  // namespace ilot
