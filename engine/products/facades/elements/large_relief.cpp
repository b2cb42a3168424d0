// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/large_relief.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/products/facades/elements/depth_image.h"
#include "engine/products/facades/elements/slices.h"
#include "engine/products/facades/walls/side_faces.h"
#include "kernels/core/quantile.h"
#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

// Derived: more than half of the rows or columns, a majority.
constexpr double kBounded = 0.5;  // share of the rows or columns of a region beyond which the wall continues
// Choice: a triangle fills half of its box; an oriel with a gap larger than that is left out.
constexpr double kLeastFill = 0.4;  // share of its box that it covers, at least
// Derived: more than half, so that a part belongs to one wall only.
constexpr double kInWall = 0.5;  // share of its box that is within the box of the wall
// Choice: leaves the noise at the wall out and takes the nearer part of the side faces, which more rays reach; a bay
// that is seen from one side alone may be lost.
constexpr double kConnectionFrom = 0.05, kConnectionTo = 0.4;  // shares of its depth: its side faces have points there
// Choice: one of four sides of a box is seen from the street at least; a car or a tree has none.
constexpr double kConnectedShare = 0.25;  // share of the cells on its rim
// Choice: a front full of glass keeps a fifth of its points; a round oriel has none.
constexpr double kFlatEnd = 0.2;  // share of its points that lie on its end
// Choice: the deepest tenth of a recess is noise and furniture.
constexpr double kReaches = 0.9;  // share of the way to the end of the wall; the rest is noise of its deepest points
// Choice: as many points may come through a window in its back.
constexpr double kBehindAll = 0.02;              // share of its points that may lie deeper
constexpr std::uint64_t kMostSamples = 1 << 17;  // points beside one side; more do not improve the result

bool is_recess(const DepthImage& image, const DepthRegion& region) {
  return bounded_by_wall(image, region, Side::top) >= kBounded ||
         (bounded_by_wall(image, region, Side::left) >= kBounded &&
          bounded_by_wall(image, region, Side::right) >= kBounded);
}

double deepest_of(const DepthImage& image, const DepthRegion& region) {
  std::vector<float> depths;
  for (const std::uint32_t i : region.cells)
    if (const float w = image.front[i]; std::isfinite(w)) depths.push_back(std::abs(w));
  return depths.empty() ? 0 : static_cast<double>(lower_quantile(depths, 1 - kBehindAll));
}

// The cells of an image in a closed frame.
struct CellFrame {
  std::int64_t c0 = INT64_MAX, c1 = -1, r0 = INT64_MAX, r1 = -1;

  std::int64_t columns() const { return c1 - c0 + 1; }
  std::int64_t rows() const { return r1 - r0 + 1; }
  bool contains(std::int64_t c, std::int64_t r) const { return c >= c0 && c <= c1 && r >= r0 && r <= r1; }
  std::size_t at(std::int64_t c, std::int64_t r) const {
    return static_cast<std::size_t>((r - r0) * columns() + c - c0);
  }
};

// All cells of a region, and one cell more around them.
CellFrame frame_of(const DepthImage& image, const DepthRegion& region) {
  CellFrame frame;
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % image.columns, r = i / image.columns;
    frame = {std::min(frame.c0, c - 1), std::max(frame.c1, c + 1), std::min(frame.r0, r - 1),
             std::max(frame.r1, r + 1)};
  }
  return frame;
}

