// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/openings.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/openings/arched_top.h"
#include "engine/products/facades/openings/beyond_side.h"
#include "engine/products/facades/openings/hidden_side.h"
#include "engine/products/facades/openings/leaning_side.h"
#include "engine/products/facades/openings/panes.h"
#include "engine/products/facades/openings/pointed_top.h"
#include "engine/products/facades/openings/region_parts.h"
#include "engine/products/facades/openings/shallow_openings.h"
#include "engine/products/facades/openings/silent_holes.h"
#include "engine/products/facades/openings/sparse_panes.h"
#include "engine/products/facades/openings/unseen_areas.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: the mouldings around an opening are narrower; windows closer than that to the end of the wall are found by
// what is between.
constexpr double kBoundReach = 0.5;  // metres beyond an opening in which the wall must continue
// Derived: a majority.
constexpr double kBoundShare = 0.5;  // share of its height or width
// Choice: less than a fifth seen is a shadow; windows behind trees are lost.
constexpr double kLeastKnown = 0.2;  // share of it about which something must be known
// Choice: a frame and a curtain leave a third of a window without an echo.
constexpr double kSilentShare = 0.3;  // share of the cells of an opening that gave no echo although rays crossed them
// Choice: hinges hold a leaf up to 2 cm beside the jamb, 1 cm in the mean.
constexpr double kHinge = 0.01;  // metres between the end of an opening and what lies on the wall beside it
// Choice: a triangle fills half of its box.
constexpr double kLeastFill = 0.5;  // share of its box that its cells cover
// Choice: twice the noise of 5 mm; noisier scans spread a pane over several bins.
constexpr double kDepthBin = 0.01;  // metres
// Choice: a window bar covers a tenth of an opening, a pane seen through a tree a quarter.
constexpr double kCoverShare = 0.25;  // share of the widest spread
// Choice: reveals of thick walls are 0.6 m deep; a pane that is deeper than a metre is taken for the room.
constexpr double kSheetDepth = 1;               // metres; the surface that fills an opening is not deeper
constexpr std::uint64_t kMostOnPane = 1 << 17;  // points of the surface that fills it; more do not improve the result

using enum WallCells::What;

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
      // A canopy or a sign hides the wall above, open shutters and surrounds lie on it. What a leaf that stands out
      // hides beside the opening is not known.
      solid = what == kSolid || what == kRelief || (side == Side::top && what == kBlocked);
      unknown = unknown && (what == kUnknown || what == kShallow || what == kBlocked);
    }
    found += solid;
    known += solid || !unknown;
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

// The depth of the plane that ends at a side of an opening: that of the wall, or of a leaf or a surround that lies on
// the wall beside the opening and hides it. Their inner ends are those of the opening.
double depth_beside(const RaySamples& samples, const Box2& box, Side side) {
  // Choice: from the hinge of a leaf, 2 cm beside the jamb, to the width of the narrowest leaf.
  constexpr std::array kFrom{0.01, 0.09}, kTo{0.09, 0.17};  // metres beside the side: two strips
  // Choice: a leaf with gaps between its boards shows the wall in a third of its area.
  constexpr double kMostWall = 0.5;  // rays that met the wall over those that met what lies on it
  constexpr std::size_t kFewest = 5;
  if (side == Side::bottom || side == Side::top) return 0;  // sills and lintels are lower than that
  const double epsilon = samples.site().epsilon;
  std::vector<double> out;
  for (std::size_t k = 0; k < kFrom.size(); ++k) {
    Box2 strip = box;
    if (side == Side::left) strip.u1 = box.u0 - kFrom[k], strip.u0 = box.u0 - kTo[k];
    if (side == Side::right) strip.u0 = box.u1 + kFrom[k], strip.u1 = box.u1 + kTo[k];
    const std::size_t before = out.size();
    double wall = 0;
    for (const Ray& ray : samples.near(strip.grown(kFlatRelief))) {
      const double w = ray.at.w;
      if (samples.on_wall(ray)) wall += strip.contains(samples.crossing(ray, 0));
      if (!samples.on_wall(ray) && w > 2 * epsilon && w <= kFlatRelief && strip.contains({ray.at.u, ray.at.v}))
        out.push_back(w);
    }
    const std::size_t found = out.size() - before;
    if (found < kFewest || wall > kMostWall * static_cast<double>(found)) return 0;
  }
  const double depth = upper_median(out);
  const auto flat = std::count_if(out.begin(), out.end(), [&](double w) { return std::abs(w - depth) <= epsilon; });
  return 2 * static_cast<std::size_t>(flat) > out.size() ? depth : 0;
}

