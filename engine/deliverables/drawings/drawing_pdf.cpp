// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_pdf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/drawings/pdf_file.h"
#include "engine/deliverables/drawings/pdf_text.h"
#include "engine/whole_file.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kWidestCurve = 0.2;  // greatest bulge that one curve draws: 45 degrees, within 1e-5 of the radius

// Converts metres of the drawing to millimetres from the lower left corner of the paper.
struct PdfPlace {
  FlatBox box;
  double mm;
  std::string operator()(FlatPoint p) const {
    return decimal((p.x - box.min.x) / mm, 3) + " " + decimal((p.y - box.min.y) / mm, 3);
  }
};

// Adds the stretch from p to q: a line, or curves of at most 45 degrees.
void add_stretch(FlatPoint p, FlatPoint q, double bulge, const PdfPlace& at, std::string& path) {
  if (bulge == 0) {
    path += at(q) + " l\n";
    return;
  }
  const FlatPoint d{q.x - p.x, q.y - p.y};
  if (std::abs(bulge) > kWidestCurve) {
    const FlatPoint top{(p.x + q.x + bulge * d.y) / 2, (p.y + q.y - bulge * d.x) / 2};
    const double half = bulge / (1 + std::sqrt(1 + bulge * bulge));
    add_stretch(p, top, half, at, path);
    add_stretch(top, q, half, at, path);
    return;
  }
  const double along = (1 - bulge * bulge) / 3, across = 2 * bulge / 3;
  path += at({p.x + along * d.x + across * d.y, p.y + along * d.y - across * d.x}) + " " +
          at({q.x - along * d.x + across * d.y, q.y - along * d.y - across * d.x}) + " " + at(q) + " c\n";
}

std::string path_of(const DrawingLine& line, const PdfPlace& at) {
  const auto place = [&](std::size_t i) { return FlatPoint{line.corners[i].x, line.corners[i].y}; };
  const std::size_t n = line.corners.size();
  std::string path = at(place(0)) + " m\n";
  for (std::size_t i = 0; i + 1 < n + line.closed; ++i)
    add_stretch(place(i), place((i + 1) % n), line.corners[i].bulge, at, path);
  return path + (line.closed ? "s\n" : "S\n");
}

// The arc is drawn in eight pieces of at most 45 degrees.
std::string path_of(const DrawingArc& arc, const PdfPlace& at) {
  constexpr int kPieces = 8;
  double span = arc.to_deg - arc.from_deg;
  while (span <= 0) span += 360;
  const double quarter = span / kPieces / 4, bulge = cos_degrees(quarter - 90) / cos_degrees(quarter);
  DrawingLine line;
  for (int i = 0; i <= kPieces; ++i) {
    const double degrees = arc.from_deg + span * i / kPieces;
    line.corners.push_back({arc.x + arc.radius * cos_degrees(degrees), arc.y + arc.radius * cos_degrees(degrees - 90),
                            i < kPieces ? bulge : 0});
  }
  return path_of(line, at);
}

std::string text_of(const DrawingText& text, const PdfPlace& at) {
  const PdfLetters letters = pdf_letters(text.text);
  const double size = text.height / at.mm / kCapitalOfHelvetica;
  const double share = text.anchor == TextAnchor::left ? 0 : text.anchor == TextAnchor::middle ? 0.5 : 1;
  const double back = share * letters.width * text.height / kCapitalOfHelvetica;
  const double c = cos_degrees(text.rotation_deg), s = cos_degrees(text.rotation_deg - 90);
  return fmt::format("BT /F1 {} Tf {} {} {} {} {} Tm ({}) Tj ET\n", decimal(size, 3), decimal(c, 5), decimal(s, 5),
                     decimal(-s, 5), decimal(c, 5), at({text.x - back * c, text.y - back * s}), letters.escaped);
}

