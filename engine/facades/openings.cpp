// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/openings.h"

#include <algorithm>
#include <cmath>

#include "engine/facades/arched_top.h"
#include "engine/facades/leaning_side.h"

namespace ilot {
namespace {

constexpr double kCellSteps = 2, kLeastCell = 0.02, kMostCell = 0.15;  // metres
constexpr double kWidestBar = 0.15;   // metres; bars and frames nearly as far out as the wall
constexpr double kBoundReach = 0.5;   // metres beyond an opening where the wall must go on
constexpr double kTopReach = 1.5;     // above it, where signs and blinds hide the wall
constexpr double kBoundShare = 0.5;   // of its height or width
constexpr double kLeastKnown = 0.2;   // of it, that something must be known of
constexpr double kLeastFill = 0.5;    // share of its box that its cells cover
constexpr double kTail = 0.15;        // of its rows and columns that may end farther out
constexpr double kMostBehind = 4;     // metres; rooms beyond panes
constexpr double kMostSquare = 2.5;   // metres, of rays only taken to be square: beyond that is the house's other side
constexpr double kDepthBin = 0.01;    // metres
constexpr double kCoverShare = 0.25;  // of the widest spread
constexpr double kSheetDepth = 1;     // metres; what fills an opening lies no deeper

enum Cell : std::uint8_t {
  kUnknown,
  kSolid,
  kThrough,
  kBlocked,  // something before the wall
  kShallow,  // too little behind it to be an opening: joints of stone
};

// The wall in cells.
struct WallCells {
  double cell = 0;
  std::int64_t columns = 0, rows = 0;
  std::vector<std::uint8_t> what;

  std::uint8_t& at(std::int64_t c, std::int64_t r) { return what[static_cast<std::size_t>(r * columns + c)]; }
  std::uint8_t at(std::int64_t c, std::int64_t r) const { return what[static_cast<std::size_t>(r * columns + c)]; }
};

WallCells cells_of(const RaySamples& samples, double least_depth) {
  const FacadeSite& site = samples.site();
  WallCells cells;
  cells.cell = std::clamp(kCellSteps * site.step, kLeastCell, kMostCell);
  cells.columns = static_cast<std::int64_t>(site.width / cells.cell) + 1;
  cells.rows = static_cast<std::int64_t>(site.height / cells.cell) + 1;
  const auto count = static_cast<std::size_t>(cells.columns * cells.rows);
  std::vector<std::uint32_t> solid(count), through(count), shallow(count), blocked(count);
  for (std::uint32_t i = 0; i < site.points.size(); ++i) {
    const double w = site.points[i].w;
    if (w < (samples.oblique() ? -kMostBehind : -kMostSquare)) continue;
    const Place2 p = samples.crossing(i, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / cells.cell), r = static_cast<std::int64_t>(p.v / cells.cell);
    if (c >= cells.columns || r >= cells.rows) continue;
    const auto at = static_cast<std::size_t>(r * cells.columns + c);
    const bool wall = samples.on_wall(i);
    if (wall) ++solid[at];
    if (!wall && w < 0) ++(w < -least_depth ? through : shallow)[at];
    if (w > site.epsilon) ++blocked[at];
  }
  cells.what.assign(count, kUnknown);
  for (std::size_t i = 0; i < count; ++i) {
    if (through[i] > solid[i])
      cells.what[i] = kThrough;
    else if (solid[i] > 0)
      cells.what[i] = kSolid;
    else if (blocked[i] > 0)
      cells.what[i] = kBlocked;
    else if (shallow[i] > 0)
      cells.what[i] = kShallow;
  }
  return cells;
}

// Fills runs of cells that nothing was seen in, or only something before the wall, between two cells that rays went
// through, along rows and columns. A joint from one opening to the next is none of these, its back was seen; frames and
// bars so little behind the wall are narrower.
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
  std::vector<std::int64_t> cells;  // row * columns + column
};

std::vector<Region> regions_of(const WallCells& cells) {
  std::vector<Region> regions;
  std::vector<std::uint8_t> taken(cells.what.size());
  for (std::int64_t start = 0; start < static_cast<std::int64_t>(taken.size()); ++start) {
    if (taken[static_cast<std::size_t>(start)] != 0 || cells.what[static_cast<std::size_t>(start)] != kThrough)
      continue;
    Region region;
    region.cells = {start};
    taken[static_cast<std::size_t>(start)] = 1;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % cells.columns, r = region.cells[i] / cells.columns;
      const auto visit = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= cells.columns || nr >= cells.rows) return;
        const std::int64_t n = nr * cells.columns + nc;
        if (taken[static_cast<std::size_t>(n)] != 0 || cells.what[static_cast<std::size_t>(n)] != kThrough) return;
        taken[static_cast<std::size_t>(n)] = 1;
        region.cells.push_back(n);
      };
      visit(c - 1, r), visit(c + 1, r), visit(c, r - 1), visit(c, r + 1);
    }
    regions.push_back(std::move(region));
  }
  return regions;
}

