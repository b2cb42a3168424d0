// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/relief.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "engine/products/facades/rays/value_stream.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr std::size_t kFewestStones = 4;
constexpr std::uint64_t kFewestPoints = 3;  // points of a piece, at least
// Choice: one point in 200 on each side may be an outlier.
constexpr double kTailOfPiece = 0.005;  // share of points beyond the box of a piece on each side
// Choice: twice the noise of a scanner of 5 mm; boards one before the other by less are joined.
constexpr double kSamePlane = 0.01;  // metres between the planes of two pieces of one element
// Choice: the error of both sides where steps are 2 cm; bands that jump by less are joined.
constexpr double kSameLine = 0.05;  // metres between the sides of the two
// Choice: the shadow of a pipe or a lamp; two sills nearer to each other than a metre can become one where nothing was
// seen between them.
constexpr double kAcrossShadow = 1;  // metres between the two along the wall
// Derived: facades.least_relief: what is nearer cannot be distinguished from the wall or the front.
constexpr double kLeastFace = 0.01;  // metres from the wall and from the front between which side faces are searched

// Calls the given function for each value. Every call gives the same values.
using ValueStream = std::function<void(const std::function<void(double)>&)>;

struct Piece {
  std::vector<std::uint32_t> ids;
  double w = 0, rms = 0;
  Box2 box;
  std::vector<RayRun> runs;              // its points, in segment order of the samples
  std::shared_ptr<const RayColumn> own;  // or all rays of this column
  std::uint64_t points = 0;
  double alone = INFINITY;  // metres around it in which there is no other piece of its segment
};

Rays rays_of(const RaySamples& samples, const Piece& piece) {
  return piece.own ? Rays(*piece.own, {{0, piece.own->size()}}) : Rays(samples.by_segment(), piece.runs);
}

void measure(const RaySamples& samples, Piece& piece) {
  double sum = 0, squares = 0;
  const auto count = static_cast<double>(piece.points);
  for (const Ray& ray : rays_of(samples, piece)) sum += static_cast<double>(ray.at.w);
  piece.w = sum / count;
  for (const Ray& ray : rays_of(samples, piece)) {
    const double off = static_cast<double>(ray.at.w) - piece.w;
    squares += off * off;
  }
  piece.rms = std::sqrt(squares / count);
  const PlaceStream places = [&](const std::function<void(double, double)>& take) {
    for (const Ray& ray : rays_of(samples, piece)) {
      const Place2 place = samples.crossing(ray, piece.w);
      take(place.u, place.v);
    }
  };
  piece.box = box_of_places(places, piece.points, kTailOfPiece);
}

bool in_line(const Piece& a, const Piece& b) {
  if (std::abs(a.w - b.w) > kSamePlane) return false;
  const double du = std::max(a.box.u0, b.box.u0) - std::min(a.box.u1, b.box.u1);
  const double dv = std::max(a.box.v0, b.box.v0) - std::min(a.box.v1, b.box.v1);
  const bool level = std::abs(a.box.v0 - b.box.v0) < kSameLine && std::abs(a.box.v1 - b.box.v1) < kSameLine;
  const bool upright = std::abs(a.box.u0 - b.box.u0) < kSameLine && std::abs(a.box.u1 - b.box.u1) < kSameLine;
  return (level && du < kAcrossShadow) || (upright && dv < kAcrossShadow);
}

// One piece for each segment, in the order of their ids.
std::vector<Piece> pieces_of(const RaySamples& samples, std::vector<std::uint32_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::vector<Piece> pieces;
  for (const std::uint32_t id : ids) {
    const RayRun run = samples.run_of(id);
    if (run.count < kFewestPoints) continue;
    Piece& piece = pieces.emplace_back();
    piece.ids = {id};
    piece.runs = {run};
    piece.points = run.count;
    measure(samples, piece);
  }
  return pieces;
}

// A joint that goes through a piece from one side to the other: there are no points in it, and most rays end behind it.
struct Joint {
  double from = 0, to = 0;
};

// The widest strip across the piece, along u or along v, that has few points; no result if there is none.
std::optional<Joint> empty_strip(const ValueStream& places, double low, double high, double step) {
  // Choice: a joint contains points of the rims of both stones; a joint filled by more than a fifth is missed.
  constexpr double kFew = 0.2;  // share of the points in the median strip
  const auto bins = static_cast<std::size_t>((high - low) / step);
  if (bins < 4) return std::nullopt;
  std::vector<std::size_t> counts(bins);
  places([&](double p) {
    const double at = (p - low) / step;
    if (at >= 0 && at < static_cast<double>(bins)) ++counts[static_cast<std::size_t>(at)];
  });
  std::vector<double> sorted(counts.begin(), counts.end());
  const double few = kFew * lower_quantile(sorted, 0.5);
  std::size_t best = 0, best_end = 0;
  for (std::size_t i = 1; i + 1 < bins; ++i) {
    std::size_t end = i;
    while (end + 1 < bins && static_cast<double>(counts[end]) < few) ++end;
    if (end - i > best_end - best) best = i, best_end = end;
    i = std::max(i, end);
  }
  if (best_end - best < 2) return std::nullopt;
  return Joint{low + static_cast<double>(best) * step, low + static_cast<double>(best_end) * step};
}