std::string pen_of(const DrawingLayer& layer) {
  const auto [red, green, blue] = colour_on_paper(layer.colour);
  const std::string colour = decimal(red / 255.0, 3) + " " + decimal(green / 255.0, 3) + " " + decimal(blue / 255.0, 3);
  const char* dashes = layer.pattern == LinePattern::dashed   ? "[3 1.5] 0 d"
                       : layer.pattern == LinePattern::dotted ? "[0.5 1] 0 d"
                                                              : "[] 0 d";
  return fmt::format("{0} RG {0} rg {1} w {2}\n", colour, decimal(std::max(layer.lineweight_mm, kThinnestPen), 2),
                     dashes);
}

// Returns everything on one layer; empty when there is nothing.
std::string strokes_of(DrawingRole role, const Drawing& drawing, const DrawingLayers& layers, const PdfPlace& at) {
  std::string strokes;
  for (const DrawingLine& line : drawing.lines)
    if (line.role == role && !line.is_sample && line.corners.size() > 1) strokes += path_of(line, at);
  for (const DrawingArc& arc : drawing.arcs)
    if (arc.role == role) strokes += path_of(arc, at);
  for (const DrawingPoint& point : drawing.points)
    if (point.role == role) strokes += at({point.x, point.y}) + " m " + at({point.x, point.y}) + " l S\n";
  for (const DrawingText& text : drawing.texts)
    if (text.role == role) strokes += text_of(text, at);
  if (!strokes.empty()) strokes = pen_of(layers[role]) + strokes;
  if (role == DrawingRole::title)
    for (const DrawingLine& line : drawing.lines)
      if (line.is_sample) strokes += pen_of(layers[line.role]) + path_of(line, at);
  return strokes;
}

}  // namespace

std::string drawing_pdf(const Drawing& whole, const DrawingLayers& layers) {
  const Drawing drawing = flattened(whole);
  constexpr std::size_t kInfo = 6, kFirstLayer = 7;  // numbers of objects
  const PdfPlace at{drawing.sheet, drawing.paper_mm(1)};
  std::string content = decimal(kPointsPerMm, 6) + " 0 0 " + decimal(kPointsPerMm, 6) + " 0 0 cm 1 J 1 j\n";
  std::string all, hidden, properties;
  std::vector<std::string> groups;
  for (std::size_t i = 0; i < kDrawingRoles; ++i) {
    const auto role = static_cast<DrawingRole>(i);
    const std::string strokes = strokes_of(role, drawing, layers, at);
    if (strokes.empty()) continue;
    const std::string reference = fmt::format("{} 0 R ", kFirstLayer + groups.size());
    content += fmt::format("/OC /L{} BDC\n{}EMC\n", groups.size(), strokes);
    properties += fmt::format("/L{} {}", groups.size(), reference);
    groups.push_back("<</Type /OCG /Name (" + pdf_letters(layers[role].name).escaped + ")>>");
    all += reference;
    if (!layers[role].shown) hidden += reference;
  }
  std::vector<std::string> objects{
      fmt::format("<</Type /Catalog /Pages 2 0 R /OCProperties <</OCGs [{0}] /D <</Order [{0}] /OFF [{1}]>>>>>>", all,
                  hidden),
      "<</Type /Pages /Kids [3 0 R] /Count 1>>",
      fmt::format("<</Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents 5 0 R /Resources <</Font <</F1 4 0 R>> "
                  "/Properties <<{}>>>>>>",
                  decimal(drawing.sheet.width() / at.mm * kPointsPerMm, 3),
                  decimal(drawing.sheet.height() / at.mm * kPointsPerMm, 3), properties),
      "<</Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding>>",
      pdf_stream(content),
      pdf_info(drawing.title)};
  objects.insert(objects.end(), groups.begin(), groups.end());
  return pdf_file(objects, kInfo);
}

void write_drawing_pdf(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers) {
  write_whole_file(path, drawing_pdf(drawing, layers));
}

}  // namespace ilot
