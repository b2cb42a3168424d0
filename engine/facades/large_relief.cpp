// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/large_relief.h"

#include <algorithm>
#include <cmath>

#include "engine/facades/side_faces.h"
#include "engine/facades/slices.h"
#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

constexpr double kCellSteps = 2, kLeastCell = 0.03, kMostCell = 0.15;  // metres
constexpr double kAround = 0.5;                                        // metres around the wall that the image covers
constexpr double kSheet = 0.03;                      // metres: points so far behind the foremost belong to its surface
constexpr double kBounded = 0.5;                     // share of a region's rows or columns that the wall goes on beyond
constexpr double kLeastFill = 0.4;                   // share of its box
constexpr double kTail = 0.15;                       // of its rows and columns that may end farther out
constexpr double kInWall = 0.5;                      // share of its box that lies within the wall's
constexpr double kHangsFrom = 0.05, kHangsTo = 0.4;  // of its depth: there its side faces have points
constexpr double kHangs = 0.25;                      // share of the cells on its rim
constexpr double kFlatEnd = 0.2;                     // share of its points that lie on its end
constexpr double kReaches = 0.9;     // of the way to the wall's end: the rest is noise of its deepest points
constexpr double kBehindAll = 0.02;  // share of its points that may lie deeper

enum Cell : std::int8_t { kBehind = -1, kWall = 0, kBefore = 1, kNothing = 2 };

// What is foremost, seen square to the wall.
struct DepthImage {
  double cell = 0;
  std::int64_t columns = 0, rows = 0;
  std::vector<float> front;  // w
  std::vector<std::int8_t> what;

  double u(std::int64_t c) const { return static_cast<double>(c) * cell - kAround; }
  std::int64_t at(const FacadePoint& p) const {
    const auto c = static_cast<std::int64_t>(std::floor((static_cast<double>(p.u) + kAround) / cell));
    const auto r = static_cast<std::int64_t>(std::floor((static_cast<double>(p.v) + kAround) / cell));
    return c < 0 || r < 0 || c >= columns || r >= rows ? -1 : r * columns + c;
  }
};

DepthImage image_of(const RaySamples& samples, const LargeReliefParams& params) {
  const FacadeSite& site = samples.site();
  DepthImage image;
  image.cell = std::clamp(kCellSteps * site.step, kLeastCell, kMostCell);
  image.columns = static_cast<std::int64_t>((site.width + 2 * kAround) / image.cell) + 1;
  image.rows = static_cast<std::int64_t>((site.height + 2 * kAround) / image.cell) + 1;
  const auto count = static_cast<std::size_t>(image.columns * image.rows);
  image.front.assign(count, -INFINITY);
  std::vector<std::uint32_t> wall(count), other(count);
  const auto depth = [&](const FacadePoint& p) { return std::abs(static_cast<double>(p.w)) <= params.most_depth; };
  for (const FacadePoint& p : site.points)
    if (const std::int64_t i = image.at(p); i >= 0 && depth(p))
      image.front[static_cast<std::size_t>(i)] = std::max(image.front[static_cast<std::size_t>(i)], p.w);
  for (std::uint32_t k = 0; k < site.points.size(); ++k) {
    const FacadePoint& p = site.points[k];
    const std::int64_t i = image.at(p);
    if (i < 0 || !depth(p)) continue;
    if (samples.on_wall(k))
      ++wall[static_cast<std::size_t>(i)];
    else if (static_cast<double>(p.w) > static_cast<double>(image.front[static_cast<std::size_t>(i)]) - kSheet)
      ++other[static_cast<std::size_t>(i)];
  }
  const double least = std::max(params.least_depth, 3 * site.epsilon);
  image.what.assign(count, kNothing);
  for (std::size_t i = 0; i < count; ++i) {
    const double w = image.front[i];
    if (other[i] > 0 && w > least && other[i] >= wall[i])
      image.what[i] = kBefore;
    else if (wall[i] > 0)
      image.what[i] = kWall;
    else if (other[i] > 0 && w < -least)
      image.what[i] = kBehind;
    else if (other[i] > 0)
      image.what[i] = kWall;
  }
  return image;
}

