// SPDX-License-Identifier: Apache-2.0
// The text of DXF: group codes with their values.
#pragma once
#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {

constexpr int kCoordinateDecimals = 5;

// Writes group codes and values, one on each line.
class DxfTags {
 public:
  void add(int code, std::string_view value) { text_ += fmt::format("{:3}\n{}\n", code, value); }
  void add(int code, int value) { text_ += fmt::format("{:3}\n{}\n", code, value); }
  void number(int code, double value, int decimals = kCoordinateDecimals) { add(code, decimal(value, decimals)); }
  void point(int code, double x, double y) {
    number(code, x);
    number(code + 10, y);
  }
  void point3(int code, double x, double y) {
    point(code, x, y);
    number(code + 20, 0);
  }
  void handle(unsigned handle, int code = 5) { add(code, fmt::format("{:X}", handle)); }
  // Writes codes and words alternately: "0 SECTION 2 HEADER".
  void words(std::initializer_list<std::pair<int, const char*>> words) {
    for (const auto& [code, word] : words) add(code, word);
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

// Strings in R2000 use a code page; characters beyond ASCII are written as \U+XXXX. A backslash could begin such a
// sequence, a caret a control character, two percent signs a symbol.
std::string dxf_text(const std::string& text);

}  // namespace ilot
