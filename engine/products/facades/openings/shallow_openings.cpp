// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/shallow_openings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "engine/products/facades/openings/trend_surface.h"
#include "engine/products/facades/openings/wall_means.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: what lies deeper is found without this: rays go through there.
constexpr double kDeepest = 0.15;  // metres
// Choice: as kSquare in silent_holes.cpp: joints between stones are narrower.
constexpr double kPaneSquare = 0.8;  // share of the smallest opening
constexpr double kStrayWall = 0.15;  // Choice: bars; share of the cells of such a square on which there may be wall
// Derived: as kCellsOfBar in panes.cpp.
constexpr double kCellsOfPole = 2;  // cells across the widest bar from which on what it hides is filled
// Choice: doors of barns; what is larger is a wall that is set back.
constexpr double kLargestPane = 4;  // metres, width and height
// Choice: two thirds of the rows, as kStraight in silent_holes.cpp.
constexpr double kStraightPane = 0.66;  // share of rows and columns that end at a straight side
constexpr double kPaneFill = 0.6;       // Choice: a half circle fills 0.785 of its box; a corner may be hidden
// Choice: the width of a narrow pier.
constexpr double kRingFrom = 0.05, kRingTo = 0.35;  // metres beside a pane in which the wall about it is measured
// Derived: the medians of twelve and twelve points differ by chance by 0.51 of the scatter (one standard deviation), so
// that a step of twice the scatter is four of these.
constexpr std::size_t kFewestOnSheet = 12;  // points of a pane and of the wall about it
// Choice: as kBoundReach in openings.cpp, and a cell.
constexpr double kLocalMargin = 0.65;          // metres of the wall about a pane that are looked at again
constexpr std::uint64_t kMostLocal = 1 << 17;  // points of that; more do not improve the result
constexpr double kScatterOfMedian = 1.4826;    // Derived: standard deviation over median distance, normal noise
constexpr double kScatterBefore = 3;  // Derived: all but one point in 700; times the scatter: wall before its middle
// Choice: where the wall bows more than its form follows, a pane is connected with the wall at a small step; so larger
// ones are tried too, each half as large again.
constexpr double kNextStep = 1.5;    // times the step before
constexpr double kSameBox = 0.9;     // Choice: a cell at the sides of a window; share that two boxes of one region have
constexpr double kPieceShare = 0.6;  // Choice: more than half, with the errors of both; share of a piece

using enum WallCells::What;

double off_form(const TrendSurface& form, const Ray& ray) {
  return static_cast<double>(ray.at.w) - form.at(ray.at.u, ray.at.v);
}

// Marks the cells whose points lie behind the form by more than half of a step in the mean. Cells without points that
// rays are known to have crossed belong to the pane: it is clean there, and dusty elsewhere.
void mark_cells(const WallMeans& means, double step, WallCells& marks) {
  for (std::size_t i = 0; i < marks.what.size(); ++i) {
    std::uint8_t& what = marks.what[i];
    if (means.has(i))
      what = static_cast<double>(means.mean[i]) < -step / 2 ? kThrough : kSolid;
    else
      what = what == kThrough ? kThrough : kUnknown;
  }
}

// A cell without points is behind where five of its neighbours are: panes give fewer echoes than walls. So are those
// that nothing wider than a bar hides from side to side, where cells are so small that a pier does not look like one.
WallCells without_gaps(const WallCells& marks) {
  WallCells out = marks;
  for (std::int64_t r = 1; r + 1 < marks.rows; ++r)
    for (std::int64_t c = 1; c + 1 < marks.columns; ++c) {
      if (marks.at(c, r) != kUnknown) continue;
      int behind = 0;
      for (std::int64_t k = 0; k < 9; ++k) behind += marks.at(c - 1 + k % 3, r - 1 + k / 3) == kThrough;
      if (behind >= 5) out.at(c, r) = kThrough;
    }
  return kCellsOfPole * marks.cell <= kWidestBar ? filled(out, kWidestBar) : out;
}

// The wall about a pane, levelled.
struct LocalWall {
  FacadeSite site;
  Place2 from;      // its origin in the axes of the wall
  double step = 0;  // metres from the wall to the pane
};

