// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/element_pieces.h"

#include <algorithm>
#include <array>
#include <string>

#include "engine/deliverables/drawings/hidden_lines.h"

namespace ilot {
namespace {

// Choice: walls that step by less are not parted either.
constexpr double kBefore = 0.02;  // metres

// How far out of the wall an element reaches, in metres.
double front_of(const Facade& facade, const FacadeElement& e, double metres_per_unit) {
  return metres_per_unit * distance_from_wall(facade, e) + std::max(0.0, e.depth_m);
}

bool hides_openings(const std::string& kind) {
  constexpr std::array<const char*, 5> kKinds{"balcony", "railing", "protrusion", "eaves", "bracket"};
  return std::find(kKinds.begin(), kKinds.end(), kind) != kKinds.end();
}

bool can_hide(const FacadeElement& e) {
  return e.depth_m > 0 && !is_opening(e) && e.status != DrawnStatus::occluded && e.region == FacadeRegion::element &&
         role_of_kind(e.kind) != DrawingRole::outline;
}

// Bands and rows of stones are found as one element where openings interrupt them.
bool ends_at_openings(const FacadeElement& e) {
  const DrawingRole role = role_of_kind(e.kind);
  return role == DrawingRole::band || role == DrawingRole::stone || role == DrawingRole::joint;
}

std::vector<Cover> covers_of(const Facade& facade, std::span<const FlatElement> flat, std::span<const Cover> rings,
                             std::span<const double> fronts, std::size_t i) {
  const FacadeElement& e = facade.elements[i];
  std::vector<Cover> covers;
  if (role_of_kind(e.kind) == DrawingRole::outline || e.status == DrawnStatus::occluded) return covers;
  for (std::size_t j = 0; j < flat.size(); ++j) {
    const FacadeElement& other = facade.elements[j];
    if (j == i || rings[j].ring.size() < 3 || !flat[j].box.overlaps(flat[i].box)) continue;
    const bool hides = can_hide(other) && fronts[j] > fronts[i] + kBefore &&
                       (!is_opening(e) || (hides_openings(other.kind) && !holds_all(rings[j], rings[i].ring)));
    const bool cuts = ends_at_openings(e) && is_opening(other) && other.status != DrawnStatus::occluded &&
                      flat[i].box.min.x < flat[j].box.min.x && flat[i].box.max.x > flat[j].box.max.x;
    if (hides || cuts) covers.push_back(rings[j]);
  }
  return covers;
}

std::string metres(double value) {
  return decimal(value, 3);
}

}  // namespace

std::vector<DrawingAttribute> schedule_of(const FacadeElement& element, const FlatElement& flat) {
  double error = 0;
  bool by_hand = false;
  for (const FacadeEdge& edge : flat.edges) {
    error = std::max(error, edge.error_m);
    by_hand |= edge.status == DrawnStatus::by_hand;
  }
  std::string stated = error > 0 ? decimal(1000 * error, 1) : "";
  if (by_hand) stated = name_of(DrawnStatus::by_hand);
  return {{"ID", std::to_string(element.id)}, {"KIND", element.kind},
          {"WIDTH", metres(element.width_m)}, {"HEIGHT", metres(element.height_m)},
          {"SILL", metres(flat.box.min.y)},   {"HEAD", metres(flat.box.max.y)},
          {"DEPTH", metres(element.depth_m)}, {"ERROR", stated},
          {"STATUS", name_of(element.status)}};
}

void draw_elements(const Facade& facade, std::span<const FlatElement> flat, double metres_per_unit, Drawing& drawing) {
  std::vector<Cover> rings;
  std::vector<double> fronts;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    rings.push_back({chords_of(flat[i]), flat[i].box});
    fronts.push_back(front_of(facade, facade.elements[i], metres_per_unit));
  }
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const FacadeElement& e = facade.elements[i];
    Drawing own;
    own.scale = drawing.scale;
    draw_element(e, flat[i], own);
    hide_lines(covers_of(facade, flat, rings, fronts, i), own.lines);
    if (is_opening(e) && e.status != DrawnStatus::occluded && !own.lines.empty()) {
      drawing.blocks.push_back(
          {e.kind, flat[i].box.min, std::move(own.lines), std::move(own.arcs), schedule_of(e, flat[i])});
      continue;
    }
    drawing.lines.insert(drawing.lines.end(), own.lines.begin(), own.lines.end());
    drawing.arcs.insert(drawing.arcs.end(), own.arcs.begin(), own.arcs.end());
  }
}

}  // namespace ilot
