// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_tags.h"

#include "engine/markup.h"

namespace ilot {

std::string dxf_text(const std::string& text) {
  std::string safe;
  for (const char32_t code : code_points(clean_text(text))) {
    if (code == '^')
      safe += "^ ";
    else if (code == '%' && safe.ends_with('%'))
      safe += " %";
    else if (code > 0xFFFF)
      safe += "\\U+FFFD";
    else if (code >= 0x7F || code == '\\')
      safe += fmt::format("\\U+{:04X}", static_cast<std::uint32_t>(code));
    else
      safe += static_cast<char>(code);
  }
  return safe;
}

}  // namespace ilot