bool seen_behind(const RaySamples& samples, const Box2& strip) {
  double behind = 0, all = 0;
  for (const Ray& ray : samples.near(strip)) {
    if (!strip.contains(samples.crossing(ray, 0))) continue;
    ++all;
    behind += static_cast<double>(ray.at.w) < -samples.site().epsilon;
  }
  return behind > 0.5 * all;
}

// The points of a piece on one side of the joint.
Piece part_beside(const RaySamples& samples, const Piece& piece, const Joint& joint, bool level, bool before) {
  // Choice: the rim is known to one bin of five across a joint.
  constexpr double kInJoint = 0.8;  // share of the joint: its rim is known to one bin
  RayColumn points(samples.folder());
  for (const Ray& ray : rays_of(samples, piece)) {
    const Place2 p = samples.crossing(ray, piece.w);
    const double at = level ? p.v : p.u;
    if (before ? at < joint.from : at > joint.to) points.add(ray);
  }
  points.finish();
  Piece part;
  part.ids = piece.ids;
  part.alone = std::min(piece.alone, kInJoint * (joint.to - joint.from));
  part.points = points.size();
  part.own = std::make_shared<const RayColumn>(std::move(points));
  return part;
}

// Cuts a segment that continues over joints into the stones between them: first into rows, then each row. `take` gets
// one piece after the other. Therefore at most two pieces of each cut are in memory at once.
void split_at_joints(const RaySamples& samples, Piece piece, double widest,
                     const std::function<void(const Piece&)>& take) {
  const Place2 steps = samples.step_at({(piece.box.u0 + piece.box.u1) / 2, (piece.box.v0 + piece.box.v1) / 2});
  for (const bool level : {true, false}) {
    const ValueStream places = [&](const std::function<void(double)>& visit) {
      for (const Ray& ray : rays_of(samples, piece)) {
        const Place2 p = samples.crossing(ray, piece.w);
        visit(level ? p.v : p.u);
      }
    };
    const auto joint = level ? empty_strip(places, piece.box.v0, piece.box.v1, steps.v)
                             : empty_strip(places, piece.box.u0, piece.box.u1, steps.u);
    if (!joint || joint->to - joint->from > widest) continue;
    Box2 strip = piece.box;
    (level ? strip.v0 : strip.u0) = joint->from;
    (level ? strip.v1 : strip.u1) = joint->to;
    if (!seen_behind(samples, strip)) continue;
    Piece low = part_beside(samples, piece, *joint, level, true);
    Piece high = part_beside(samples, piece, *joint, level, false);
    piece = {};  // its points are in the two parts
    for (Piece* part : {&low, &high}) {
      if (part->points < kFewestPoints) continue;
      measure(samples, *part);
      split_at_joints(samples, std::move(*part), widest, take);
    }
    return;
  }
  take(piece);
}

// Whether rays go through between two pieces that lie in line: then these are two elements.
bool are_separated(const RaySamples& samples, const Piece& a, const Piece& b) {
  // Choice: one ray in five between two pieces shows that they are two elements; a grating between them joins them.
  constexpr double kSeenThrough = 0.2;  // share of the rays that cross there
  const bool across = a.box.u1 < b.box.u0 || b.box.u1 < a.box.u0;
  Box2 gap{std::min(a.box.u1, b.box.u1), std::max(a.box.u0, b.box.u0), std::min(a.box.v1, b.box.v1),
           std::max(a.box.v0, b.box.v0)};
  if (across) gap.v0 = std::max(a.box.v0, b.box.v0), gap.v1 = std::min(a.box.v1, b.box.v1);
  if (!across) gap.u0 = std::max(a.box.u0, b.box.u0), gap.u1 = std::min(a.box.u1, b.box.u1);
  if (gap.width() <= 0 || gap.height() <= 0) return false;
  double through = 0;
  for (const Ray& ray : samples.near(gap.grown(1.5 * a.w)))
    through += samples.met(ray, a.w, samples.site().epsilon) == RayOutcome::through &&
               gap.contains(samples.crossing(ray, a.w));
  const Place2 steps = samples.step_at({(gap.u0 + gap.u1) / 2, (gap.v0 + gap.v1) / 2});
  return through > kSeenThrough * gap.width() * gap.height() / (steps.u * steps.v);
}

void join_pieces(const RaySamples& samples, std::vector<Piece>& pieces) {
  for (bool more = true; more;) {
    more = false;
    for (std::size_t a = 0; a < pieces.size(); ++a)
      for (std::size_t b = a + 1; b < pieces.size();) {
        if (!in_line(pieces[a], pieces[b]) || are_separated(samples, pieces[a], pieces[b])) {
          ++b;
          continue;
        }
        pieces[a].runs.insert(pieces[a].runs.end(), pieces[b].runs.begin(), pieces[b].runs.end());
        pieces[a].points += pieces[b].points;
        pieces[a].ids.insert(pieces[a].ids.end(), pieces[b].ids.begin(), pieces[b].ids.end());
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(b));
        measure(samples, pieces[a]);
        more = true;
      }
  }
}

