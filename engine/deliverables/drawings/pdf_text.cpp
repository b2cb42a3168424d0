// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/pdf_text.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {
namespace {

// Widths of the letters from the blank to the tilde, in thousandths of the font size (Adobe's metrics of Helvetica).
constexpr std::array<int, 95> kWidths{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                      556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                      1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                      667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                      333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                      556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
constexpr int kOtherWidth = 556;

// Returns the byte of Windows code page 1252.
unsigned char western(char32_t code) {
  constexpr std::array<std::pair<char32_t, unsigned char>, 10> kBeyond{{{0x20AC, 0x80},
                                                                        {0x2026, 0x85},
                                                                        {0x0152, 0x8C},
                                                                        {0x2018, 0x91},
                                                                        {0x2019, 0x92},
                                                                        {0x201C, 0x93},
                                                                        {0x201D, 0x94},
                                                                        {0x2013, 0x96},
                                                                        {0x2014, 0x97},
                                                                        {0x0153, 0x9C}}};
  if ((code >= 32 && code < 127) || (code >= 0xA0 && code < 0x100)) return static_cast<unsigned char>(code);
  for (const auto& [from, to] : kBeyond)
    if (code == from) return to;
  return '?';
}

}  // namespace

PdfLetters pdf_letters(const std::string& text) {
  PdfLetters letters;
  int width = 0;
  for (const char32_t code : code_points(clean_text(text))) {
    const unsigned char letter = western(code);
    width += letter >= 32 && letter < 127 ? kWidths[letter - 32u] : kOtherWidth;
    if (letter == '(' || letter == ')' || letter == '\\') letters.escaped += '\\';
    letters.escaped += letter < 127 ? std::string(1, static_cast<char>(letter)) : fmt::format("\\{:03o}", letter);
  }
  letters.width = width / 1000.0;
  return letters;
}

}  // namespace ilot