// The median depth of the points of the wall about an opening: walls bow and lean.
double wall_depth_about(const RaySamples& samples, const Box2& box) {
  constexpr double kAbout = 0.3;            // Choice: the width of a narrow pier, metres
  constexpr std::uint64_t kMost = 1 << 14;  // points; more do not improve the result
  const Box2 around = box.grown(kAbout);
  const auto counts = [&](const Ray& ray) { return samples.on_wall(ray) && around.contains({ray.at.u, ray.at.v}); };
  Rays near = samples.near(around);
  const int level = thinning_level(near, kMost, counts);
  std::vector<double> depths;
  for (const Ray& ray : near)
    if (counts(ray) && is_kept(ray, level)) depths.push_back(ray.at.w);
  return depths.empty() ? 0 : upper_median(depths);
}

// How far an edge lies beside the place where oblique rays are followed to the mean plane of the wall, when the wall
// about it is not in that plane; for the nearest station.
double bow_error(const RaySamples& samples, const Box2& box, double wall_depth, Side side) {
  const Vec3* nearest = nullptr;
  const Vec3 middle{(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2, 0};
  for (const FacadeStation& s : samples.site().stations)
    if (nearest == nullptr || norm(s.position - middle) < norm(*nearest - middle)) nearest = &s.position;
  if (nearest == nullptr || !(nearest->z > 0)) return 0;
  const bool upright = side == Side::left || side == Side::right;
  return std::abs(wall_depth) * std::abs(upright ? nearest->x - middle.x : nearest->y - middle.y) / nearest->z;
}

// How far the wall goes on beside a side of a box of cells until rays go through again, at the narrowest quarter of the
// lines across the side; no more than `most` metres.
double wall_beside(const WallCells& cells, const CellBox& box, Side side, double most) {
  const bool u = side == Side::left || side == Side::right;
  const std::int64_t from = u ? box.r0 : box.c0, to = u ? box.r1 : box.c1;
  const auto reach = static_cast<std::int64_t>(most / cells.cell) + 1;
  std::vector<std::int64_t> widths;
  for (std::int64_t i = from; i <= to; ++i) {
    std::int64_t k = 1;
    bool solid = false;
    for (; k <= reach; ++k) {
      const std::int64_t c = side == Side::left ? box.c0 - k : side == Side::right ? box.c1 + k : i;
      const std::int64_t r = side == Side::bottom ? box.r0 - k : side == Side::top ? box.r1 + k : i;
      if (c < 0 || r < 0 || c >= cells.columns || r >= cells.rows)
        k = reach;
      else if (cells.at(c, r) == kThrough && solid)
        break;
      else
        solid |= cells.at(c, r) == kSolid;
    }
    widths.push_back(k - 1);
  }
  return std::min(most, static_cast<double>(lower_quantile(widths, 0.25)) * cells.cell);
}

// Locates the sides of an opening. A line from a rough box is searched a second time from where it was found, and not
// beyond a bar or a narrow pier: there is another opening.
void locate_sides(const RaySamples& samples, const WallCells& cells, const CellBox& box, const Box2& around,
                  FoundRectangle& opening) {
  // Choice: reveals of usual walls; where nothing fills the opening, its depth is not known.
  constexpr double kUnknownDepth = 0.5;  // metres
  const FacadeSite& site = samples.site();
  const double margin = std::max(0.015, 2 * site.epsilon), deep = opening.depth == 0 ? -kUnknownDepth : opening.depth;
  const double bow = samples.oblique() ? wall_depth_about(samples, around) : 0;
  SideSearch search{around, 0, site.epsilon, true, deep + 0.03, -margin, 0, {}};
  const double reach = std::max(0.12, 2.5 * cells.cell);
  search.silent = opening.no_echo;
  for (int round = 0; round < 2; ++round) {
    for (const Side side : kSides) {
      search.depth = depth_beside(samples, search.box, side);
      search.face_to = search.depth - margin;
      search.reach = std::max(cells.cell, wall_beside(cells, box, side, reach));
      LocatedEdge& edge = opening.side(side) = locate_edge(samples, search, side);
      if (edge.by_face) continue;
      edge.error += bow_error(samples, around, bow, side) + (search.depth != 0 ? kHinge : 0);
    }
    search.box = {opening.side(Side::left).inner, opening.side(Side::right).inner, opening.side(Side::bottom).inner,
                  opening.side(Side::top).inner};
  }
  for (const Side side : kSides)
    if (LocatedEdge& edge = opening.side(side); edge.status == DrawnStatus::occluded && edge.at == edge.inner)
      edge.beyond = wall_beyond(cells, search.box, side);
}

// An opening may go on behind a panel that is not in the plane of the wall: the board below a shop window is part of
// the shop, a blind that is down is part of the window. Its side may be at either end of the panel.
void add_panels(const RaySamples& samples, FoundRectangle& opening) {
  const Box2 box = opening.box();
  const double wall = wall_depth_about(samples, box);
  for (const Side side : kSides) {
    LocatedEdge& edge = opening.side(side);
    const double reach = panel_beyond(samples, box, wall, side);
    if (reach > 0) edge.form = std::max(edge.form, reach + edge.error);
  }
}

void set_point(const FoundPoint& point, FoundRectangle& opening) {
  opening.arc.reset();
  opening.pointed = point.top;
  LocatedEdge& crown = opening.side(Side::top);
  crown = {point.crown, point.error};
  crown.points = point.places;
  crown.rms = point.rms;
  crown.inner = crown.at;
  crown.form = point.off;
}

}  // namespace

