// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/openings.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/openings/arched_top.h"
#include "engine/products/facades/openings/leaning_side.h"
#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: four points a cell; openings below three cells are lost.
constexpr double kCellSteps = 2, kLeastCell = 0.02, kMostCell = 0.15;  // metres
// Choice: posts between windows are narrower; wider ones part an opening in two.
constexpr double kWidestBar = 0.15;  // metres; bars and frames that are nearly as far out as the wall
// Choice: the mouldings around an opening are narrower; windows closer than that to the end of the wall are found by
// what is between.
constexpr double kBoundReach = 0.5;  // metres beyond an opening in which the wall must continue
// Derived: a majority.
constexpr double kBoundShare = 0.5;  // share of its height or width
// Choice: less than a fifth seen is a shadow; windows behind trees are lost.
constexpr double kLeastKnown = 0.2;  // share of it about which something must be known
// Choice: a triangle fills half of its box.
constexpr double kLeastFill = 0.5;  // share of its box that its cells cover
// Choice: an arch takes the corners of its box; a gable window ends too far in.
constexpr double kTail = 0.15;  // share of its rows and columns that may end farther out
// Choice: twice the noise of 5 mm; noisier scans spread a pane over several bins.
constexpr double kDepthBin = 0.01;  // metres
// Choice: a window bar covers a tenth of an opening, a pane seen through a tree a quarter.
constexpr double kCoverShare = 0.25;  // share of the widest spread
// Choice: reveals of thick walls are 0.6 m deep; a pane that is deeper than a metre is taken for the room.
constexpr double kSheetDepth = 1;               // metres; the surface that fills an opening is not deeper
constexpr std::uint64_t kMostOnPane = 1 << 17;  // points of the surface that fills it; more do not improve the result

using enum WallCells::What;

// The numbers of rays of a cell.
struct CellCounts {
  std::uint32_t solid = 0, through = 0, shallow = 0, blocked = 0;

  WallCells::What what() const {
    if (through > solid) return kThrough;
    if (solid > 0) return kSolid;
    if (blocked > 0) return kBlocked;
    return shallow > 0 ? kShallow : kUnknown;
  }
};

double depth_through(const FacadeSite& site, const OpeningParams& params) {
  return std::max(params.least_depth, 3 * site.epsilon);
}

// Counts the rays that cross the rows of cells [r0, r1).
void count_rows(const RaySamples& samples, const OpeningParams& params, std::int64_t r0, std::int64_t r1,
                WallCells& cells) {
  const FacadeSite& site = samples.site();
  const double least_depth = depth_through(site, params);
  const double farthest = samples.oblique() ? params.room_depth : params.room_depth_square;
  std::vector<CellCounts> counts(static_cast<std::size_t>((r1 - r0) * cells.columns));
  const Box2 rows{0, static_cast<double>(cells.columns) * cells.cell, static_cast<double>(r0) * cells.cell,
                  static_cast<double>(r1) * cells.cell};
  for (const Ray& ray : samples.near(rows.grown(cells.cell))) {
    const double w = ray.at.w;
    if (w < -farthest) continue;
    const Place2 p = samples.crossing(ray, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / cells.cell), r = static_cast<std::int64_t>(p.v / cells.cell);
    if (c >= cells.columns || r < r0 || r >= r1) continue;
    CellCounts& at = counts[static_cast<std::size_t>((r - r0) * cells.columns + c)];
    const bool wall = samples.on_wall(ray);
    if (wall) ++at.solid;
    if (!wall && w < 0) ++(w < -least_depth ? at.through : at.shallow);
    if (w > site.epsilon) ++at.blocked;
  }
  for (std::size_t i = 0; i < counts.size(); ++i)
    cells.what[static_cast<std::size_t>(r0 * cells.columns) + i] = counts[i].what();
}

WallCells cells_of(const RaySamples& samples, const OpeningParams& params) {
  const FacadeSite& site = samples.site();
  WallCells cells;
  cells.cell = cell_for(site.width, site.height, std::clamp(kCellSteps * site.step, kLeastCell, kMostCell));
  cells.columns = static_cast<std::int64_t>(site.width / cells.cell) + 1;
  cells.rows = static_cast<std::int64_t>(site.height / cells.cell) + 1;
  cells.what.assign(static_cast<std::size_t>(cells.columns * cells.rows), kUnknown);
  for (const RowBand& band : bands_of(cells.columns, cells.rows))
    count_rows(samples, params, band.first, band.end, cells);
  return cells;
}