// Whether points of side faces along its rim connect the region with the wall; then it is built on the wall. A face may
// be in a cell of the rim or in the cell of the wall beside it.
bool is_connected_to_wall(const RaySamples& samples, const DepthImage& image, const DepthRegion& region, double depth) {
  // For each cell around the region, the number of the cell of the rim whose face may be in it.
  const CellFrame frame = frame_of(image, region);
  std::vector<std::uint32_t> owner(static_cast<std::size_t>(frame.columns() * frame.rows()), 0);
  std::uint32_t count = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % image.columns, r = i / image.columns;
    bool rim = false;
    for (const auto& [nc, nr] : {std::pair{c - 1, r}, std::pair{c + 1, r}, std::pair{c, r - 1}, std::pair{c, r + 1}}) {
      if (nc < 0 || nr < 0 || nc >= image.columns || nr >= image.rows) continue;
      if (image.what[static_cast<std::size_t>(nr * image.columns + nc)] != kWall) continue;
      count += !rim;
      rim = true;
      owner[frame.at(nc, nr)] = owner[frame.at(c, r)] = count;
    }
  }
  std::vector<std::uint8_t> reached(count + 1, 0);
  const Box2 around{image.u(frame.c0), image.u(frame.c1 + 1), image.u(frame.r0), image.u(frame.r1 + 1)};
  for (const Ray& ray : samples.at_places(around.grown(image.cell))) {
    const double part = static_cast<double>(ray.at.w) / depth;
    if (part < kConnectionFrom || part > kConnectionTo || samples.on_wall(ray)) continue;
    const std::int64_t i = image.at(ray.at), c = i % image.columns, r = i / image.columns;
    if (i >= 0 && frame.contains(c, r)) reached[owner[frame.at(c, r)]] = 1;
  }
  const auto connected = std::count(reached.begin() + 1, reached.end(), 1);
  return count > 0 && static_cast<double>(connected) >= kConnectedShare * count;
}

// The share of its width in which there are cells of the wall below it: eaves are above the whole wall.
double stands_on_wall(const DepthImage& image, const DepthRegion& region) {
  double columns = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t below = i - image.columns;
    columns += below >= 0 && image.what[static_cast<std::size_t>(below)] == kWall;
  }
  return columns / static_cast<double>(region.c1 - region.c0 + 1);
}

// Whether the region continues beyond the image. Then it is a wall of its own, or a part of one.
bool goes_on(const DepthImage& image, const DepthRegion& region) {
  return region.c0 <= 0 || region.r0 <= 0 || region.c1 >= image.columns - 1 || region.r1 >= image.rows - 1;
}

double share_within(const Box2& box, const FacadeSite& site) {
  const double u = std::min(box.u1, site.width) - std::max(box.u0, 0.0);
  const double v = std::min(box.v1, site.height) - std::max(box.v0, 0.0);
  return u <= 0 || v <= 0 ? 0 : u * v / (box.width() * box.height());
}

// The rays whose points are within an outline and between the wall and a depth.
struct InsideRays {
  Rays rays;
  Box2 outline;
  double sign = 1, least = 0, most = 0;  // range of w in the direction of the depth

  bool contains(const Ray& ray) const {
    const double w = sign * static_cast<double>(ray.at.w);
    return outline.contains({ray.at.u, ray.at.v}) && w > least && w < most;
  }
};

double mean_depth(const FacadeSite& site, InsideRays& inside, double at, double within, FoundRectangle& rectangle) {
  double sum = 0, squares = 0, count = 0;
  for (const Ray& ray : inside.rays) {
    const double off = static_cast<double>(ray.at.w) - at;
    if (!inside.contains(ray) || std::abs(off) > within) continue;
    sum += off, squares += off * off, count += 1;
  }
  if (count == 0) return at;
  const double mean = sum / count, rms = std::sqrt(std::max(0.0, squares / count - mean * mean));
  rectangle.depth_error = site.noise / 2 + 3 * rms / std::sqrt(count);
  return at + mean;
}

