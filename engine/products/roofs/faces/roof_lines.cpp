// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/roof_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <queue>
#include <tuple>

#include "engine/products/roofs/faces/border_samples.h"
#include "engine/products/roofs/faces/face_rectangles.h"
#include "engine/products/roofs/faces/outline_directions.h"
#include "engine/products/roofs/sites/step_offset.h"

namespace ilot {
namespace {

// Choice: lines end a step or two too early at hips; beyond 1.5 m they would cut faces that they do not reach.
constexpr double kExtendSteps = 4, kExtendMetres = 1.5;  // extension of a line beyond its seen part
// Choice: the width of a house; longer gaps stay open.
constexpr double kFarthest = 15;  // metres; greatest extension of a line to meet another one
constexpr std::uint32_t kFewestOnCrease = 2, kFewestOnStep = 3;
// Derived: one step.
constexpr double kLeastRunSteps = 1;
// Choice: the value of face_rectangles.cpp.
constexpr double kAligned = 0.1;  // metres between a step and the line onto which it is moved
// Choice: three lost points in a row happen on wet tiles; a gap of four splits a line.
constexpr double kLineGapSteps = 4;  // steps; a line ends where nothing of it is seen over this length
constexpr std::size_t kMostDirections = 16;

double extension(const RoofPlanes& planes) {
  return std::max(kExtendSteps * planes.step, kExtendMetres);
}

// The line where two planes have the same height: a point and a direction of unit length.
struct Line {
  FlatPoint at, along;
};

Line crossing(const RoofPlane& a, const RoofPlane& b, FlatPoint near) {
  const FlatPoint g{a.gx - b.gx, a.gy - b.gy};
  const double slope2 = dot(g, g), difference = a.at(near.x, near.y) - b.at(near.x, near.y);
  const double slope = std::sqrt(slope2);
  return {{near.x - difference * g.x / slope2, near.y - difference * g.y / slope2}, {-g.y / slope, g.x / slope}};
}

// Adds a crease for every pair of planes that were seen to cross, as far as the crossing was seen.
void add_creases(std::vector<BorderSample> seen, const RoofPlanes& planes, std::vector<FlatEdge>& lines) {
  std::stable_sort(seen.begin(), seen.end(), [](const BorderSample& s, const BorderSample& t) {
    return std::tie(s.a, s.b) < std::tie(t.a, t.b);
  });
  for (std::size_t first = 0; first < seen.size();) {
    std::size_t last = first;
    while (last < seen.size() && seen[last].a == seen[first].a && seen[last].b == seen[first].b) ++last;
    if (last - first >= kFewestOnCrease) {
      const Line line = crossing(planes.planes[seen[first].a], planes.planes[seen[first].b], seen[first].at);
      double low = INFINITY, high = -INFINITY;
      for (std::size_t i = first; i < last; ++i) {
        const double t = dot({seen[i].at.x - line.at.x, seen[i].at.y - line.at.y}, line.along);
        low = std::min(low, t);
        high = std::max(high, t);
      }
      low -= extension(planes);
      high += extension(planes);
      lines.push_back({{line.at.x + low * line.along.x, line.at.y + low * line.along.y},
                       {line.at.x + high * line.along.x, line.at.y + high * line.along.y}});
    }
    first = last;
  }
}

std::vector<FlatEdge> outline_edges(const SitePolygon& outline) {
  std::vector<FlatEdge> edges;
  for (const auto& ring : outline)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 p = ring[i], q = ring[(i + 1) % ring.size()];
      edges.push_back({{p.x / 1000.0, p.y / 1000.0}, {q.x / 1000.0, q.y / 1000.0}});
    }
  return edges;
}

// Returns the directions in which steps are likely to run, the likeliest first: those of the outline and across it, by
// length; then those down the planes and along them.
std::vector<FlatPoint> likely_directions(const RoofSite& site, const RoofPlanes& planes) {
  std::vector<WeightedDirection> weighted = outline_directions(site.outline);
  for (const RoofPlane& p : planes.planes) {
    if (p.gx * p.gx + p.gy * p.gy < kLeastSlopeChange * kLeastSlopeChange) continue;
    const double weight = std::sqrt(static_cast<double>(p.points)) * planes.step;
    add_direction({p.gx, p.gy}, weight, weighted);
    add_direction({-p.gy, p.gx}, weight, weighted);
  }
  std::stable_sort(weighted.begin(), weighted.end(),
                   [](const WeightedDirection& a, const WeightedDirection& b) { return a.weight > b.weight; });
  std::vector<FlatPoint> directions;
  for (const WeightedDirection& d : weighted)
    if (directions.size() < kMostDirections) directions.push_back(d.along);
  return directions;
}

// Consecutive samples of one straight step.
struct Run {
  std::vector<std::uint32_t> members;
  FlatPoint along;
  double offset = 0, low = 0, high = 0;
};

FlatPoint on(const Run& run, double t) {
  return {t * run.along.x - run.offset * run.along.y, t * run.along.y + run.offset * run.along.x};
}

// Takes runs, those with the most samples first, and each sample once. Samples lie in strips of half a step along every
// direction; a run lies in two neighbouring strips. The best run of a window of two strips can only shrink while
// samples are taken. So a window is examined again only when it is at the top of the queue.
class StepFinder {
 public:
  StepFinder(std::vector<BorderSample> seen, std::vector<FlatPoint> directions, double step)
      : seen_(std::move(seen)), directions_(std::move(directions)), step_(step), used_(seen_.size(), 0) {
    for (std::uint32_t d = 0; d < directions_.size(); ++d) add_strips(d);
  }