// The share of the cells of its box, two steps wide, that contain one of its points.
double fill_of(const RaySamples& samples, const Piece& piece) {
  const Place2 steps = samples.step_at({(piece.box.u0 + piece.box.u1) / 2, (piece.box.v0 + piece.box.v1) / 2});
  const double cu = std::max(0.02, 2 * steps.u), cv = std::max(0.02, 2 * steps.v);
  const auto columns = static_cast<std::int64_t>(std::ceil(piece.box.width() / cu));
  const auto rows = static_cast<std::int64_t>(std::ceil(piece.box.height() / cv));
  if (columns <= 0 || rows <= 0) return 0;
  std::vector<bool> held(static_cast<std::size_t>(columns * rows), false);
  std::size_t count = 0;
  for (const Ray& ray : rays_of(samples, piece)) {
    const Place2 p = samples.crossing(ray, piece.w);
    if (!piece.box.contains(p)) continue;
    const auto c = std::min(columns - 1, static_cast<std::int64_t>((p.u - piece.box.u0) / cu));
    const auto r = std::min(rows - 1, static_cast<std::int64_t>((p.v - piece.box.v0) / cv));
    const auto cell = static_cast<std::size_t>(r * columns + c);
    count += !held[cell];
    held[cell] = true;
  }
  return static_cast<double>(count) / static_cast<double>(columns * rows);
}

FoundRectangle rectangle_of(const RaySamples& samples, const Piece& piece, double face_from, double face_to) {
  FoundRectangle rectangle;
  rectangle.depth = piece.w;
  rectangle.depth_error = samples.site().noise / 2 + 2 * piece.rms / std::sqrt(static_cast<double>(piece.points));
  rectangle.points = piece.points;
  rectangle.plane = piece.ids[0];
  const double epsilon = std::max(samples.site().epsilon, 3 * piece.rms);
  const double reach =
      std::min({0.12, std::max(0.04, std::min(piece.box.width(), piece.box.height()) / 2), piece.alone});
  const SideSearch search{piece.box, piece.w, epsilon, false, face_from, face_to, reach, piece.ids};
  for (const Side side : kSides) rectangle.side(side) = locate_edge(samples, search, side);
  return rectangle;
}

bool is_large(const Box2& box, double least) {
  return box.width() >= least && box.height() >= least;
}

}  // namespace

std::vector<FoundRectangle> find_relief(const RaySamples& samples, const ReliefParams& params) {
  std::vector<std::uint32_t> ids;
  for (const ParallelPlane& p : samples.site().parallel) ids.push_back(p.id);
  std::vector<Piece> pieces = pieces_of(samples, std::move(ids));
  const double nearest = std::max(params.least_depth, 2 * samples.site().epsilon);
  std::erase_if(pieces, [&](const Piece& piece) { return piece.w < nearest; });
  join_pieces(samples, pieces);
  std::vector<FoundRectangle> found;
  for (Piece& piece : pieces) {
    std::sort(piece.ids.begin(), piece.ids.end());
    if (!is_large(piece.box, params.least_size)) continue;
    const double fill = fill_of(samples, piece);
    if (fill < params.least_fill) continue;
    FoundRectangle rectangle = rectangle_of(samples, piece, kLeastFace, piece.w - kLeastFace);
    rectangle.fill = fill;
    if (is_large(rectangle.box(), params.least_size)) found.push_back(rectangle);
  }
  return found;
}

std::vector<FoundRectangle> find_stones(const RaySamples& samples, const StoneParams& params) {
  // Choice: a stone fills its rectangle but for chipped corners; polygonal masonry is not found.
  constexpr double kLeastFill = 0.85, kLeastSize = 0.1;
  std::vector<FoundRectangle> found;
  for (Piece& piece : pieces_of(samples, samples.site().wall))
    split_at_joints(samples, std::move(piece), params.joint_width, [&](const Piece& stone) {
      if (!is_large(stone.box, kLeastSize)) return;
      const double fill = fill_of(samples, stone);
      if (fill < kLeastFill) return;
      found.push_back(rectangle_of(samples, stone, -params.joint_to, -params.joint_from));
      found.back().fill = fill;
    });
  if (found.size() < kFewestStones) found.clear();
  return found;
}

void drop_pierced_stones(const std::vector<FoundRectangle>& openings, std::vector<FoundRectangle>& stones) {
  // Choice: the error of the edges of both; a course that ends 5 cm inside of a window is no stone.
  constexpr double kReach = 0.05;  // metres into an opening, in both directions
  std::erase_if(stones, [&](const FoundRectangle& stone) {
    const Box2 inner = stone.box().grown(-kReach);
    return std::any_of(openings.begin(), openings.end(), [&](const FoundRectangle& opening) {
      const Box2 box = opening.box();
      return inner.u0 < box.u1 && box.u0 < inner.u1 && inner.v0 < box.v1 && box.v0 < inner.v1;
    });
  });
  if (stones.size() < kFewestStones) stones.clear();
}

}  // namespace ilot