// Cells that nothing was seen in become what most of their neighbours are, once: gaps between points.
void close_gaps(DepthImage& image) {
  const std::vector<std::int8_t> before = image.what;
  for (std::int64_t r = 1; r + 1 < image.rows; ++r)
    for (std::int64_t c = 1; c + 1 < image.columns; ++c) {
      const std::int64_t i = r * image.columns + c;
      if (before[static_cast<std::size_t>(i)] != kNothing) continue;
      std::array<int, 3> votes{};
      for (std::int64_t dr = -1; dr <= 1; ++dr)
        for (std::int64_t dc = -1; dc <= 1; ++dc)
          if (const int near = before[static_cast<std::size_t>(i + dr * image.columns + dc)]; near != kNothing)
            ++votes[static_cast<std::size_t>(near + 1)];
      const auto most = std::max_element(votes.begin(), votes.end());
      if (*most >= 5) image.what[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(most - votes.begin() - 1);
    }
}

struct Region {
  std::int8_t what = kWall;
  std::vector<std::int64_t> cells;
  std::int64_t c0 = 0, c1 = 0, r0 = 0, r1 = 0;  // box, closed
};

std::int64_t quantile(std::vector<std::int64_t>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Where most of its rows and columns end: ground at its foot and single cells leak out.
void find_box(Region& region, std::int64_t columns) {
  std::int64_t c0 = INT64_MAX, c1 = -1, r0 = INT64_MAX, r1 = -1;
  for (const std::int64_t i : region.cells) {
    c0 = std::min(c0, i % columns), c1 = std::max(c1, i % columns);
    r0 = std::min(r0, i / columns), r1 = std::max(r1, i / columns);
  }
  std::vector<std::int64_t> left(static_cast<std::size_t>(r1 - r0 + 1), INT64_MAX), right(left.size(), -1);
  std::vector<std::int64_t> low(static_cast<std::size_t>(c1 - c0 + 1), INT64_MAX), high(low.size(), -1);
  for (const std::int64_t i : region.cells) {
    const auto r = static_cast<std::size_t>(i / columns - r0), c = static_cast<std::size_t>(i % columns - c0);
    left[r] = std::min(left[r], i % columns), right[r] = std::max(right[r], i % columns);
    low[c] = std::min(low[c], i / columns), high[c] = std::max(high[c], i / columns);
  }
  region.c0 = quantile(left, kTail), region.c1 = quantile(right, 1 - kTail);
  region.r0 = quantile(low, kTail), region.r1 = quantile(high, 1 - kTail);
}

std::vector<Region> regions_of(const DepthImage& image) {
  std::vector<Region> regions;
  std::vector<std::uint8_t> taken(image.what.size());
  for (std::int64_t start = 0; start < static_cast<std::int64_t>(taken.size()); ++start) {
    const std::int8_t what = image.what[static_cast<std::size_t>(start)];
    if (taken[static_cast<std::size_t>(start)] != 0 || (what != kBehind && what != kBefore)) continue;
    Region region;
    region.what = what;
    region.cells = {start};
    taken[static_cast<std::size_t>(start)] = 1;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % image.columns, r = region.cells[i] / image.columns;
      const auto visit = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= image.columns || nr >= image.rows) return;
        const auto n = static_cast<std::size_t>(nr * image.columns + nc);
        if (taken[n] != 0 || image.what[n] != what) return;
        taken[n] = 1;
        region.cells.push_back(nr * image.columns + nc);
      };
      visit(c - 1, r), visit(c + 1, r), visit(c, r - 1), visit(c, r + 1);
    }
    find_box(region, image.columns);
    regions.push_back(std::move(region));
  }
  return regions;
}