double depth_through(const FacadeSite& site, const OpeningParams& params) {
  return std::max(params.least_depth, 3 * site.epsilon);
}

double farthest_in_room(const RaySamples& samples, const OpeningParams& params) {
  return samples.oblique() ? params.room_depth : params.room_depth_square;
}

std::optional<FoundRectangle> opening_in(const RaySamples& samples, const WallCells& cells, const CellRegion& region,
                                         const std::vector<bool>& silent, double through, const OpeningParams& params) {
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
  const auto empty =
      std::count_if(region.cells.begin(), region.cells.end(), [&](std::uint32_t i) { return silent[i]; });
  opening.no_echo = static_cast<double>(empty) >= kSilentShare * static_cast<double>(region.cells.size());
  locate_sides(samples, cells, box, around, opening);
  if (opening.at(Side::right) - opening.at(Side::left) < params.least_size ||
      opening.at(Side::top) - opening.at(Side::bottom) < params.least_size)
    return std::nullopt;
  set_leaning_sides(samples, opening);
  add_panels(samples, opening);
  if (opening.lean_of(Side::top) != 0) return opening;
  const FoundTop top = find_top(samples, opening, params.arch_misfit);
  LocatedEdge& crown = opening.side(Side::top);
  opening.arc = top.arc;
  if (opening.arc) {
    crown = {opening.arc->centre.v + opening.arc->radius, opening.arc->error};
    crown.points = opening.arc->points;
    crown.rms = opening.arc->rms;
    crown.inner = crown.at;
    crown.form = opening.arc->off;
  } else {
    crown.form = std::max(crown.form, top.off);
  }
  if (const auto point = find_pointed_top(samples, opening, around.v1, params.arch_misfit)) set_point(*point, opening);
  return opening;
}

namespace {

// The pane that an open hole may be.
std::optional<FoundRectangle> pane_in_hole(const RaySamples& samples, const WallCells& seen, const WallHole& hole,
                                           double through, const OpeningParams& params) {
  WallCells cells = seen;
  std::vector<bool> silent(cells.what.size(), false);
  for (const std::uint32_t i : hole.region.cells) {
    silent[i] = cells.what[i] == kUnknown;
    cells.what[i] = kThrough;
  }
  return opening_in(samples, cells, hole.region, silent, through, params);
}

}  // namespace

std::vector<FoundRectangle> find_openings(const RaySamples& samples, const OpeningParams& params, OpeningSteps* steps,
                                          std::vector<UnseenArea>* unseen) {
  const double through = depth_through(samples.site(), params);
  WallCells seen = cells_of(samples, {through, farthest_in_room(samples, params)});
  if (steps != nullptr) steps->seen = seen;
  std::vector<WallHole> open;
  const std::vector<WallHole> holes = find_holes(samples, seen, params.least_size, &open);
  std::vector<bool> silent(seen.what.size(), false);
  for (const WallHole& hole : holes)
    if (hole.crossed && hole.straight)
      for (const std::uint32_t i : hole.region.cells)
        if (hole.shows(i, seen.columns)) silent[i] = seen.what[i] == kUnknown, seen.what[i] = kThrough;
  const WallCells cells = filled(seen, params.shadow);
  if (steps != nullptr) steps->filled = cells;
  const WidthOfWall width = [&](const CellBox& box, std::int64_t c) { return pier_width(samples, cells.cell, box, c); };
  std::vector<FoundRectangle> found;
  for_each_region(
      cells, [&](std::size_t i) { return cells.what[i] == kThrough; },
      [&](const CellRegion& region) {
        for (const RegionPart& part : parts_of_region(seen, region, params.least_size, width))
          if (const std::optional<FoundRectangle> opening =
                  opening_in(samples, part.at_pier ? seen : cells, part.region, silent, through, params))
            found.push_back(*opening);
      });
  add_shallow_openings(find_shallow_openings(samples, seen, params), found);
  const std::size_t proven = found.size();
  for (const WallHole& hole : open)
    if (const std::optional<FoundRectangle> pane = pane_in_hole(samples, seen, hole, through, params))
      found.push_back(*pane);
  join_panes(cells.cell, proven, found);
  add_sparse_panes(find_sparse_panes(samples, params.least_size), found);
  join_panes(cells.cell, found.size(), found);
  if (unseen != nullptr) *unseen = unseen_areas(holes, found, seen, silent, params.least_size);
  return found;
}

}  // namespace ilot
