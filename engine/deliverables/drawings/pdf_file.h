// SPDX-License-Identifier: Apache-2.0
// PDF files. ilot has its own writer because the format needs only pages of path operators here: the available library
// (cairo) writes the time into files and supports no layers. The same objects give the same bytes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ilot {

constexpr double kPointsPerMm = 72 / 25.4;

// Writes PDF 1.5. The objects are numbered from 1 in their order. The first one is the catalogue; `info` is the number
// of the one that has the title.
std::string pdf_file(const std::vector<std::string>& objects, std::size_t info);

// The content of a stream as an object.
std::string pdf_stream(const std::string& content);

// The object with the title and the program.
std::string pdf_info(const std::string& title);

// An image whose pixels are places in a palette, rows from the top.
struct PdfImage {
  std::uint32_t width = 0, height = 0;
  std::span<const std::array<std::uint8_t, 3>> palette;  // red, green, blue
  std::string_view pixels;                               // a byte for each
};

constexpr double kClearOpacity = 0.25;  // of fills in the graphics state /Clear

// A page of paper. Operators have millimetres from the lower left corner; /F1 is Helvetica, the graphics states
// /Clear and /Solid are fills of kClearOpacity and of full opacity, and /Image is the image, where there is one.
struct PdfPage {
  double width_mm = 0, height_mm = 0;
  std::string content;
  std::optional<PdfImage> image = {};
};

// Pages are compressed as they come, so that the memory is that of the file and of one page.
class PdfBook {
 public:
  void add(const PdfPage& page);
  std::string file(const std::string& title) &&;

 private:
  std::vector<std::string> objects_;  // of the pages: page, content, image
};

}  // namespace ilot