// Share of a region's rows (columns) from whose end towards a side the wall is met.
double bounded(const DepthImage& image, const Region& region, Side side) {
  const bool across = side == Side::left || side == Side::right;
  const std::int64_t from = across ? region.r0 : region.c0, to = across ? region.r1 : region.c1;
  std::int64_t found = 0;
  for (std::int64_t i = from; i <= to; ++i) {
    std::int64_t c = side == Side::left ? region.c0 - 1 : side == Side::right ? region.c1 + 1 : i;
    std::int64_t r = side == Side::bottom ? region.r0 - 1 : side == Side::top ? region.r1 + 1 : i;
    bool met = false;
    while (!met && c >= 0 && r >= 0 && c < image.columns && r < image.rows) {
      const std::int8_t what = image.what[static_cast<std::size_t>(r * image.columns + c)];
      met = what == kWall || (what == kBefore && region.what == kBehind);
      c += side == Side::left ? -1 : side == Side::right ? 1 : 0;
      r += side == Side::bottom ? -1 : side == Side::top ? 1 : 0;
    }
    found += met;
  }
  return static_cast<double>(found) / static_cast<double>(to - from + 1);
}

bool is_recess(const DepthImage& image, const Region& region) {
  return bounded(image, region, Side::top) >= kBounded ||
         (bounded(image, region, Side::left) >= kBounded && bounded(image, region, Side::right) >= kBounded);
}

double deepest_of(const DepthImage& image, const Region& region) {
  std::vector<double> depths;
  for (const std::int64_t i : region.cells)
    if (const double w = image.front[static_cast<std::size_t>(i)]; std::isfinite(w)) depths.push_back(std::abs(w));
  if (depths.empty()) return 0;
  const auto at =
      depths.begin() + static_cast<std::ptrdiff_t>((1 - kBehindAll) * static_cast<double>(depths.size() - 1));
  std::nth_element(depths.begin(), at, depths.end());
  return *at;
}

// Whether points of side faces lead from the wall to it, along its rim: it is built on.
bool hangs_on_wall(const RaySamples& samples, const DepthImage& image, const Region& region, double depth) {
  std::vector<std::uint8_t> rim(image.what.size(), 0);
  std::size_t count = 0, reached = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % image.columns, r = i / image.columns;
    const auto is_wall = [&](std::int64_t nc, std::int64_t nr) {
      return nc >= 0 && nr >= 0 && nc < image.columns && nr < image.rows &&
             image.what[static_cast<std::size_t>(nr * image.columns + nc)] == kWall;
    };
    if (!is_wall(c - 1, r) && !is_wall(c + 1, r) && !is_wall(c, r - 1) && !is_wall(c, r + 1)) continue;
    rim[static_cast<std::size_t>(i)] = 1;
    ++count;
  }
  for (const FacadePoint& p : samples.site().points) {
    const double part = static_cast<double>(p.w) / depth;
    if (part < kHangsFrom || part > kHangsTo) continue;
    const std::int64_t i = image.at(p);
    if (i < 0 || rim[static_cast<std::size_t>(i)] != 1) continue;
    rim[static_cast<std::size_t>(i)] = 2;
    ++reached;
  }
  return count > 0 && static_cast<double>(reached) >= kHangs * static_cast<double>(count);
}

// Of its width, where it stands on cells of the wall: eaves lie above all of it.
double stands_on_wall(const DepthImage& image, const Region& region) {
  double columns = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t below = i - image.columns;
    columns += below >= 0 && image.what[static_cast<std::size_t>(below)] == kWall;
  }
  return columns / static_cast<double>(region.c1 - region.c0 + 1);
}

double share_within(const Box2& box, const FacadeSite& site) {
  const double u = std::min(box.u1, site.width) - std::max(box.u0, 0.0);
  const double v = std::min(box.v1, site.height) - std::max(box.v0, 0.0);
  return u <= 0 || v <= 0 ? 0 : u * v / (box.width() * box.height());
}

double mean_depth(const FacadeSite& site, const std::vector<std::uint32_t>& points, double at, double within,
                  FoundRectangle& thing) {
  double sum = 0, squares = 0, count = 0;
  for (const std::uint32_t i : points) {
    const double off = static_cast<double>(site.points[i].w) - at;
    if (std::abs(off) > within) continue;
    sum += off, squares += off * off, count += 1;
  }
  if (count == 0) return at;
  const double mean = sum / count, rms = std::sqrt(std::max(0.0, squares / count - mean * mean));
  thing.depth_error = site.noise / 2 + 3 * rms / std::sqrt(count);
  return at + mean;
}

