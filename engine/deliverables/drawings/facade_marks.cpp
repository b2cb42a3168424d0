// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_marks.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Millimetres on paper.
constexpr double kBeyondWall = 6, kMarkFrom = 1, kMarkTo = 6, kMarkHead = 1.6, kMarkText = 1.8;
// Choice: the slope of a foot that is still drawn as level, 1 in 50.
constexpr double kLevelFoot = 0.02;

// A line in the plan at which a section is cut: at a height, or upright at an x.
struct Cut {
  bool upright = false;
  double at = 0;
  double way = -1;  // the direction in which it is seen, along y or x
};

std::optional<Cut> cut_of(const Facade& facade, const SectionPlane& plane, double metres) {
  if (std::abs(plane.v.z) < 0.5) return Cut{false, metres * plane.origin.z, -1};
  const double across = dot(plane.u, facade.out);
  if (std::abs(across) < 0.1) return std::nullopt;
  const double t = -dot(plane.origin - facade.origin, facade.out) / across;
  const Vec3 place = plane.origin + t * plane.u;
  const double seen = -dot(cross(plane.u, plane.v), facade.right);
  return Cut{true, metres * dot(place - facade.origin, facade.right), seen < 0 ? -1.0 : 1.0};
}

// Draws a thick dash from one place along the cut to another, with an arrow at its outer end.
void add_mark(const Cut& cut, double from, double to, Drawing& drawing) {
  const double head = drawing.paper_mm(kMarkHead);
  const auto place = [&](double along, double aside) {
    return cut.upright ? DrawingCorner{cut.at + aside * cut.way, along, 0}
                       : DrawingCorner{along, cut.at + aside * cut.way, 0};
  };
  drawing.lines.push_back({DrawingRole::mark, {place(from, 0), place(to, 0), place(to, 2 * head)}, false});
  drawing.lines.push_back(
      {DrawingRole::mark, {place(to - head / 2, head), place(to, 2 * head), place(to + head / 2, head)}, false});
}

}  // namespace

void add_ground(const Facade& facade, std::span<const FlatElement> flat, Drawing& drawing) {
  const double beyond = drawing.paper_mm(kBeyondWall);
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const FlatElement& wall = flat[i];
    if (facade.elements[i].kind != "outline" || wall.corners.size() < 3) continue;
    // The first corner of an outline is the lower left one, the second the lower right one.
    const DrawingCorner &a = wall.corners[0], &b = wall.corners[1];
    const bool level = std::abs(b.y - a.y) <= kLevelFoot * std::abs(b.x - a.x);
    if (!level || wall.edges[0].status != DrawnStatus::seen || b.x <= a.x) continue;
    drawing.lines.push_back({DrawingRole::ground, {{a.x - beyond, a.y, 0}, {b.x + beyond, b.y, 0}}, false});
  }
}

void add_section_marks(const Facade& facade, std::span<const NamedSection> sections, const FlatBox& plan,
                       double metres_per_unit, Drawing& drawing) {
  const double from = drawing.paper_mm(kMarkFrom), to = drawing.paper_mm(kMarkTo), height = drawing.paper_mm(kMarkText);
  for (const NamedSection& section : sections) {
    const std::optional<Cut> cut = cut_of(facade, section.plane, metres_per_unit);
    if (!cut) continue;
    const double low = cut->upright ? plan.min.y : plan.min.x, high = cut->upright ? plan.max.y : plan.max.x;
    add_mark(*cut, low - from, low - to, drawing);
    add_mark(*cut, high + from, high + to, drawing);
    if (cut->upright)
      drawing.texts.push_back(
          {DrawingRole::mark, cut->at, plan.max.y + to + height / 2, height, 0, TextAnchor::middle, section.title});
    else
      drawing.texts.push_back(
          {DrawingRole::mark, plan.min.x - to, cut->at + height / 2, height, 0, TextAnchor::left, section.title});
  }
}

double north_of(double right_x, double right_y) {
  return direction_degrees(right_y, right_x);
}

}  // namespace ilot