// Finds the depth of its end: the depth of the sheet that fills it, otherwise that of its farthest points.
Box2 find_end(const RaySamples& samples, const Box2& outline, double deepest, std::int8_t what,
              FoundRectangle& rectangle) {
  const FacadeSite& site = samples.site();
  const double sign = what == kBefore ? 1 : -1, least = std::max(0.02, 3 * site.epsilon);
  const double near = sign * least, far = sign * (deepest + 0.05);
  InsideRays inside{samples.near(outline.grown(samples.oblique() ? 1.5 * deepest : 0.1)), outline.grown(kForemostSheet),
                    sign, least, deepest + 0.05};
  Box2 end{INFINITY, -INFINITY, INFINITY, -INFINITY};  // box of its farthest points
  for (const Ray& ray : inside.rays) {
    if (!inside.contains(ray)) continue;
    ++rectangle.points;
    const FacadePoint& p = ray.at;
    if (sign * static_cast<double>(p.w) < deepest - 2 * site.step - 0.02) continue;
    end = {std::min<double>(end.u0, p.u), std::max<double>(end.u1, p.u), std::min<double>(end.v0, p.v),
           std::max<double>(end.v1, p.v)};
  }
  const SliceRange range{outline.grown(kForemostSheet), std::min(near, far), std::max(near, far)};
  std::optional<FacadeSlice> best;
  for (const FacadeSlice& s : slices_of(samples, range))
    if (!best || s.ratio() > best->ratio()) best = s;
  if (best && static_cast<double>(best->points) >= kFlatEnd * static_cast<double>(rectangle.points)) {
    rectangle.depth = mean_depth(site, inside, best->w, 0.02, rectangle);
    rectangle.depth = mean_depth(site, inside, rectangle.depth, std::max(0.01, 3 * site.noise), rectangle);
    return whole_extent(samples, range, *best).grown(site.step / 2);
  }
  rectangle.depth = sign * deepest;
  rectangle.depth_error = site.noise + site.step;
  return end.u1 < end.u0 ? outline : end;
}

// Finds the side between the points of the wall and those of the element, where no side face gives it more exactly.
LocatedEdge split_side(const RaySamples& samples, const Box2& box, Side side, double least, double reach) {
  const FacadeSite& site = samples.site();
  const bool u = side == Side::left || side == Side::right;
  const double sign = side == Side::right || side == Side::top ? 1 : -1;
  const double t0 = sign * (side == Side::left    ? box.u0
                            : side == Side::right ? box.u1
                            : side == Side::top   ? box.v1
                                                  : box.v0);
  const double s0 = u ? box.v0 : box.u0, s1 = u ? box.v1 : box.u1, corner = 0.1 * (s1 - s0);
  const auto across = [&](const Ray& ray) { return sign * static_cast<double>(u ? ray.at.u : ray.at.v); };
  const auto is_beside = [&](const Ray& ray) {
    const double s = u ? ray.at.v : ray.at.u;
    return std::abs(across(ray) - t0) <= reach && s >= s0 + corner && s <= s1 - corner;
  };
  Rays near = samples.near(box.grown(reach));
  const int level = thinning_level(near, kMostSamples, is_beside);
  std::vector<double> inside, outside;
  for (const Ray& ray : near) {
    if (!is_beside(ray) || !is_kept(ray, level)) continue;
    if (samples.on_wall(ray))
      outside.push_back(across(ray));
    else if (std::abs(static_cast<double>(ray.at.w)) > least)
      inside.push_back(across(ray));
  }
  const EdgeSplit split = split_edge(inside, outside);
  const double end = side == Side::right ? site.width : side == Side::top ? site.height : 0;
  const bool to_end = !split.found && std::abs(sign * t0 - end) <= reach;  // the wall continues no farther
  LocatedEdge edge;
  edge.at = edge.inner = to_end ? end : sign * (split.found ? split.at : t0);
  edge.error = to_end ? site.step : split.found ? split.half_gap + site.noise / 2 : reach;
  edge.points = (inside.size() + outside.size()) << level;
  return edge;
}

// Handles a side face that was not seen: the wall beside it is in its shadow, so the side is where the end has its
// side.
void carry_end(LocatedEdge& edge, Side side, const Box2& end, double step) {
  const double at = side == Side::left ? end.u0 : side == Side::right ? end.u1 : side == Side::bottom ? end.v0 : end.v1;
  const double shadow = std::abs(edge.at - at);
  edge.error = std::max(step, shadow);
  if (shadow > 3 * step) edge.status = DrawnStatus::occluded;
  edge.at = edge.inner = at;
}

