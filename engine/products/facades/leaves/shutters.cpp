// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/shutters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "engine/products/facades/leaves/leaf_judge.h"
#include "engine/products/facades/openings/arched_top.h"

namespace ilot {
namespace {

// Derived: a majority; between two plates there may be another one of which something hides a part.
constexpr double kMostRelief = 0.5;  // share of a window between open leaves before which something stands
// Choice: lower plates without any opening beside them may be quoins, signs and panels.
constexpr double kLeastAlone = 0.8;  // metres, height
// Choice: two alike are a pair of boards; three are a row of windows.
constexpr std::size_t kFewestAlone = 3;
// Choice: a lintel and a sill; quoins and panels follow each other closer.
constexpr double kLeastBetween = 0.3;  // metres between windows of one column

// Lays the arc of an opening over its jambs.
void set_arch(FoundRectangle& o, double spring, double rise) {
  const double half = o.box().width() / 2, radius = (rise * rise + half * half) / (2 * rise);
  o.arc->centre = {(o.at(Side::left) + o.at(Side::right)) / 2, spring + rise - radius};
  o.arc->radius = radius;
}

// Whether a plate that is like no opening may be closed leaves together with others.
bool stands_alone(const std::vector<FlatPlate>& plates, const std::vector<FoundRectangle>& openings, std::size_t i) {
  const Box2 p = plates[i].shape.box();
  if (p.height() < kLeastAlone || p.height() < p.width()) return false;
  if (std::count_if(kSides.begin(), kSides.end(), [&](Side s) { return plates[i].ends_at(s); }) < 3) return false;
  const auto is_close = [&](const FoundRectangle& o) {
    const Box2 b = o.box();
    return overlap_of(p.u0, p.u1, b.u0, b.u1) > 0 && overlap_of(p.v0, p.v1, b.v0, b.v1) > -kLeastBetween;
  };
  for (std::size_t k = 0; k < plates.size(); ++k)
    if (k != i && is_close(plates[k].shape)) return false;
  return std::none_of(openings.begin(), openings.end(), is_close);
}

// The window between two open leaves.
FoundRectangle window_between(const FlatPlate& left, const FlatPlate& right) {
  FoundRectangle window = left.shape;
  window.depth = window.depth_error = 0;
  window.points += right.shape.points;
  window.side(Side::left) = left.shape.side(Side::right), window.side(Side::right) = right.shape.side(Side::left);
  for (LocatedEdge& edge : window.sides) edge.error += kHingeError, edge.by_face = false;
  return window;
}

// Adds the windows between two open leaves through which no ray is known to have gone and before which nothing stands,
// and says which plates are leaves of them. Other plates may be closed leaves because they are like these windows. No
// leaf of theirs can be closed: it does not end at wall on their side.
std::vector<bool> add_windows_between(const FlatPlates& found, const LeafJudge& judge,
                                      std::vector<FoundRectangle>& openings) {
  const std::vector<FlatPlate>& plates = found.plates;
  std::vector<bool> is_leaf(plates.size(), false);
  for (std::size_t i = 0; i < plates.size(); ++i)
    for (std::size_t k = 0; k < plates.size(); ++k) {
      if (!judge.are_about_window(plates[i], plates[k])) continue;
      const FoundRectangle window = window_between(plates[i], plates[k]);
      const auto overlaps = [&](const FoundRectangle& o) { return common_area(window.box(), o.box()) > 0; };
      const auto lies_between = [&](const FlatPlate& p) { return overlaps(p.shape); };
      if (std::any_of(openings.begin(), openings.end(), overlaps) ||
          std::any_of(plates.begin(), plates.end(), lies_between) ||
          relief_share(found.relief, window.box()) > kMostRelief)
        continue;
      openings.push_back(window);
      is_leaf[i] = is_leaf[k] = true;
    }
  return is_leaf;
}

// The window behind a plate, with what is hidden of it from an opening that it is like.
FoundRectangle window_behind(const FlatPlate& plate, const FoundRectangle* like, double alike) {
  FoundRectangle window = outlined_by(plate);
  if (like == nullptr) return window;
  const Box2 q = jambs_of(*like);
  const auto complete = [&](Side side, double at) {
    const double was = window.at(side);
    if (plate.ends_at(side) || outwards(side) * (at - was) <= alike) return;
    LocatedEdge& edge = window.side(side);
    edge = {at, like->error(side) + kHingeError + alike, DrawnStatus::completed};
    edge.inner = was;
  };
  complete(Side::bottom, q.v0), complete(Side::top, q.v1);
  const double rise = rise_of(*like), spring = window.at(Side::top);
  if (rise <= alike) return window;
  window.arc = like->arc, window.pointed = like->pointed;
  if (window.arc) window.arc->error += alike, set_arch(window, spring, rise);
  LocatedEdge& crown = window.side(Side::top);
  crown = {spring + rise, like->error(Side::top) + kHingeError + alike, DrawnStatus::completed};
  crown.inner = spring;
  return window;
}

// The opening above closed leaves is the upper part of their window.
void extend_below(const FlatPlate& plate, FoundRectangle& o) {
  o.side(Side::bottom) = plate.shape.side(Side::bottom);
  o.side(Side::bottom).error += kHingeError;
  for (const Side side : {Side::left, Side::right}) {
    if (outwards(side) * (plate.shape.at(side) - o.at(side)) <= 0) continue;
    o.side(side) = plate.shape.side(side);
    o.side(side).error += kHingeError;
  }
  if (o.arc) set_arch(o, plate.shape.at(Side::top), o.at(Side::top) - plate.shape.at(Side::top));
}

// The closed plates, and the opening or the closed plate that each is like.
struct ClosedPlates {
  std::vector<bool> closed;
  std::vector<bool> lit;  // there is a light above it
  std::vector<std::optional<FoundRectangle>> like;
};

ClosedPlates closed_plates(const std::vector<FlatPlate>& plates, const std::vector<FoundRectangle>& openings,
                           const LeafJudge& judge) {
  ClosedPlates found{std::vector<bool>(plates.size(), false), std::vector<bool>(plates.size(), false), {}};
  found.like.resize(plates.size());
  std::vector<std::size_t> free, alone;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    if (!plates[i].ends_at(Side::left) || !plates[i].ends_at(Side::right)) continue;  // the side of a hinge
    if (std::any_of(openings.begin(), openings.end(),
                    [&](const auto& o) { return judge.excludes(o, plates[i]) && !judge.is_light_above(plates[i], o); }))
      continue;
    free.push_back(i);
    for (const FoundRectangle& o : openings) {
      if (!judge.is_light_above(plates[i], o)) continue;
      found.closed[i] = found.lit[i] = true;
      found.like[i] = o;
      extend_below(plates[i], *found.like[i]);
    }
    if (found.closed[i]) continue;
    for (const FoundRectangle& o : openings) {
      if (found.closed[i] || !judge.is_like(plates[i], o)) continue;
      found.closed[i] = true;
      if (judge.is_in_row(plates[i], o)) found.like[i] = o;
    }
    if (!found.closed[i] && stands_alone(plates, openings, i)) alone.push_back(i);
  }
  for (const std::size_t i : alone) {
    std::size_t alike = 1;
    for (const std::size_t k : alone) alike += k != i && judge.are_alike(plates[i], plates[k]);
    found.closed[i] = alike >= kFewestAlone;
  }
  for (bool more = true; more;) {
    more = false;
    for (const std::size_t i : free)
      for (const std::size_t k : free)
        if (i != k && !found.closed[i] && found.closed[k] && judge.are_alike(plates[i], plates[k])) {
          found.closed[i] = more = true;
          if (judge.are_in_row(plates[i], plates[k])) found.like[i] = found.like[k] ? found.like[k] : plates[k].shape;
        }
  }
  return found;
}

}  // namespace