// The depth of its end: that of the sheet that fills it, else of its farthest points.
Box2 find_end(const RaySamples& samples, const Box2& outline, double deepest, std::int8_t what, FoundRectangle& thing) {
  const FacadeSite& site = samples.site();
  const double sign = what == kBefore ? 1 : -1, least = std::max(0.02, 3 * site.epsilon);
  const double near = sign * least, far = sign * (deepest + 0.05);
  std::vector<std::uint32_t> inside;
  for (const std::uint32_t i : samples.near(outline.grown(samples.oblique() ? 1.5 * deepest : 0.1))) {
    const FacadePoint& p = site.points[i];
    const double w = sign * static_cast<double>(p.w);
    if (outline.grown(kSheet).holds({p.u, p.v}) && w > least && w < deepest + 0.05) inside.push_back(i);
  }
  thing.points = inside.size();
  const std::vector<FacadeSlice> slices =
      slices_of(samples, outline.grown(kSheet), std::min(near, far), std::max(near, far));
  std::optional<FacadeSlice> best;
  for (const FacadeSlice& s : slices)
    if (!best || s.ratio() > best->ratio()) best = s;
  const bool flat = best && static_cast<double>(best->points) >= kFlatEnd * static_cast<double>(inside.size());
  if (flat) {
    thing.depth = mean_depth(site, inside, best->w, 0.02, thing);
    thing.depth = mean_depth(site, inside, thing.depth, std::max(0.01, 3 * site.noise), thing);
    return best->extent.grown(site.step / 2);
  }
  thing.depth = sign * deepest;
  thing.depth_error = site.noise + site.step;
  Box2 end{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const std::uint32_t i : inside) {
    const FacadePoint& p = site.points[i];
    if (sign * static_cast<double>(p.w) < deepest - 2 * site.step - 0.02) continue;
    end = {std::min<double>(end.u0, p.u), std::max<double>(end.u1, p.u), std::min<double>(end.v0, p.v),
           std::max<double>(end.v1, p.v)};
  }
  return end.u1 < end.u0 ? outline : end;
}

// Between the wall's points and its own, where no side face tells better.
LocatedEdge split_side(const RaySamples& samples, const Box2& box, Side side, double least, double reach) {
  const FacadeSite& site = samples.site();
  const bool u = side == Side::left || side == Side::right;
  const double sign = side == Side::right || side == Side::top ? 1 : -1;
  const double t0 = sign * (side == Side::left    ? box.u0
                            : side == Side::right ? box.u1
                            : side == Side::top   ? box.v1
                                                  : box.v0);
  const double s0 = u ? box.v0 : box.u0, s1 = u ? box.v1 : box.u1, corner = 0.1 * (s1 - s0);
  std::vector<double> inside, outside;
  for (const std::uint32_t i : samples.near(box.grown(reach))) {
    const FacadePoint& p = site.points[i];
    const double t = sign * static_cast<double>(u ? p.u : p.v), s = u ? p.v : p.u;
    if (std::abs(t - t0) > reach || s < s0 + corner || s > s1 - corner) continue;
    if (samples.on_wall(i))
      outside.push_back(t);
    else if (std::abs(static_cast<double>(p.w)) > least)
      inside.push_back(t);
  }
  const EdgeSplit split = split_edge(inside, outside);
  const double end = side == Side::right ? site.width : side == Side::top ? site.height : 0;
  const bool to_end = !split.found && std::abs(sign * t0 - end) <= reach;  // the wall goes no farther
  LocatedEdge edge;
  edge.at = edge.inner = to_end ? end : sign * (split.found ? split.at : t0);
  edge.error = to_end ? site.step : split.found ? split.half_gap + site.noise / 2 : reach;
  edge.points = inside.size() + outside.size();
  return edge;
}