double scatter_of(std::vector<double> values, double middle) {
  for (double& v : values) v = std::abs(v - middle);
  return kScatterOfMedian * upper_median(values);
}

// Where the wall about a pane lies, how it scatters, and how far the pane is behind it; no result where that is no
// step.
struct Step {
  double wall = 0, noise = 0, depth = 0;
};

std::optional<Step> step_at_pane(const RaySamples& samples, const TrendSurface& form, const Box2& box, double least,
                                 const std::vector<Box2>& panes) {
  const Box2 inner = box.grown(-kRingFrom), from = box.grown(kRingFrom), to = box.grown(kRingTo);
  std::vector<Box2> others;
  for (const Box2& p : panes)
    if (common_area(p, to) > 0) others.push_back(p);
  const auto in_pane = [&](Place2 p) {
    return std::any_of(others.begin(), others.end(), [&](const Box2& b) { return b.contains(p); });
  };
  Rays near = samples.near(to);
  const auto counts = [&](const Ray& ray) {
    return std::abs(off_form(form, ray)) < kDeepest && to.contains(samples.crossing(ray, 0));
  };
  const int level = thinning_level(near, kMostLocal, counts);
  std::vector<double> wall, pane;
  for (const Ray& ray : near) {
    if (!counts(ray) || !is_kept(ray, level)) continue;
    const Place2 p = samples.crossing(ray, 0);
    const double off = off_form(form, ray);
    if (inner.contains(p) && off < least / 2) pane.push_back(off);
    if (!from.contains(p) && std::abs(off) < std::max({least, 2 * kLeastStep, kScatterBefore * form.noise}) &&
        !in_pane(p))
      wall.push_back(off);
  }
  if (wall.size() < kFewestOnSheet || pane.size() < kFewestOnSheet) return std::nullopt;
  Step step;
  step.wall = upper_median(wall);
  step.noise = scatter_of(wall, step.wall);
  step.depth = step.wall - upper_median(pane);
  const double cell = std::min(1.0, kStepsACell * samples.site().step / kWidestMean);
  if (step.depth < std::max(kLeastStep, kStepOfNoise * step.noise * cell)) return std::nullopt;
  return step;
}

// The points about a pane as a wall of their own.
LocalWall local_wall(const RaySamples& samples, const TrendSurface& form, const Box2& box, const Step& step,
                     const OpeningParams& params) {
  const FacadeSite& whole = samples.site();
  const Box2 around{std::max(0.0, box.u0 - kLocalMargin), std::min(whole.width, box.u1 + kLocalMargin),
                    std::max(0.0, box.v0 - kLocalMargin),
                    std::min(whole.height, box.v1 + params.hidden_above + kLocalMargin)};
  LocalWall local;
  local.from = {around.u0, around.v0};
  local.step = step.depth;
  FacadeSite& site = local.site;
  site.axes = whole.axes;
  site.width = around.width(), site.height = around.height();
  site.epsilon = step.depth / 2, site.noise = step.noise;
  site.step = whole.step * std::max(1.0, kStepOfNoise * step.noise / step.depth);
  for (FacadeStation s : whole.stations) {
    s.position = {s.position.x - around.u0, s.position.y - around.v0, s.position.z - step.wall};
    site.stations.push_back(s);
  }
  Rays near = samples.near(around);
  const auto counts = [&](const Ray& ray) { return around.contains(samples.crossing(ray, 0)); };
  const int level = thinning_level(near, kMostLocal, counts);
  for (const Ray& ray : near) {
    if (!counts(ray) || !is_kept(ray, level)) continue;
    double off = off_form(form, ray) - step.wall;
    if (off > 0 && off < kScatterBefore * step.noise) off = std::min(off, site.epsilon / 2);
    site.points.push_back({static_cast<float>(static_cast<double>(ray.at.u) - around.u0),
                           static_cast<float>(static_cast<double>(ray.at.v) - around.v0), static_cast<float>(off), 0});
    if (samples.oblique()) site.from.push_back(static_cast<SiteStation>(ray.station + 1));
  }
  return local;
}

void move_by(Place2 from, FoundRectangle& r) {
  for (const Side side : kSides) {
    const double by = side == Side::left || side == Side::right ? from.u : from.v;
    r.side(side).at += by, r.side(side).inner += by;
  }
  if (r.arc) r.arc->centre = {r.arc->centre.u + from.u, r.arc->centre.v + from.v};
}