std::vector<ShutterLeaf> find_shutters(const FlatPlates& found, double alike, double cell,
                                       std::vector<FoundRectangle>& openings) {
  const std::vector<FlatPlate>& plates = found.plates;
  const LeafJudge judge(alike, cell);
  const std::vector<bool> about_window = add_windows_between(found, judge, openings);
  const ClosedPlates closed = closed_plates(plates, openings, judge);
  std::vector<ShutterLeaf> leaves;
  std::vector<FoundRectangle> windows;
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const FlatPlate& plate = plates[i];
    const auto before = std::find_if(openings.begin(), openings.end(),
                                     [&](const FoundRectangle& o) { return judge.is_before(plate, o); });
    if (closed.lit[i]) {
      leaves.push_back({plate.shape, LeafState::closed});
      // Another plate may have widened the light since.
      const auto light = std::find_if(openings.begin(), openings.end(),
                                      [&](const FoundRectangle& o) { return judge.is_light_above(plate, o); });
      if (light != openings.end()) extend_below(plate, *light);
    } else if (closed.closed[i]) {
      windows.push_back(window_behind(plate, closed.like[i] ? &*closed.like[i] : nullptr, alike));
      leaves.push_back({plate.shape, LeafState::closed});
    } else if (before != openings.end()) {
      leaves.push_back({plate.shape, LeafState::closed});
      widen(plate, *before);
    } else if (about_window[i] || std::any_of(openings.begin(), openings.end(),
                                              [&](const FoundRectangle& o) { return judge.is_open_leaf(plate, o); })) {
      leaves.push_back({plate.shape, LeafState::open});
    }
  }
  openings.insert(openings.end(), windows.begin(), windows.end());
  return leaves;
}

}  // namespace ilot
