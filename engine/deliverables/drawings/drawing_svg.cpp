// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/markup.h"
#include "engine/whole_file.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kCapitalOfArial = 0.716;  // of Arial and Helvetica, in font sizes
constexpr double kAroundPlan = 3;          // mm

// Converts metres of the drawing to millimetres of the paper, y down.
struct SvgPlace {
  FlatBox box;
  double mm;  // metres of the drawing for a millimetre of paper
  std::string x(double v) const { return decimal((v - box.min.x) / mm, 3); }
  std::string y(double v) const { return decimal((box.max.y - v) / mm, 3); }
  std::string length(double v) const { return decimal(v / mm, 3); }
};

double length_of(const DrawingCorner& a, const DrawingCorner& b) {
  return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

std::string path_of(const DrawingLine& line, const SvgPlace& at) {
  std::string path = "M" + at.x(line.corners[0].x) + " " + at.y(line.corners[0].y);
  const std::size_t n = line.corners.size();
  for (std::size_t i = 0; i + 1 < n + line.closed; ++i) {
    const DrawingCorner &a = line.corners[i], &b = line.corners[(i + 1) % n];
    if (a.bulge == 0) {
      if (i + 1 < n) path += "L" + at.x(b.x) + " " + at.y(b.y);
      continue;
    }
    const double bulge = std::abs(a.bulge), radius = length_of(a, b) * (1 + bulge * bulge) / (4 * bulge);
    path += fmt::format("A{0} {0} 0 {1} {2} {3} {4}", at.length(radius), bulge > 1 ? 1 : 0, a.bulge > 0 ? 0 : 1,
                        at.x(b.x), at.y(b.y));
  }
  return path + (line.closed ? "Z" : "");
}

std::string path_of(const DrawingArc& arc, const SvgPlace& at) {
  const auto on = [&](double degrees) {
    return at.x(arc.x + arc.radius * cos_degrees(degrees)) + " " + at.y(arc.y + arc.radius * cos_degrees(degrees - 90));
  };
  double span = arc.to_deg - arc.from_deg;
  while (span <= 0) span += 360;
  // The circle is drawn in two halves, because a whole circle has no ends.
  const std::string radius = at.length(arc.radius);
  return fmt::format("M{0}A{1} {1} 0 0 0 {2}A{1} {1} 0 0 0 {3}", on(arc.from_deg), radius, on(arc.from_deg + span / 2),
                     on(arc.from_deg + span));
}

std::string text_of(const DrawingText& text, const SvgPlace& at) {
  const char* anchor = text.anchor == TextAnchor::left     ? ""
                       : text.anchor == TextAnchor::middle ? " text-anchor=\"middle\""
                                                           : " text-anchor=\"end\"";
  const std::string x = at.x(text.x), y = at.y(text.y);
  const std::string turn = text.rotation_deg == 0
                               ? ""
                               : fmt::format(" transform=\"rotate({} {} {})\"", decimal(-text.rotation_deg, 3), x, y);
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\"{}{}>{}</text>\n", x, y,
                     at.length(text.height / kCapitalOfArial), anchor, turn, escaped_markup(clean_text(text.text)));
}

std::string stroke_of(const DrawingLayer& layer) {
  const auto [red, green, blue] = colour_on_paper(layer.colour);
  const char* dashes = layer.pattern == LinePattern::dashed   ? " stroke-dasharray=\"3 1.5\""
                       : layer.pattern == LinePattern::dotted ? " stroke-dasharray=\"0.5 1\""
                                                              : "";
  return fmt::format("fill=\"none\" stroke=\"#{:02x}{:02x}{:02x}\" stroke-width=\"{}\" stroke-linecap=\"round\"{}", red,
                     green, blue, decimal(std::max(layer.lineweight_mm, kThinnestPen), 2), dashes);
}

// Returns samples of all pens, on the layer of titles.
std::string samples_of(const Drawing& drawing, const DrawingLayers& layers, const SvgPlace& at) {
  std::string paths;
  for (const DrawingLine& line : drawing.lines)
    if (line.is_sample) paths += fmt::format("<path {} d=\"{}\"/>\n", stroke_of(layers[line.role]), path_of(line, at));
  return paths;
}