// Fills runs of cells in which nothing was seen, or only something before the wall, if they are between two cells
// through which rays went, along rows and columns. A joint from one opening to the next is not such a run, because its
// back was seen. Frames and bars at such a small depth behind the wall are narrower.
WallCells filled(const WallCells& cells, double longest) {
  WallCells out = cells;
  const auto most = static_cast<std::int64_t>(longest / cells.cell) + 1;
  const auto most_shallow = static_cast<std::int64_t>(kWidestBar / cells.cell) + 1;
  const auto fill_line = [&](std::int64_t c, std::int64_t r, std::int64_t dc, std::int64_t dr, std::int64_t length) {
    std::int64_t last = -1, shallow = 0;
    for (std::int64_t i = 0; i < length; ++i) {
      const std::uint8_t what = cells.at(c + i * dc, r + i * dr);
      shallow += what == kShallow;
      if (what == kThrough) {
        if (last >= 0 && i - last <= most && shallow <= most_shallow)
          for (std::int64_t k = last + 1; k < i; ++k) out.at(c + k * dc, r + k * dr) = kThrough;
        last = i;
        shallow = 0;
      } else if (what == kSolid) {
        last = -1;
      }
    }
  };
  for (std::int64_t r = 0; r < cells.rows; ++r) fill_line(0, r, 1, 0, cells.columns);
  for (std::int64_t c = 0; c < cells.columns; ++c) fill_line(c, 0, 0, 1, cells.rows);
  return out;
}

struct Region {
  std::vector<std::uint32_t> cells;  // row * columns + column
};

// Calls visit(region) for each region, in the order of their first cells.
template <class Visit>
void for_each_region(const WallCells& cells, const Visit& visit) {
  std::vector<bool> taken(cells.what.size(), false);
  for (std::size_t start = 0; start < taken.size(); ++start) {
    if (taken[start] || cells.what[start] != kThrough) continue;
    Region region;
    region.cells = {static_cast<std::uint32_t>(start)};
    taken[start] = true;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % cells.columns, r = region.cells[i] / cells.columns;
      const auto take = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= cells.columns || nr >= cells.rows) return;
        const auto n = static_cast<std::size_t>(nr * cells.columns + nc);
        if (taken[n] || cells.what[n] != kThrough) return;
        taken[n] = true;
        region.cells.push_back(static_cast<std::uint32_t>(n));
      };
      take(c - 1, r), take(c + 1, r), take(c, r - 1), take(c, r + 1);
    }
    visit(region);
  }
}

struct CellBox {
  std::int64_t c0, c1, r0, r1;
};

// Its sides are where the farthest rows and columns end, except for a few. Shadows end other rows too early, and single
// cells go beyond.
CellBox box_of(const Region& region, std::int64_t columns) {
  CellBox all{INT64_MAX, -1, INT64_MAX, -1};
  for (const std::int64_t i : region.cells) {
    all = {std::min(all.c0, i % columns), std::max(all.c1, i % columns), std::min(all.r0, i / columns),
           std::max(all.r1, i / columns)};
  }
  std::vector<std::int64_t> left(static_cast<std::size_t>(all.r1 - all.r0 + 1), INT64_MAX), right(left.size(), -1);
  std::vector<std::int64_t> low(static_cast<std::size_t>(all.c1 - all.c0 + 1), INT64_MAX), high(low.size(), -1);
  for (const std::int64_t i : region.cells) {
    const auto r = static_cast<std::size_t>(i / columns - all.r0), c = static_cast<std::size_t>(i % columns - all.c0);
    left[r] = std::min(left[r], i % columns), right[r] = std::max(right[r], i % columns);
    low[c] = std::min(low[c], i / columns), high[c] = std::max(high[c], i / columns);
  }
  return {lower_quantile(left, kTail), lower_quantile(right, 1 - kTail), lower_quantile(low, kTail),
          lower_quantile(high, 1 - kTail)};
}