  std::vector<Run> find() {
    std::vector<Run> runs;
    while (!windows_.empty()) {
      const Window window = windows_.top();
      windows_.pop();
      const std::vector<Place>& places = places_in(window);
      const Stretch stretch = longest(places);
      if (stretch.size() < kFewestOnStep) continue;
      if (stretch.size() < window.size) {
        windows_.push({stretch.size(), window.direction, window.strip});
        continue;
      }
      Run run = run_of(places, stretch, directions_[window.direction]);
      for (const std::uint32_t i : run.members) used_[i] = 1;
      place(run);
      runs.push_back(std::move(run));
      windows_.push(window);
    }
    return runs;
  }

 private:
  struct Place {
    std::int64_t strip;
    double along, offset;
    std::uint32_t border_sample;
  };
  static bool before(const Place& p, const Place& q) {
    if (p.along != q.along) return p.along < q.along;
    return p.offset != q.offset ? p.offset < q.offset : p.border_sample < q.border_sample;
  }
  struct Window {
    std::size_t size;
    std::uint32_t direction;
    std::size_t strip;                       // its index among the strips of the direction
    bool operator<(const Window& o) const {  // the top is the largest; ties by position
      return std::tie(size, o.direction, o.strip) < std::tie(o.size, direction, strip);
    }
  };

  // Places of a window that follow each other.
  struct Stretch {
    std::size_t first = 0, last = 0;
    std::size_t size() const { return last - first; }
  };

  void add_strips(std::uint32_t d) {
    std::vector<Place> places;
    for (std::uint32_t i = 0; i < seen_.size(); ++i) {
      const double offset = cross(directions_[d], seen_[i].at);
      places.push_back(
          {static_cast<std::int64_t>(std::floor(2 * offset / step_)), dot(directions_[d], seen_[i].at), offset, i});
    }
    std::sort(places.begin(), places.end(),
              [](const Place& p, const Place& q) { return p.strip != q.strip ? p.strip < q.strip : before(p, q); });
    std::vector<std::size_t> starts;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (i == 0 || places[i].strip != places[i - 1].strip) starts.push_back(i);
    starts.push_back(places.size());
    places_.push_back(std::move(places));
    starts_.push_back(std::move(starts));
    for (std::size_t s = 0; s + 1 < starts_[d].size(); ++s) {
      const Stretch stretch = longest(places_in({0, d, s}));
      if (stretch.size() >= kFewestOnStep) windows_.push({stretch.size(), d, s});
    }
  }

  // The samples of a strip and of the next one that are not taken, in order along the strips. Valid until the next
  // call.
  const std::vector<Place>& places_in(const Window& window) const {
    const std::vector<Place>& places = places_[window.direction];
    const std::vector<std::size_t>& starts = starts_[window.direction];
    const std::size_t first = starts[window.strip], middle = starts[window.strip + 1];
    std::size_t last = middle;
    if (middle < places.size() && places[middle].strip == places[first].strip + 1) last = starts[window.strip + 2];
    std::vector<Place>& merged = merged_;
    merged.clear();
    const auto place = [&](std::size_t i) { return places.begin() + static_cast<std::ptrdiff_t>(i); };
    std::merge(place(first), place(middle), place(middle), place(last), std::back_inserter(merged), before);
    std::erase_if(merged, [&](const Place& p) { return used_[p.border_sample] != 0; });
    return merged;
  }

  // The longest sequence of samples of a window without a gap. It is empty when the samples are too close together to
  // give a direction.
  Stretch longest(const std::vector<Place>& places) const {
    Stretch best;
    std::size_t first = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i > first && places[i].along - places[i - 1].along > kLineGapSteps * step_) first = i;
      if (i + 1 - first > best.size() && places[i].along - places[first].along >= kLeastRunSteps * step_)
        best = {first, i + 1};
    }
    return best;
  }

  static Run run_of(const std::vector<Place>& places, const Stretch& stretch, FlatPoint along) {
    Run run;
    for (std::size_t i = stretch.first; i < stretch.last; ++i) run.members.push_back(places[i].border_sample);
    run.along = along;
    run.low = places[stretch.first].along;
    run.high = places[stretch.last - 1].along;
    return run;
  }

  // Sets the offset of the run, across its direction, between the points that it separates.
  void place(Run& run) const {
    std::vector<StepGap> gaps;
    for (const std::uint32_t i : run.members)
      gaps.push_back({cross(run.along, seen_[i].upper), cross(run.along, seen_[i].lower)});
    run.offset = step_offset(gaps, step_ * step_ / (run.high - run.low));
  }

  std::vector<BorderSample> seen_;
  std::vector<FlatPoint> directions_;
  double step_;
  std::vector<std::uint8_t> used_;
  std::vector<std::vector<Place>> places_;        // per direction
  std::vector<std::vector<std::size_t>> starts_;  // per direction: where its strips begin, and the end of the last
  std::priority_queue<Window> windows_;
  mutable std::vector<Place> merged_;  // the result of places_in
};

