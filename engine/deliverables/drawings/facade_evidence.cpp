// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_evidence.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/markup.h"

namespace ilot {
namespace {

constexpr double kMuch = 0.5;  // of an edge
constexpr std::array<const char*, 3> kGradeText{"good", "weak", "none"};

std::string millimetres(double metres) {
  return decimal(1000 * metres, 1);
}

std::string percent(const std::optional<double>& share) {
  return share ? decimal(100 * *share, 0) : std::string();
}

std::string stated_of(const FacadeEdge& edge) {
  if (edge.status == DrawnStatus::by_hand) return name_of(edge.status);
  return edge.error_m > 0 ? millimetres(edge.error_m) : "";
}

// The evidence for an edge or a face of an element. What only edges have is empty for faces.
struct EvidenceRow {
  std::string which, status;
  std::uint64_t points = 0;
  double rms_m = 0;
  std::string error_mm, covered;
  std::optional<double> occluded;
};

std::string text_of(const FacadeElement& e, const EvidenceRow& row) {
  return fmt::format(
      "<tr><td class=\"n\">{}</td><td>{}</td><td>{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td "
      "class=\"n\">{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td></tr>\n",
      e.id, escaped_markup(clean_text(e.kind)), row.which, row.status, row.points,
      row.points > 0 ? millimetres(row.rms_m) : "", row.error_mm, row.covered, percent(row.occluded));
}

}  // namespace

EvidenceGrade evidence_grade(const FacadeEdge& edge) {
  if (edge.points == 0) return EvidenceGrade::none;
  return edge.status != DrawnStatus::seen || edge.covered_share < kMuch || edge.occluded_share.value_or(0) >= kMuch
             ? EvidenceGrade::weak
             : EvidenceGrade::good;
}

const char* side_of(const DrawingCorner& from, const DrawingCorner& to) {
  const double right = to.y - from.y, up = from.x - to.x;  // outwards from a ring that runs counter-clockwise
  if (std::abs(right) > std::abs(up)) return right > 0 ? "right" : "left";
  return up > 0 ? "top" : "bottom";
}

std::string words_of(const FacadeElement& element, const char* side, const FacadeEdge& edge) {
  std::string words = fmt::format("{} {}, {}: {} points", element.id, element.kind, side, edge.points);
  if (edge.points > 0)
    words +=
        ", " + millimetres(edge.rms_m) + fmt::format(" mm RMS, along {} % of it", decimal(100 * edge.covered_share, 0));
  if (edge.occluded_share) words += ", " + percent(edge.occluded_share) + " % occluded";
  if (edge.error_m > 0) words += ", within " + millimetres(edge.error_m) + " mm";
  words += std::string(", ") + name_of(edge.status);
  return element.reason.empty() ? words : words + " (" + element.reason + ")";
}

std::vector<SvgNote> edge_notes(const FacadeElement& element, const FlatElement& flat) {
  std::vector<SvgNote> notes;
  if (element.edges.empty()) return notes;
  for (std::size_t i = 0; i < flat.corners.size(); ++i) {
    const DrawingCorner &a = flat.corners[i], &b = flat.corners[(i + 1) % flat.corners.size()];
    const auto grade = static_cast<std::size_t>(evidence_grade(flat.edges[i]));
    notes.push_back(
        {a, b, kGradeText[grade], words_of(element, side_of(a, b), flat.edges[i]), -static_cast<int>(grade)});
  }
  return notes;
}

std::size_t add_evidence_rows(const FacadeElement& element, const FlatElement& flat, std::size_t most,
                              std::string& rows) {
  std::size_t count = 0;
  const auto add = [&](const EvidenceRow& row) {
    if (count++ < most) rows += text_of(element, row);
  };
  if (!element.edges.empty())
    for (std::size_t i = 0; i < flat.corners.size(); ++i) {
      const FacadeEdge& edge = flat.edges[i];
      const char* side = side_of(flat.corners[i], flat.corners[(i + 1) % flat.corners.size()]);
      add({side, name_of(edge.status), edge.points, edge.rms_m, stated_of(edge), percent(edge.covered_share),
           edge.occluded_share});
    }
  for (const FacadeFace& f : element.faces)
    add({escaped_markup(clean_text(f.name)) + " face", "", f.points, f.rms_m, "", "", f.occluded_share});
  return count;
}

}  // namespace ilot