// The share of the lines across a side, among those of which something is known beyond the opening, on which the wall
// continues. It is 0 where little is known.
double bounded(const WallCells& cells, const CellBox& box, Side side, const OpeningParams& params) {
  const bool u = side == Side::left || side == Side::right;
  const auto reach =
      static_cast<std::int64_t>((side == Side::top ? params.hidden_above : kBoundReach) / cells.cell) + 1;
  const std::int64_t from = u ? box.r0 : box.c0, to = u ? box.r1 : box.c1;
  std::int64_t found = 0, known = 0;
  for (std::int64_t i = from; i <= to; ++i) {
    bool solid = false, unknown = true;
    for (std::int64_t k = 1; k <= reach && !solid; ++k) {
      const std::int64_t c = side == Side::left ? box.c0 - k : side == Side::right ? box.c1 + k : i;
      const std::int64_t r = side == Side::bottom ? box.r0 - k : side == Side::top ? box.r1 + k : i;
      if (c < 0 || r < 0 || c >= cells.columns || r >= cells.rows) {
        unknown = false;
        break;
      }
      const std::uint8_t what = cells.at(c, r);
      solid = what == kSolid || (side == Side::top && what == kBlocked);  // a canopy or a sign hides the wall
      unknown = unknown && (what == kUnknown || what == kShallow);
    }
    found += solid;
    known += !unknown;
  }
  const auto lines = static_cast<double>(to - from + 1);
  return static_cast<double>(known) < kLeastKnown * lines ? 0 : static_cast<double>(found) / static_cast<double>(known);
}

// Finds the surface that fills an opening: the foremost depth at which points are spread over the opening nearly as far
// as at any other depth. A railing is nearer, but it covers only a part. Panes are deeper than their frame, and the
// frame is seen all around.
class FillingDepth {
 public:
  explicit FillingDepth(const Box2& box) : box_(box), touched_(kBins * kAcross * kAcross) {}

  void add(const FacadePoint& at) {
    const auto part = [&](double v, double low, double size) {
      return std::min(kAcross - 1, static_cast<std::size_t>(std::max(0.0, (v - low) / size * kAcross)));
    };
    const double depth = -static_cast<double>(at.w);
    if (depth >= kSheetDepth || !box_.contains({at.u, at.v})) return;
    const std::size_t cell = part(at.v, box_.v0, box_.height()) * kAcross + part(at.u, box_.u0, box_.width());
    touched_[static_cast<std::size_t>(depth / kDepthBin) * kAcross * kAcross + cell] = 1;
  }

  double depth() const {
    const std::vector<std::size_t> cover = covered();
    const std::size_t most = *std::max_element(cover.begin(), cover.end());
    for (std::size_t b = 0; b < kBins; ++b)
      if (static_cast<double>(cover[b]) >= kCoverShare * static_cast<double>(most))
        return (static_cast<double>(b) + (b + 1 < kBins && cover[b + 1] > cover[b] ? 2 : 1)) * kDepthBin;
    return 0;
  }

 private:
  static constexpr std::size_t kAcross = 10;
  static constexpr std::size_t kBins = static_cast<std::size_t>(kSheetDepth / kDepthBin) + 1;

  // For each depth, the number of covered cells in the quarter of the opening that has the fewest.
  std::vector<std::size_t> covered() const {
    std::vector<std::size_t> cover(kBins);
    for (std::size_t b = 0; b < kBins; ++b) {
      std::array<std::size_t, 4> quarters{};
      for (std::size_t c = 0; c < kAcross * kAcross; ++c) {  // a sheet may lie across two bins
        const std::size_t column = c % kAcross, row = c / kAcross;
        if (column == 0 || row == 0 || column + 1 == kAcross || row + 1 == kAcross) continue;  // reveals are there
        const std::size_t quarter = 2 * (2 * row / kAcross) + 2 * column / kAcross;
        const std::uint8_t next = b + 1 < kBins ? touched_[(b + 1) * kAcross * kAcross + c] : std::uint8_t{0};
        quarters[quarter] += touched_[b * kAcross * kAcross + c] | next;
      }
      cover[b] = *std::min_element(quarters.begin(), quarters.end());
    }
    return cover;
  }

  Box2 box_;
  std::vector<std::uint8_t> touched_;
};