std::int64_t quantile(std::vector<std::int64_t>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

struct CellBox {
  std::int64_t c0, c1, r0, r1;
};

// Its sides where the farthest rows and columns end, but for some: shadows end others too early, single cells leak.
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
  return {quantile(left, kTail), quantile(right, 1 - kTail), quantile(low, kTail), quantile(high, 1 - kTail)};
}

// Of the lines of a side that something is known of beyond the opening, the share where the wall goes on; 0 where
// little is known.
double bounded(const WallCells& cells, const CellBox& box, Side side) {
  const bool u = side == Side::left || side == Side::right;
  const auto reach = static_cast<std::int64_t>((side == Side::top ? kTopReach : kBoundReach) / cells.cell) + 1;
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

// What fills it: the foremost depth at which points are spread over the opening nearly as far as at any. A railing is
// nearer and panes lie deeper than their frame, but the one covers a part and of the other there is all to see.
double filling_depth(const RaySamples& samples, const std::vector<std::uint32_t>& points, const Box2& box) {
  constexpr std::size_t kAcross = 10;
  const auto bins = static_cast<std::size_t>(kSheetDepth / kDepthBin) + 1;
  std::vector<std::uint8_t> touched(bins * kAcross * kAcross);
  for (const std::uint32_t i : points) {
    const FacadePoint& at = samples.site().points[i];
    const auto part = [&](double v, double low, double size) {
      return std::min(kAcross - 1, static_cast<std::size_t>(std::max(0.0, (v - low) / size * kAcross)));
    };
    const double depth = -static_cast<double>(at.w);
    if (depth >= kSheetDepth || !box.holds({at.u, at.v})) continue;
    const std::size_t cell = part(at.v, box.v0, box.height()) * kAcross + part(at.u, box.u0, box.width());
    touched[static_cast<std::size_t>(depth / kDepthBin) * kAcross * kAcross + cell] = 1;
  }
  std::vector<std::size_t> cover(bins);  // cells in the quarter of the opening that has the fewest
  for (std::size_t b = 0; b < bins; ++b) {
    std::array<std::size_t, 4> quarters{};
    for (std::size_t c = 0; c < kAcross * kAcross; ++c) {  // a sheet may lie across two bins
      const std::size_t column = c % kAcross, row = c / kAcross;
      if (column == 0 || row == 0 || column + 1 == kAcross || row + 1 == kAcross) continue;  // reveals are there
      const std::size_t quarter = 2 * (2 * row / kAcross) + 2 * column / kAcross;
      const std::uint8_t next = b + 1 < bins ? touched[(b + 1) * kAcross * kAcross + c] : std::uint8_t{0};
      quarters[quarter] += touched[b * kAcross * kAcross + c] | next;
    }
    cover[b] = *std::min_element(quarters.begin(), quarters.end());
  }
  const std::size_t most = *std::max_element(cover.begin(), cover.end());
  for (std::size_t b = 0; b < bins; ++b)
    if (static_cast<double>(cover[b]) >= kCoverShare * static_cast<double>(most))
      return (static_cast<double>(b) + (b + 1 < bins && cover[b + 1] > cover[b] ? 2 : 1)) * kDepthBin;
  return 0;
}

void set_depth(const RaySamples& samples, const Box2& box, double least_depth, FoundRectangle& opening) {
  const NearPoints near = samples.near(box);
  std::vector<std::uint32_t> points(near.begin(), near.end());
  std::erase_if(points, [&](std::uint32_t i) {
    return -static_cast<double>(samples.site().points[i].w) < least_depth || !box.holds(samples.crossing(i, 0));
  });
  opening.points = points.size();
  const double middle = filling_depth(samples, points, box);
  std::vector<double> off;
  for (const std::uint32_t i : points) {
    const double d = -static_cast<double>(samples.site().points[i].w) - middle;
    if (std::abs(d) <= kDepthBin) off.push_back(d);
  }
  if (off.empty()) return;
  const auto median_at = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), median_at, off.end());
  const double centre = *median_at;
  double squares = 0;
  for (const double d : off) squares += (d - centre) * (d - centre);
  opening.depth = -(middle + centre);
  opening.depth_error = samples.site().noise + 2 * std::sqrt(squares) / static_cast<double>(off.size());
}