// Takes the sides from their faces, and returns where these end at the depth of the element.
Box2 take_faces(const RaySamples& samples, const Box2& end, bool stands_out, double least_depth,
                FoundRectangle& rectangle) {
  const double seen_at = std::copysign(std::min(least_depth, std::abs(rectangle.depth) / 2), rectangle.depth);
  const SideFaces faces = side_faces(samples, rectangle.box(), end, rectangle.depth, seen_at);
  Box2 at_end = faces.end;
  const std::array<double, 4> at{faces.outline.v0, faces.outline.u1, faces.outline.v1, faces.outline.u0};
  const std::array<double*, 4> ends{&at_end.v0, &at_end.u1, &at_end.v1, &at_end.u0};
  for (std::size_t k = 0; k < kSides.size(); ++k) {
    LocatedEdge& edge = rectangle.side(kSides[k]);
    if (faces.points[k] > 0) {
      edge = {at[k], faces.error[k]};
      edge.inner = edge.at, edge.rms = faces.rms[k], edge.points = faces.points[k], edge.by_face = true;
    } else if (stands_out && !(kSides[k] == Side::top && edge.at > samples.site().height)) {  // eaves are inclined
      carry_end(edge, kSides[k], end, samples.site().step);
      *ends[k] = edge.at;
    }
  }
  return at_end;
}

// A cut corner is as deep as its face is at the end of the wall.
void reach_end(FoundRectangle& rectangle, Box2& end) {
  const auto reach = [&](Side leaning, Side open, double& end_of_leaning, double& end_of_open) {
    if (!rectangle.side(leaning).by_face || rectangle.side(open).by_face) return;
    const double way = end_of_leaning - rectangle.at(leaning), whole = rectangle.at(open) - rectangle.at(leaning);
    if (std::abs(way) < kReaches * std::abs(whole) || way * whole <= 0) return;
    const double far = whole / way;
    if (std::abs(far - 1) > 1 - kReaches) return;
    rectangle.depth *= far;
    end_of_leaning = end_of_open = rectangle.at(open);
  };
  reach(Side::left, Side::right, end.u0, end.u1);
  reach(Side::right, Side::left, end.u1, end.u0);
}

// The relief of a region; no result where it is no part of the facade.
std::optional<FoundRectangle> relief_of(const RaySamples& samples, const DepthImage& image, const DepthRegion& region,
                                        const LargeReliefParams& params) {
  const FacadeSite& site = samples.site();
  Box2 box{image.u(region.c0), image.u(region.c1 + 1), image.u(region.r0), image.u(region.r1 + 1)};
  if (box.width() < params.least_size || box.height() < params.least_size) return std::nullopt;
  if (share_within(box, site) < kInWall && (region.what == kBehind || stands_on_wall(image, region) < kInWall))
    return std::nullopt;
  if (region.what == kBefore && goes_on(image, region)) return std::nullopt;
  FoundRectangle rectangle;
  rectangle.fill = static_cast<double>(region.cells.size()) /
                   static_cast<double>((region.c1 - region.c0 + 1) * (region.r1 - region.r0 + 1));
  const double deepest = deepest_of(image, region);
  if (rectangle.fill < kLeastFill) return std::nullopt;
  if (region.what == kBehind ? !is_recess(image, region) : !is_connected_to_wall(samples, image, region, deepest))
    return std::nullopt;
  const Box2 end = find_end(samples, box, deepest, region.what, rectangle);
  if (std::abs(rectangle.depth) < params.least_depth) return std::nullopt;
  for (const Side side : kSides)
    rectangle.side(side) = split_side(samples, box, side, std::max(0.02, 2 * site.epsilon), 2 * image.cell);
  Box2 body_end = take_faces(samples, end, region.what == kBefore, params.least_depth, rectangle);
  reach_end(rectangle, body_end);
  rectangle.end = body_end;
  return rectangle;
}

}  // namespace

std::vector<FoundRectangle> find_large_relief(const RaySamples& samples, const LargeReliefParams& params) {
  const DepthImage image = depth_image(samples, params.least_depth, params.most_depth);
  std::vector<FoundRectangle> found;
  for_each_depth_region(image, [&](const DepthRegion& region) {
    if (const std::optional<FoundRectangle> rectangle = relief_of(samples, image, region, params))
      found.push_back(*rectangle);
  });
  return found;
}

}  // namespace ilot
