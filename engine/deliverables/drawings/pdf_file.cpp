// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/pdf_file.h"

#include <fmt/format.h>

#include "engine/compressed.h"
#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/pdf_text.h"

namespace ilot {
namespace {

// Of a book: catalogue, pages, font, information; then three objects for each page.
constexpr std::size_t kInfo = 4, kFirstPage = 5, kOfPage = 3;

// A compressed stream; `entries` are those of its dictionary beside the length and the filter.
std::string packed_stream(const std::string& entries, std::string_view content) {
  const std::string data = compressed(content);
  return fmt::format("<<{}/Filter /FlateDecode /Length {}>>\nstream\n{}\nendstream", entries, data.size(), data);
}

std::string image_object(const PdfImage& image) {
  std::string palette;
  for (const auto& colour : image.palette)
    for (const std::uint8_t part : colour) palette += fmt::format("{:02x}", part);
  return packed_stream(
      fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /BitsPerComponent 8 /ColorSpace [/Indexed "
                  "/DeviceRGB {} <{}>] ",
                  image.width, image.height, image.palette.size() - 1, palette),
      image.pixels);
}

}  // namespace

// Writes the objects in their order, then the place where each begins.
std::string pdf_file(const std::vector<std::string>& objects, std::size_t info) {
  std::string file = "%PDF-1.5\n%\xE2\xE3\xCF\xD3\n";
  std::string table = fmt::format("xref\n0 {}\n0000000000 65535 f \n", objects.size() + 1);
  for (std::size_t i = 0; i < objects.size(); ++i) {
    table += fmt::format("{:010} 00000 n \n", file.size());
    file += fmt::format("{} 0 obj\n{}\nendobj\n", i + 1, objects[i]);
  }
  const std::size_t begin = file.size();
  file += table;
  file += fmt::format("trailer\n<</Size {} /Root 1 0 R /Info {} 0 R>>\nstartxref\n{}\n%%EOF\n", objects.size() + 1,
                      info, begin);
  return file;
}

std::string pdf_stream(const std::string& content) {
  return fmt::format("<</Length {}>>\nstream\n{}endstream", content.size(), content);
}

std::string pdf_info(const std::string& title) {
  return "<</Title (" + pdf_letters(title).escaped + ") /Producer (ilot)>>";
}

void PdfBook::add(const PdfPage& page) {
  const std::size_t number = kFirstPage + objects_.size();
  const std::string scale = decimal(kPointsPerMm, 6);
  objects_.push_back(fmt::format(
      "<</Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents {} 0 R /Resources <</Font <</F1 3 0 R>> /ExtGState "
      "<</Clear <</ca {}>> /Solid <</ca 1>>>>{}>>>>",
      decimal(page.width_mm * kPointsPerMm, 3), decimal(page.height_mm * kPointsPerMm, 3), number + 1,
      decimal(kClearOpacity, 2), page.image ? fmt::format(" /XObject <</Image {} 0 R>>", number + 2) : ""));
  objects_.push_back(packed_stream("", scale + " 0 0 " + scale + " 0 0 cm 1 J 1 j\n" + page.content));
  objects_.push_back(page.image ? image_object(*page.image) : "null");
}

std::string PdfBook::file(const std::string& title) && {
  std::string kids;
  for (std::size_t i = 0; i < objects_.size(); i += kOfPage) kids += fmt::format("{} 0 R ", kFirstPage + i);
  const std::array<std::string, 4> head{
      "<</Type /Catalog /Pages 2 0 R>>",
      fmt::format("<</Type /Pages /Kids [{}] /Count {}>>", kids, objects_.size() / kOfPage),
      "<</Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding>>", pdf_info(title)};
  objects_.insert(objects_.begin(), head.begin(), head.end());
  return pdf_file(objects_, kInfo);
}

}  // namespace ilot