// Of a side face that nobody saw: the wall beside it lies in its shadow, so it ends where its end does.
void carry_end(LocatedEdge& edge, Side side, const Box2& end, double step) {
  const double at = side == Side::left ? end.u0 : side == Side::right ? end.u1 : side == Side::bottom ? end.v0 : end.v1;
  const double shadow = std::abs(edge.at - at);
  edge.error = std::max(step, shadow);
  if (shadow > 3 * step) edge.status = DrawnStatus::occluded;
  edge.at = edge.inner = at;
}

// The sides from their faces, and where those end at the thing's depth.
Box2 take_faces(const RaySamples& samples, const Box2& end, bool stands_out, FoundRectangle& thing) {
  const SideFaces faces = side_faces(samples, thing.box(), end, thing.depth);
  Box2 at_end = faces.end;
  const std::array<double, 4> at{faces.outline.v0, faces.outline.u1, faces.outline.v1, faces.outline.u0};
  const std::array<double*, 4> ends{&at_end.v0, &at_end.u1, &at_end.v1, &at_end.u0};
  for (std::size_t k = 0; k < kSides.size(); ++k) {
    LocatedEdge& edge = thing.side(kSides[k]);
    if (faces.points[k] > 0) {
      edge = {at[k], faces.error[k]};
      edge.inner = edge.at, edge.rms = faces.rms[k], edge.points = faces.points[k], edge.by_face = true;
    } else if (stands_out && !(kSides[k] == Side::top && edge.at > samples.site().height)) {  // eaves slope
      carry_end(edge, kSides[k], end, samples.site().step);
      *ends[k] = edge.at;
    }
  }
  return at_end;
}

// A cut corner goes as deep as its face has come at the wall's end.
void reach_end(FoundRectangle& thing, Box2& end) {
  const auto reach = [&](Side leaning, Side open, double& end_of_leaning, double& end_of_open) {
    if (!thing.side(leaning).by_face || thing.side(open).by_face) return;
    const double way = end_of_leaning - thing.at(leaning), whole = thing.at(open) - thing.at(leaning);
    if (std::abs(way) < kReaches * std::abs(whole) || way * whole <= 0) return;
    const double far = whole / way;
    if (std::abs(far - 1) > 1 - kReaches) return;
    thing.depth *= far;
    end_of_leaning = end_of_open = thing.at(open);
  };
  reach(Side::left, Side::right, end.u0, end.u1);
  reach(Side::right, Side::left, end.u1, end.u0);
}

}  // namespace

std::vector<FoundRectangle> find_large_relief(const RaySamples& samples, const LargeReliefParams& params) {
  const FacadeSite& site = samples.site();
  DepthImage image = image_of(samples, params);
  close_gaps(image);
  std::vector<FoundRectangle> found;
  for (const Region& region : regions_of(image)) {
    Box2 box{image.u(region.c0), image.u(region.c1 + 1), image.u(region.r0), image.u(region.r1 + 1)};
    if (box.width() < params.least_size || box.height() < params.least_size) continue;
    if (share_within(box, site) < kInWall && (region.what == kBehind || stands_on_wall(image, region) < kInWall))
      continue;
    FoundRectangle thing;
    thing.fill = static_cast<double>(region.cells.size()) /
                 static_cast<double>((region.c1 - region.c0 + 1) * (region.r1 - region.r0 + 1));
    const double deepest = deepest_of(image, region);
    if (thing.fill < kLeastFill) continue;
    if (region.what == kBehind ? !is_recess(image, region) : !hangs_on_wall(samples, image, region, deepest)) continue;
    const Box2 end = find_end(samples, box, deepest, region.what, thing);
    if (std::abs(thing.depth) < params.least_depth) continue;
    for (const Side side : kSides)
      thing.side(side) = split_side(samples, box, side, std::max(0.02, 2 * site.epsilon), 2 * image.cell);
    Box2 body_end = take_faces(samples, end, region.what == kBefore, thing);
    reach_end(thing, body_end);
    thing.end = body_end;
    found.push_back(thing);
  }
  return found;
}

}  // namespace ilot