// Joins cells over shadows at a marked pane only. Beyond it, what lies between this pane and the next one divides them:
// their piers are often hidden by open shutters or in the shadow of one.
WallCells filled_at(const Box2& pane, const WallCells& seen, double longest) {
  WallCells out = filled(seen, longest);
  const Box2 joined = pane.grown(seen.cell);
  for (std::int64_t r = 0; r < out.rows; ++r)
    for (std::int64_t c = 0; c < out.columns; ++c)
      if (!joined.contains({(static_cast<double>(c) + 0.5) * out.cell, (static_cast<double>(r) + 0.5) * out.cell}))
        out.at(c, r) = seen.at(c, r);
  return out;
}

// The cells of the wall about a pane. Those without points take over that rays crossed them; `silent` marks them.
WallCells cells_about(const RaySamples& about, const WallCells& whole, Place2 from, const WallCellParams& params,
                      std::vector<bool>& silent) {
  WallCells cells = cells_of(about, params);
  silent.assign(cells.what.size(), false);
  for (std::size_t i = 0; i < cells.what.size(); ++i) {
    const auto at = static_cast<std::int64_t>(i);
    const double u = from.u + (static_cast<double>(at % cells.columns) + 0.5) * cells.cell;
    const double v = from.v + (static_cast<double>(at / cells.columns) + 0.5) * cells.cell;
    const auto c = static_cast<std::int64_t>(u / whole.cell), r = static_cast<std::int64_t>(v / whole.cell);
    if (cells.what[i] != kUnknown || c >= whole.columns || r >= whole.rows || whole.at(c, r) != kThrough) continue;
    cells.what[i] = kThrough;
    silent[i] = true;
  }
  return cells;
}

// Whether the sides of a region are straight, or its head is that of an arch: as its cells show, or as the rays do.
bool has_form_of_opening(const FoundRectangle& opening, const CellRegion& region, const CellBox& box,
                         const WallCells& cells) {
  return opening.arc || opening.pointed || straight_share(region, box, cells.columns) >= kStraightPane ||
         straight_share_at_wall(region, box, cells) >= kStraightPane || has_arched_top(region, box, cells.columns);
}

// The opening in those cells of the wall about a marked pane that are connected with its middle.
std::optional<FoundRectangle> opening_at(const RaySamples& about, const WallCells& cells,
                                         const std::vector<bool>& silent, const Box2& pane, double through,
                                         const OpeningParams& params) {
  const Place2 middle{(pane.u0 + pane.u1) / 2, (pane.v0 + pane.v1) / 2};
  std::optional<FoundRectangle> opening;
  for_each_region(
      cells, [&](std::size_t i) { return cells.what[i] == kThrough; },
      [&](const CellRegion& region) {
        const CellBox b = box_of(region, cells.columns);
        const double c = middle.u / cells.cell, r = middle.v / cells.cell;
        if (c < static_cast<double>(b.c0) || c > static_cast<double>(b.c1 + 1) || r < static_cast<double>(b.r0) ||
            r > static_cast<double>(b.r1 + 1))
          return;
        std::optional<FoundRectangle> found = opening_in(about, cells, region, silent, through, params);
        if (found && has_form_of_opening(*found, region, b, cells)) opening = std::move(found);
      });
  return opening;
}

// The opening about a marked box.
std::optional<FoundRectangle> shallow_opening(const RaySamples& samples, const TrendSurface& form, const Box2& box,
                                              double least, const std::vector<Box2>& panes, const WallCells& whole,
                                              const OpeningParams& params) {
  const std::optional<Step> step = step_at_pane(samples, form, box, least, panes);
  if (!step) return std::nullopt;
  const LocalWall local = local_wall(samples, form, box, *step, params);
  const RaySamples about(local.site);
  const double through = step->depth / 2;
  const Box2 pane{box.u0 - local.from.u, box.u1 - local.from.u, box.v0 - local.from.v, box.v1 - local.from.v};
  std::vector<bool> silent;
  const WallCells seen = cells_about(about, whole, local.from, {through, farthest_in_room(samples, params)}, silent);
  std::optional<FoundRectangle> opening = opening_at(about, filled(seen, params.shadow), silent, pane, through, params);
  if (!opening) opening = opening_at(about, filled_at(pane, seen, params.shadow), silent, pane, through, params);
  if (opening) move_by(local.from, *opening);
  return opening;
}

