// SPDX-License-Identifier: Apache-2.0
// Texts in PDF files: the font is Helvetica, which every reader has, with the letters of Windows code page 1252.
#pragma once
#include <string>

namespace ilot {

constexpr double kCapitalOfHelvetica = 0.718;  // height of a capital letter, in font sizes

// Letters as they stand between the brackets of a PDF string, and how wide they are. Letters that are not Western
// European become "?".
struct PdfLetters {
  std::string escaped;
  double width = 0;  // in font sizes
};
PdfLetters pdf_letters(const std::string& text);

}  // namespace ilot