// Moves a run onto the line of a wall of the outline or of a longer run that it continues. Otherwise only slivers would
// lie between the two lines.
void align(std::vector<Run>& runs, const std::vector<FlatEdge>& outline) {
  std::vector<Line> known;
  for (const FlatEdge& e : outline) {
    const FlatPoint d{e.b.x - e.a.x, e.b.y - e.a.y};
    const double length = std::sqrt(dot(d, d));
    if (length > 0) known.push_back({e.a, {d.x / length, d.y / length}});
  }
  for (Run& run : runs) {
    const FlatPoint low = on(run, run.low), high = on(run, run.high);
    const auto off = [&](const Line& line) {
      const auto from = [&](FlatPoint p) { return std::abs(cross(line.along, {p.x - line.at.x, p.y - line.at.y})); };
      return std::max(from(low), from(high));
    };
    const auto nearest =
        std::min_element(known.begin(), known.end(), [&](const Line& a, const Line& b) { return off(a) < off(b); });
    if (nearest == known.end() || off(*nearest) > kAligned) {
      known.push_back({low, run.along});
      continue;
    }
    const double turn = dot(nearest->along, run.along) < 0 ? -1 : 1;
    run.along = {turn * nearest->along.x, turn * nearest->along.y};
    run.offset = cross(run.along, nearest->at);
    run.low = dot(run.along, low);
    run.high = dot(run.along, high);
  }
}

void add_steps(const std::vector<Run>& runs, double extend, std::vector<FlatEdge>& lines) {
  for (const Run& run : runs) {
    lines.push_back({on(run, run.low - extend), on(run, run.high + extend)});
  }
}

// The length of a ray of unit direction until it meets an edge; nullopt when it does not.
std::optional<double> distance_along(FlatPoint from, FlatPoint direction, const FlatEdge& edge) {
  const FlatPoint along{edge.b.x - edge.a.x, edge.b.y - edge.a.y}, to{edge.a.x - from.x, edge.a.y - from.y};
  const double turn = cross(direction, along);
  if (turn == 0) return std::nullopt;
  const double t = cross(to, along) / turn, u = cross(to, direction) / turn;
  if (t < 0 || u < 0 || u > 1) return std::nullopt;
  return t;
}

// Extends both ends of every line to the next line or to the outline, where one is near enough.
std::vector<FlatEdge> reaching_the_next(const std::vector<FlatEdge>& lines, const std::vector<FlatEdge>& outline) {
  // Derived: ten steps of the grid of 1 mm.
  constexpr double kBeyond = 0.01;  // metres past what is met, so that rounding leaves no gap
  std::vector<FlatEdge> longer = lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const FlatPoint d{lines[i].b.x - lines[i].a.x, lines[i].b.y - lines[i].a.y};
    const double length = std::sqrt(dot(d, d));
    if (length <= 0) continue;
    const auto reach = [&](FlatPoint from, FlatPoint direction) {
      double nearest = kFarthest;
      const auto meet = [&](const FlatEdge& edge) {
        nearest = std::min(nearest, distance_along(from, direction, edge).value_or(kFarthest));
      };
      for (const FlatEdge& edge : outline) meet(edge);
      for (std::size_t j = 0; j < lines.size(); ++j)
        if (j != i) meet(lines[j]);
      if (nearest >= kFarthest) return from;
      return FlatPoint{from.x + (nearest + kBeyond) * direction.x, from.y + (nearest + kBeyond) * direction.y};
    };
    longer[i].a = reach(lines[i].a, {-d.x / length, -d.y / length});
    longer[i].b = reach(lines[i].b, {d.x / length, d.y / length});
  }
  return longer;
}

}  // namespace

std::vector<FlatEdge> roof_lines(const RoofSite& site, const RoofPlanes& planes) {
  std::vector<FlatEdge> lines;
  if (planes.planes.size() < 2) return lines;
  Borders borders = find_borders(site, planes);
  const std::vector<FlatPoint> directions = likely_directions(site, planes);
  add_creases(std::move(borders.creases), planes, lines);
  const std::vector<FlatEdge> outline = outline_edges(site.outline);
  if (!borders.steps.empty()) {
    std::vector<Run> runs = StepFinder(std::move(borders.steps), directions, planes.step).find();
    align(runs, outline);
    add_steps(runs, extension(planes), lines);
  }
  lines = reaching_the_next(lines, outline);
  const std::vector<FlatEdge> sides = face_rectangles(site, planes, directions, lines);
  lines.insert(lines.end(), sides.begin(), sides.end());
  return lines;
}

}  // namespace ilot