std::string group_of(DrawingRole role, const Drawing& drawing, const DrawingLayers& layers, const SvgPlace& at) {
  std::string paths, texts;
  for (const DrawingLine& line : drawing.lines)
    if (line.role == role && !line.is_sample && line.corners.size() > 1)
      paths += "<path d=\"" + path_of(line, at) + "\"/>\n";
  for (const DrawingArc& arc : drawing.arcs)
    if (arc.role == role) paths += "<path d=\"" + path_of(arc, at) + "\"/>\n";
  for (const DrawingPoint& point : drawing.points)
    if (point.role == role) paths += fmt::format("<path d=\"M{} {}h0\"/>\n", at.x(point.x), at.y(point.y));
  for (const DrawingText& text : drawing.texts)
    if (text.role == role) texts += text_of(text, at);
  const std::string samples = role == DrawingRole::title ? samples_of(drawing, layers, at) : "";
  if (paths.empty() && texts.empty() && samples.empty()) return "";
  const DrawingLayer& layer = layers[role];
  const auto [red, green, blue] = colour_on_paper(layer.colour);
  std::string group = fmt::format("<g class=\"role-{}\" data-layer=\"{}\"{}>\n", name_of(role),
                                  escaped_markup(layer.name), layer.shown ? "" : " style=\"display:none\"");
  if (!paths.empty()) group += fmt::format("<g {}>\n{}</g>\n", stroke_of(layer), paths);
  if (!texts.empty()) group += fmt::format("<g fill=\"#{:02x}{:02x}{:02x}\">\n{}</g>\n", red, green, blue, texts);
  return group + samples + "</g>\n";
}

std::string notes_of(std::span<const SvgNote> notes, const SvgPlace& at) {
  if (notes.empty()) return "";
  std::string group = "<g class=\"notes\" fill=\"none\" stroke=\"#000\" stroke-opacity=\"0\" stroke-width=\"1.2\">\n";
  for (const SvgNote& note : notes)
    group += fmt::format("<path class=\"note-{}\" d=\"{}\"><title>{}</title></path>\n", note.kind,
                         path_of(DrawingLine{DrawingRole::detail, {note.from, note.to}, false}, at),
                         escaped_markup(clean_text(note.text)));
  return group + "</g>\n";
}

bool is_paper(DrawingRole role) {
  return role == DrawingRole::frame || role == DrawingRole::title;
}

// Returns the drawing without frame and title block.
Drawing plan_of(const Drawing& drawing) {
  Drawing plan = drawing;
  std::erase_if(plan.lines, [](const DrawingLine& line) { return line.is_sample || is_paper(line.role); });
  std::erase_if(plan.texts, [](const DrawingText& text) { return is_paper(text.role); });
  const FlatBox box = extent_of(plan);
  const double around = plan.paper_mm(kAroundPlan);
  plan.sheet = box.grown(around);
  return plan;
}

}  // namespace

std::string drawing_svg(const Drawing& whole, const DrawingLayers& layers, SvgPart part,
                        const std::optional<SvgUnderlay>& underlay, std::span<const SvgNote> notes) {
  const Drawing drawing = part == SvgPart::plan ? plan_of(flattened(whole)) : flattened(whole);
  const SvgPlace at{drawing.sheet, drawing.paper_mm(1)};
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"Arial, Helvetica, 'Liberation Sans', sans-serif\">\n<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      at.length(drawing.sheet.width()), at.length(drawing.sheet.height()), escaped_markup(clean_text(drawing.title)));
  if (underlay)
    svg += fmt::format(
        "<image class=\"underlay\" href=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
        "preserveAspectRatio=\"none\"/>\n",
        escaped_markup(underlay->link), at.x(underlay->place.min.x), at.y(underlay->place.max.y),
        at.length(underlay->place.width()), at.length(underlay->place.height()));
  for (std::size_t i = 0; i < kDrawingRoles; ++i) {
    const auto role = static_cast<DrawingRole>(i);
    svg += group_of(role, drawing, layers, at);
  }
  return svg + notes_of(notes, at) + "</svg>\n";
}

void write_drawing_svg(const std::filesystem::path& path, const Drawing& drawing, const DrawingLayers& layers) {
  write_whole_file(path, drawing_svg(drawing, layers));
}

}  // namespace ilot
