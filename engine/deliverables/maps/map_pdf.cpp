// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/maps/map_pdf.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/deliverables/drawings/pdf_text.h"

namespace ilot {
namespace {

constexpr double kThinnest = 0.1;  // millimetres; of lines on paper
// Derived: the control points of a curve of a quarter of a circle, within 0.03 % of its radius.
constexpr double kQuarter = 0.5522847498;

std::string number(double value) {
  return decimal(value, 3);
}

std::string point(FlatPoint p) {
  return number(p.x) + " " + number(p.y);
}

std::string colour(MapColour c) {
  return number(c.red / 255.0) + " " + number(c.green / 255.0) + " " + number(c.blue / 255.0);
}

std::string circle(FlatPoint c, double r) {
  const double k = kQuarter * r;
  const auto at = [&](double x, double y) { return point({c.x + x, c.y + y}) + " "; };
  return at(r, 0) + "m " + at(r, k) + at(k, r) + at(0, r) + "c " + at(-k, r) + at(-r, k) + at(-r, 0) + "c " +
         at(-r, -k) + at(-k, -r) + at(0, -r) + "c " + at(k, -r) + at(r, -k) + at(r, 0) + "c h\n";
}

std::string path(const MapShape& shape, const MapPlace& place) {
  if (shape.lines.empty()) return circle(place.mm(shape.centre), place.mm(shape.radius));
  std::string out;
  for (const std::vector<FlatPoint>& line : shape.lines) {
    for (std::size_t i = 0; i < line.size(); ++i) out += point(place.mm(line[i])) + (i == 0 ? " m " : " l ");
    out += shape.closed ? "h\n" : "\n";
  }
  return out;
}

}  // namespace

std::string shape_pdf(const MapShape& shape, const MapPlace& place) {
  std::string out;
  if (shape.fill) out += colour(*shape.fill) + " rg ";
  if (shape.stroke) {
    const std::string dash = shape.dash > 0 ? number(place.mm(shape.dash)) : "";
    out += fmt::format("{} RG {} w [{}] 0 d ", colour(*shape.stroke),
                       number(std::max(kThinnest, place.mm(shape.width))), dash);
  }
  const bool clear = shape.fill && shape.clear;
  const char* paint = shape.fill && shape.stroke ? "B*" : shape.fill ? "f*" : "S";
  return out + (clear ? "/Clear gs " : "") + path(shape, place) + paint + (clear ? " /Solid gs\n" : "\n");
}

std::string text_pdf(const PageText& place, const std::string& text) {
  const PdfLetters letters = pdf_letters(text);
  const double size = place.height / kCapitalOfHelvetica;
  const double share = place.anchor == TextAnchor::left ? 0 : place.anchor == TextAnchor::middle ? 0.5 : 1;
  const std::string shown = fmt::format("BT /F1 {} Tf {} {} Td ", number(size),
                                        number(place.at.x - share * size * letters.width), number(place.at.y));
  const std::string letter = "(" + letters.escaped + ") Tj ET\n";
  const std::string halo =
      place.halo ? "1 1 1 RG " + number(place.height / 4) + " w [] 0 d " + shown + "1 Tr " + letter : "";
  return halo + "0.1 0.1 0.1 rg " + shown + "0 Tr " + letter;
}

std::string frame_pdf(const FlatBox& box) {
  return fmt::format("0.2 0.2 0.2 RG 0.25 w [] 0 d {} {} {} re S\n", point(box.min), number(box.width()),
                     number(box.height()));
}

}  // namespace ilot