// The boxes of the regions whose cells lie behind the form by more than half of a step.
std::vector<Box2> boxes_behind(const WallMeans& means, const WallCells& cells, double step,
                               const OpeningParams& params) {
  WallCells marks = cells;
  mark_cells(means, step, marks);
  marks = without_gaps(marks);
  std::vector<bool> obstacles(marks.what.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) obstacles[i] = marks.what[i] != kThrough;
  const auto side = std::max<std::int64_t>(3, std::llround(kPaneSquare * params.least_size / marks.cell));
  const std::vector<bool> panes = covered_by_squares(marks, obstacles, side, kStrayWall);
  std::vector<Box2> boxes;
  for_each_region(
      marks, [&](std::size_t i) { return panes[i]; },
      [&](const CellRegion& region) {
        const CellBox b = box_of(region, marks.columns);
        const double fill = static_cast<double>(region.cells.size()) / static_cast<double>(b.columns() * b.rows());
        const Box2 box = box_in_metres(b, marks.cell);
        if (fill >= kPaneFill && std::min(box.width(), box.height()) >= params.least_size &&
            std::max(box.width(), box.height()) <= kLargestPane)
          boxes.push_back(box);
      });
  return boxes;
}

}  // namespace

std::vector<FoundRectangle> find_shallow_openings(const RaySamples& samples, const WallCells& cells,
                                                  const OpeningParams& params) {
  const TrendSurface form = trend_surface(samples);
  if (!form.found) return {};
  // Points that stand before the wall (pipes, cables, leaves of plants) show nothing of what they hide.
  const double before = std::max(kLeastStep, kStepOfNoise * form.noise);
  const WallMeans means = means_about_cells(
      samples, form, cells, {-kDeepest, before, -before - kStepOfNoise * form.noise, kStepOfNoise * form.noise});
  std::vector<FoundRectangle> found;
  std::vector<Box2> seen;
  for (double step = means.step; step < depth_through(samples.site(), params); step *= kNextStep) {
    const std::vector<Box2> panes = boxes_behind(means, cells, step, params);
    for (const Box2& box : panes) {
      const double area = area_of(box);
      const auto is_same = [&](const Box2& b) { return common_area(b, box) > kSameBox * std::max(area, area_of(b)); };
      const auto is_in = [&](const FoundRectangle& o) { return common_area(o.box(), box) > kPieceShare * area; };
      if (std::any_of(seen.begin(), seen.end(), is_same) || std::any_of(found.begin(), found.end(), is_in)) continue;
      seen.push_back(box);
      if (const std::optional<FoundRectangle> opening = shallow_opening(samples, form, box, step, panes, cells, params))
        found.push_back(*opening);
    }
  }
  return found;
}

namespace {

// Whether an opening is a part of another one that goes on beyond it, by more than the errors of both.
bool is_part(const FoundRectangle& part, const FoundRectangle& whole) {
  bool farther = false;
  for (const Side side : kSides) {
    const bool low = side == Side::left || side == Side::bottom;
    const double beyond = low ? part.at(side) - whole.at(side) : whole.at(side) - part.at(side);
    const double error = part.error(side) + whole.error(side);
    if (beyond < -error) return false;
    farther |= beyond > error;
  }
  return farther;
}

}  // namespace

void add_shallow_openings(std::vector<FoundRectangle>&& shallow, std::vector<FoundRectangle>& found) {
  for (FoundRectangle& s : shallow) {
    const Box2 own = s.box();
    const bool known = std::any_of(found.begin(), found.end(), [&](const FoundRectangle& o) {
      return common_area(own, o.box()) > kPieceShare * area_of(own) && !is_part(o, s);
    });
    if (known) continue;
    std::erase_if(found,
                  [&](const FoundRectangle& o) { return common_area(own, o.box()) > kPieceShare * area_of(o.box()); });
    found.push_back(std::move(s));
  }
}

}  // namespace ilot