// Jambs and heads that are not square to each other stay so: their middles are their places.
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

}  // namespace

std::vector<FoundRectangle> find_openings(const RaySamples& samples, const OpeningParams& params) {
  const FacadeSite& site = samples.site();
  const double through = std::max(params.least_depth, 3 * site.epsilon);
  const WallCells cells = filled(cells_of(samples, through), params.shadow);
  std::vector<FoundRectangle> found;
  for (const Region& region : regions_of(cells)) {
    const CellBox box = box_of(region, cells.columns);
    const auto edge = [&](std::int64_t i) { return static_cast<double>(i) * cells.cell; };
    Box2 around{edge(box.c0), edge(box.c1 + 1), edge(box.r0), edge(box.r1 + 1)};
    if (around.width() < params.least_size || around.height() < params.least_size) continue;
    if (bounded(cells, box, Side::left) < kBoundShare || bounded(cells, box, Side::right) < kBoundShare ||
        bounded(cells, box, Side::top) < kBoundShare)
      continue;
    FoundRectangle opening;
    opening.fill =
        static_cast<double>(region.cells.size()) / static_cast<double>((box.c1 - box.c0 + 1) * (box.r1 - box.r0 + 1));
    if (opening.fill < kLeastFill) continue;
    set_depth(samples, around, through, opening);
    const double margin = std::max(0.015, 2 * site.epsilon);
    SideSearch search{around, 0, site.epsilon, true, opening.depth + 0.03, -margin, std::max(0.12, 2.5 * cells.cell),
                      {}};
    // A line that comes from a rough box is looked for again from where it was found.
    for (int round = 0; round < 2; ++round) {
      for (const Side side : kSides) opening.side(side) = locate_edge(samples, search, side);
      search.box = {opening.side(Side::left).inner, opening.side(Side::right).inner, opening.side(Side::bottom).inner,
                    opening.side(Side::top).inner};
    }
    if (opening.at(Side::right) - opening.at(Side::left) < params.least_size ||
        opening.at(Side::top) - opening.at(Side::bottom) < params.least_size)
      continue;
    set_leaning_sides(samples, opening);
    if (opening.lean_of(Side::top) == 0) opening.arc = find_arched_top(samples, opening);
    if (opening.arc) {
      LocatedEdge& crown = opening.side(Side::top);
      crown = {opening.arc->centre.v + opening.arc->radius, opening.arc->error};
      crown.points = opening.arc->points;
      crown.rms = opening.arc->rms;
      crown.inner = crown.at;
    }
    found.push_back(opening);
  }
  return found;
}

}  // namespace ilot
