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

std::string image_object(const PdfImage& image) {
  std::string palette;
  for (const auto& colour : image.palette)
    for (const std::uint8_t part : colour) palette += fmt::format("{:02x}", part);
  const std::string data = compressed(image.pixels);
  return fmt::format(
      "<</Type /XObject /Subtype /Image /Width {} /Height {} /BitsPerComponent 8 /ColorSpace [/Indexed /DeviceRGB {} "
      "<{}>] /Filter /FlateDecode /Length {}>>\nstream\n{}\nendstream",
      image.width, image.height, image.palette.size() - 1, palette, data.size(), data);
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
  return file + table +
         fmt::format("trailer\n<</Size {} /Root 1 0 R /Info {} 0 R>>\nstartxref\n{}\n%%EOF\n", objects.size() + 1, info,
                     begin);
}

std::string pdf_stream(const std::string& content) {
  return fmt::format("<</Length {}>>\nstream\n{}endstream", content.size(), content);
}

std::string pdf_info(const std::string& title) {
  return "<</Title (" + pdf_letters(title).escaped + ") /Producer (ilot)>>";
}

std::string pdf_book(const std::vector<PdfPage>& pages, const std::string& title) {
  std::string kids;
  for (std::size_t i = 0; i < pages.size(); ++i) kids += fmt::format("{} 0 R ", kFirstPage + kOfPage * i);
  std::vector<std::string> objects{
      "<</Type /Catalog /Pages 2 0 R>>", fmt::format("<</Type /Pages /Kids [{}] /Count {}>>", kids, pages.size()),
      "<</Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding>>", pdf_info(title)};
  const std::string scale = decimal(kPointsPerMm, 6);
  for (const PdfPage& page : pages) {
    const std::string image = page.image ? fmt::format(" /XObject <</Image {} 0 R>>", objects.size() + 3) : "";
    objects.push_back(
        fmt::format("<</Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents {} 0 R /Resources <</Font <</F1 3 0 "
                    "R>> /ExtGState <</Clear <</ca 0.25>> /Solid <</ca 1>>>>{}>>>>",
                    decimal(page.width_mm * kPointsPerMm, 3), decimal(page.height_mm * kPointsPerMm, 3),
                    objects.size() + 2, image));
    objects.push_back(pdf_stream(scale + " 0 0 " + scale + " 0 0 cm 1 J 1 j\n" + page.content));
    objects.push_back(page.image ? image_object(*page.image) : "null");
  }
  return pdf_file(objects, kInfo);
}

}  // namespace ilot
