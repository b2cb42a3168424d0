// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/named_sections.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/deliverables/drawings/drawing.h"
#include "engine/deliverables/drawings/facade_section.h"
#include "engine/deliverables/drawings/sheet_texts.h"
#include "engine/error.h"

namespace ilot {
namespace {

constexpr std::size_t kNumbers = 4;  // of a line

SectionPlane along(std::span<const double> line) {
  const Vec3 from{line[0], line[1], 0}, to{line[2], line[3], 0};
  SectionPlane plane = upright_section(from, to);
  plane.from = 0;
  plane.to = norm(to - from);
  return plane;
}

SectionPlane across(const Facade& facade, double x_units) {
  Vec3 place = facade.origin + x_units * facade.right;
  place.z = 0;
  return upright_section(place, place + Vec3{facade.out.x, facade.out.y, 0});
}

}  // namespace

void check_section_lines(std::span<const double> lines) {
  if (lines.size() % kNumbers != 0)
    throw Error(fmt::format("sections along lines need x0, y0, x1, y1 of each; {} numbers are given", lines.size()),
                ExitCode::usage);
  for (std::size_t i = 0; i < lines.size(); i += kNumbers) along(lines.subspan(i, kNumbers));
}

std::vector<NamedSection> named_sections(const Facade& facade, const SectionRequests& requests, double metres_per_unit,
                                         SheetLanguage language) {
  const auto number = [&](double value) { return number_text(value, 2, has_decimal_comma(language)); };
  check_section_lines(requests.lines);
  std::vector<NamedSection> sections;
  for (const double height : requests.levels) {
    const std::string words = decimal(height, 2);
    sections.push_back({"section-level-" + words, phrase(language, SheetPhrase::section_at, number(height)),
                        level_section(facade, height)});
  }
  std::vector<SectionFace> faces;
  if (!requests.uprights.empty() || !requests.lines.empty()) faces = facade_faces(facade, metres_per_unit);
  const auto add_where_it_cuts = [&](NamedSection section) {
    if (!cut_faces(faces, section.plane).empty()) sections.push_back(std::move(section));
  };
  for (const double x : requests.uprights) {
    const std::string words = decimal(x, 2);
    add_where_it_cuts({"section-x-" + words, phrase(language, SheetPhrase::section_at_x, number(x)),
                       across(facade, x / metres_per_unit)});
  }
  for (std::size_t i = 0; i < requests.lines.size(); i += kNumbers) {
    const std::span<const double> line = std::span(requests.lines).subspan(i, kNumbers);
    add_where_it_cuts({fmt::format("section-line-{}", i / kNumbers + 1),
                       phrase(language, SheetPhrase::section_line, number(line[0]), number(line[1]), number(line[2]),
                              number(line[3])),
                       along(line)});
  }
  return sections;
}

}  // namespace ilot