void set_depth(const RaySamples& samples, const Box2& box, double least_depth, FoundRectangle& opening) {
  const auto is_inside = [&](const Ray& ray) {
    return -static_cast<double>(ray.at.w) >= least_depth && box.contains(samples.crossing(ray, 0));
  };
  Rays near = samples.near(box);
  FillingDepth filling(box);
  for (const Ray& ray : near)
    if (is_inside(ray)) filling.add(ray.at), ++opening.points;
  const double middle = filling.depth();
  const auto off_of = [&](const Ray& ray) { return -static_cast<double>(ray.at.w) - middle; };
  const auto is_on_it = [&](const Ray& ray) { return is_inside(ray) && std::abs(off_of(ray)) <= kDepthBin; };
  const int level = thinning_level(near, kMostOnPane, is_on_it);
  std::vector<double> off;
  for (const Ray& ray : near)
    if (is_on_it(ray) && is_kept(ray, level)) off.push_back(off_of(ray));
  if (off.empty()) return;
  const double centre = upper_median(off);
  double squares = 0;
  for (const double d : off) squares += (d - centre) * (d - centre);
  opening.depth = -(middle + centre);
  opening.depth_error = samples.site().noise + 2 * std::sqrt(squares) / static_cast<double>(off.size());
}

// Jambs and heads that are not perpendicular to each other keep their directions: the place of such a side is that of
// its middle.
void set_leaning_sides(const RaySamples& samples, FoundRectangle& opening) {
  const FoundRectangle straight = opening;
  for (const Side side : kSides) {
    const std::optional<LeaningSide> line = find_leaning_side(samples, straight, side);
    if (!line) continue;
    LocatedEdge& edge = opening.side(side);
    edge.at = edge.inner = line->at, edge.error = line->error, edge.rms = line->rms;
    edge.status = DrawnStatus::seen;
    opening.lean[static_cast<std::size_t>(side)] = line->lean;
  }
}

// The opening in a region of cells; no result if it is none.
std::optional<FoundRectangle> opening_of(const RaySamples& samples, const WallCells& cells, const Region& region,
                                         const OpeningParams& params) {
  const FacadeSite& site = samples.site();
  const double through = depth_through(site, params);
  const CellBox box = box_of(region, cells.columns);
  const auto edge = [&](std::int64_t i) { return static_cast<double>(i) * cells.cell; };
  Box2 around{edge(box.c0), edge(box.c1 + 1), edge(box.r0), edge(box.r1 + 1)};
  if (around.width() < params.least_size || around.height() < params.least_size) return std::nullopt;
  if (bounded(cells, box, Side::left, params) < kBoundShare || bounded(cells, box, Side::right, params) < kBoundShare ||
      bounded(cells, box, Side::top, params) < kBoundShare)
    return std::nullopt;
  FoundRectangle opening;
  opening.fill =
      static_cast<double>(region.cells.size()) / static_cast<double>((box.c1 - box.c0 + 1) * (box.r1 - box.r0 + 1));
  if (opening.fill < kLeastFill) return std::nullopt;
  set_depth(samples, around, through, opening);
  const double margin = std::max(0.015, 2 * site.epsilon);
  SideSearch search{around, 0, site.epsilon, true, opening.depth + 0.03, -margin, std::max(0.12, 2.5 * cells.cell), {}};
  // A line from a rough box is searched a second time from where it was found.
  for (int round = 0; round < 2; ++round) {
    for (const Side side : kSides) opening.side(side) = locate_edge(samples, search, side);
    search.box = {opening.side(Side::left).inner, opening.side(Side::right).inner, opening.side(Side::bottom).inner,
                  opening.side(Side::top).inner};
  }
  if (opening.at(Side::right) - opening.at(Side::left) < params.least_size ||
      opening.at(Side::top) - opening.at(Side::bottom) < params.least_size)
    return std::nullopt;
  set_leaning_sides(samples, opening);
  if (opening.lean_of(Side::top) == 0) opening.arc = find_arched_top(samples, opening, params.arch_misfit);
  if (opening.arc) {
    LocatedEdge& crown = opening.side(Side::top);
    crown = {opening.arc->centre.v + opening.arc->radius, opening.arc->error};
    crown.points = opening.arc->points;
    crown.rms = opening.arc->rms;
    crown.inner = crown.at;
  }
  return opening;
}

}  // namespace

std::vector<FoundRectangle> find_openings(const RaySamples& samples, const OpeningParams& params, OpeningSteps* steps) {
  const WallCells seen = cells_of(samples, params), cells = filled(seen, params.shadow);
  if (steps != nullptr) *steps = {seen, cells};
  std::vector<FoundRectangle> found;
  for_each_region(cells, [&](const Region& region) {
    if (const std::optional<FoundRectangle> opening = opening_of(samples, cells, region, params))
      found.push_back(*opening);
  });
  return found;
}

}  // namespace ilot
