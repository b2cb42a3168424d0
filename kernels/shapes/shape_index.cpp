// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_index.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

#include "kernels/core/radix_sort.h"
#include "kernels/geometry/box3.h"
#include "kernels/neighbours/morton.h"

namespace ilot {
namespace {

constexpr float kHole = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kBallGroup = 8 * ShapeLeaves::kBallFloats, kConeGroup = 8 * ShapeLeaves::kConeFloats;
constexpr std::size_t kFewestInCell = 16;  // points of an average cell of the smallest level
// Derived: the comment on the line.
constexpr double kMargin = 1 + 1e-6;  // more than the rounding of a ball to float32

// Puts the ball around a box, number i of a level, into its group.
void put_ball(std::vector<float>& level, std::size_t i, const Box3<Vec3>& b) {
  float* group = level.data() + i / 8 * kBallGroup + i % 8;
  const Vec3 c = 0.5 * (b.min + b.max);
  group[0] = static_cast<float>(c.x);
  group[8] = static_cast<float>(c.y);
  group[16] = static_cast<float>(c.z);
  const Vec3 centre{group[0], group[8], group[16]};
  const Vec3 d{std::max(b.max.x - centre.x, centre.x - b.min.x), std::max(b.max.y - centre.y, centre.y - b.min.y),
               std::max(b.max.z - centre.z, centre.z - b.min.z)};
  group[24] = static_cast<float>(norm(d) * kMargin);
}

void add_balls(ShapeIndex& s, const std::vector<Box3<Vec3>>& boxes) {
  std::vector<float> level((boxes.size() + 7) / 8 * kBallGroup, kHole);
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (!boxes[i].is_empty()) put_ball(level, i, boxes[i]);
  s.balls.push_back(std::move(level));
}

void build_balls(ShapeIndex& s) {
  std::vector<Box3<Vec3>> boxes(s.in_leaf.size(), Box3<Vec3>::none());
  for (std::size_t i = 0; i < s.size; ++i) boxes[i / ShapeIndex::kLeaf].add(s.position(i));
  add_balls(s, boxes);
  while (boxes.size() > 8) {
    std::vector<Box3<Vec3>> parents((boxes.size() + 7) / 8, Box3<Vec3>::none());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      parents[i / 8].add(boxes[i].min);
      parents[i / 8].add(boxes[i].max);
    }
    boxes = std::move(parents);
    add_balls(s, boxes);
  }
}

ShapeLeaves::Cone cone_of(const ShapeLeaves& s, std::size_t begin, std::size_t end) {
  // Derived: above the rounding of packed normals, 1 / 32767.
  constexpr double kUnit2 = 1 + 1e-3, kRounding = 1e-3;
  Vec3 sum;
  double longest2 = 0;
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3 n = s.normal(i);
    sum = sum + (dot(n, s.normal(begin)) < 0 ? -1.0 : 1.0) * n;
    longest2 = std::max(longest2, dot(n, n));
  }
  const double length = norm(sum);
  if (!(length > 0) || longest2 > kUnit2) return {};
  const Vec3 axis = (1 / length) * sum;
  double least = 1;
  for (std::size_t i = begin; i < end; ++i) {
    const Vec3 n = s.normal(i);
    least = std::min(least, std::abs(dot(n, axis)) / norm(n));
  }
  least = std::max(0.0, least - kRounding);
  const auto f = [](double v) { return static_cast<float>(v); };
  return {f(axis.x), f(axis.y), f(axis.z), f(least), f(std::sqrt(1 - least * least))};
}

// Measures the points of a leaf, up to position `end`, along the axis of its normals.
void measure_slab(const ShapeLeaves& s, std::size_t leaf, std::size_t end, ShapeLeaves::Cone& cone) {
  const float* ball = s.balls[0].data() + leaf / 8 * kBallGroup + leaf % 8;
  const Vec3 centre{ball[0], ball[8], ball[16]}, axis{cone.x, cone.y, cone.z};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = leaf * ShapeLeaves::kLeaf; i < end; ++i) {
    const double along = dot(s.position(i) - centre, axis);
    low = std::min(low, along);
    high = std::max(high, along);
  }
  cone.middle = static_cast<float>(0.5 * (low + high));
  const double middle = static_cast<double>(cone.middle);
  cone.half = static_cast<float>(std::max(high - middle, middle - low) * kMargin);
}

// Puts the cone of a leaf, whose points end at position `end` and whose ball is known, into its group.
void put_cone(ShapeLeaves& s, std::size_t leaf, std::size_t end) {
  ShapeLeaves::Cone c = cone_of(s, leaf * ShapeLeaves::kLeaf, end);
  measure_slab(s, leaf, end, c);
  float* to = s.cones.data() + leaf / 8 * kConeGroup + leaf % 8;
  for (const float v : {c.x, c.y, c.z, c.cosine, c.sine, c.middle, c.half}) {
    *to = v;
    to += 8;
  }
}

void build_cones(ShapeIndex& s) {
  s.cones.assign((s.in_leaf.size() + 7) / 8 * kConeGroup, 0.0f);
  for (std::size_t leaf = 0; leaf < s.in_leaf.size(); ++leaf)
    put_cone(s, leaf, std::min(s.size, (leaf + 1) * ShapeLeaves::kLeaf));
}

// Adds a leaf of points that are about to be removed.
void add_removed(ShapeIndex& index, std::span<const std::uint32_t> positions) {
  RemovedPoints& r = index.removed;
  const std::size_t leaf = r.epoch.size(), begin = leaf * ShapeLeaves::kLeaf;
  r.epoch.push_back(index.epoch);
  for (auto* v : {&r.x, &r.y, &r.z, &r.nx, &r.ny, &r.nz}) v->resize(begin + ShapeLeaves::kLeaf, kHole);
  if (leaf % 8 == 0) {
    if (r.balls.empty()) r.balls.emplace_back();
    r.balls[0].resize((leaf / 8 + 1) * kBallGroup, kHole);
    r.cones.resize((leaf / 8 + 1) * kConeGroup, 0.0f);
  }
  auto box = Box3<Vec3>::none();
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const std::size_t to = begin + k, from = positions[k];
    r.x[to] = index.x[from];
    r.y[to] = index.y[from];
    r.z[to] = index.z[from];
    r.nx[to] = index.nx[from];
    r.ny[to] = index.ny[from];
    r.nz[to] = index.nz[from];
    box.add(r.position(to));
  }
  put_ball(r.balls[0], leaf, box);
  put_cone(r, leaf, begin + positions.size());
}

// After this no shape comes near a leaf without points, or a ball without balls.
void empty_ball(ShapeIndex& index, std::size_t ball) {
  for (std::vector<float>& level : index.balls) {
    float* radii = level.data() + ball / 8 * kBallGroup + 24;
    radii[ball % 8] = kHole;
    if (std::any_of(radii, radii + 8, [](float r) { return r == r; })) return;
    ball /= 8;
  }
}

// Morton codes from the box's corner, in units; where an edge of the box is longer than a code can tell (2^21 units, as
// a few points far apart in fine units are), in the least power of two of units that a code can tell.
std::vector<std::uint64_t> codes_in(const Box3<Vec3>& box, const Points& p, std::span<const std::uint32_t> kept) {
  const double longest = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z, 1.0});
  const double steps = std::ldexp(1.0, std::min(0, kMortonBits - 1 - std::ilogb(longest)));
  const auto step_of = [&](double value, double corner) {
    return static_cast<std::uint32_t>((value - corner) * steps);
  };
  std::vector<std::uint64_t> codes;
  codes.reserve(kept.size());
  for (const std::uint32_t k : kept)
    codes.push_back(morton_code({step_of(p.x[k], box.min.x), step_of(p.y[k], box.min.y), step_of(p.z[k], box.min.z)}));
  return codes;
}

// Chooses the levels from the whole box down to cells that contain a few points on average.
void choose_levels(ShapeIndex& s) {
  const std::uint64_t differing = s.size > 0 ? s.code.front() ^ s.code[s.size - 1] : 0;
  const int top = (static_cast<int>(std::bit_width(differing)) + 2) / 3;
  int lowest = top;
  while (lowest > 0) {
    const int shift = 3 * (lowest - 1);
    std::size_t cells = 1;
    for (std::size_t i = 1; i < s.size; ++i) cells += s.code[i] >> shift != s.code[i - 1] >> shift;
    if (cells * kFewestInCell > s.size) break;
    --lowest;
  }
  s.first_level = lowest;
  s.levels = top - lowest + 1;
}

}  // namespace

ShapeIndex::Range ShapeIndex::cell_around(std::size_t i, int level) const {
  const int shift = 3 * level;
  const std::uint64_t cell = code[i] >> shift;
  const auto first = code.begin(), last = code.begin() + static_cast<std::ptrdiff_t>(size);
  const auto begin = std::lower_bound(first, last, cell << shift);
  const auto end = std::lower_bound(begin, last, (cell + 1) << shift);
  return {static_cast<std::size_t>(begin - first), static_cast<std::size_t>(end - first)};
}

ShapeIndex build_shape_index(const OrientedPoints& points, std::span<const std::uint32_t> chosen, std::uint64_t epoch) {
  ShapeIndex s;
  s.epoch = s.built = epoch;
  const Points& p = points.points;
  std::vector<std::uint32_t> kept;
  auto box = Box3<Vec3>::none();
  const bool oriented = points.nx != nullptr;
  for (const std::uint32_t i : chosen) {
    if (oriented && points.nx[i] == 0 && points.ny[i] == 0 && points.nz[i] == 0) continue;
    kept.push_back(i);
    box.add({p.x[i], p.y[i], p.z[i]});
  }
  s.size = s.left = kept.size();
  const std::size_t leaves = (s.size + ShapeIndex::kLeaf - 1) / ShapeIndex::kLeaf;
  for (auto* v : {&s.x, &s.y, &s.z, &s.nx, &s.ny, &s.nz}) v->assign(leaves * ShapeIndex::kLeaf, kHole);
  s.in_leaf.assign(leaves, 0);
  if (kept.empty()) return s;
  s.centre = 0.5 * (box.min + box.max);
  s.reach = 0.5 * norm(box.max - box.min);
  const std::vector<std::uint64_t> codes = codes_in(box, p, kept);
  s.index.resize(s.size);
  s.code.resize(s.size);
  std::size_t to = 0;
  for (const std::uint32_t from : sorted_order(codes)) {
    const std::uint32_t k = kept[from];
    s.index[to] = k;
    s.code[to] = codes[from];
    s.x[to] = p.x[k];
    s.y[to] = p.y[k];
    s.z[to] = p.z[k];
    s.nx[to] = oriented ? points.nx[k] : 0.0f;
    s.ny[to] = oriented ? points.ny[k] : 0.0f;
    s.nz[to] = oriented ? points.nz[k] : 0.0f;
    ++s.in_leaf[to / ShapeIndex::kLeaf];
    ++to;
  }
  build_balls(s);
  build_cones(s);
  choose_levels(s);
  return s;
}

void take_out(ShapeIndex& index, std::span<const std::uint32_t> positions, bool listed) {
  ++index.epoch;
  constexpr std::size_t kLeaf = ShapeLeaves::kLeaf;
  if (!listed || index.removed.epoch.size() + (positions.size() + kLeaf - 1) / kLeaf > index.in_leaf.size()) {
    index.removed = {};
    index.built = index.epoch;
  } else {
    for (std::size_t k = 0; k < positions.size(); k += kLeaf)
      add_removed(index, positions.subspan(k, std::min<std::size_t>(kLeaf, positions.size() - k)));
  }
  for (const std::uint32_t i : positions) {
    assert(!index.is_hole(i));
    index.x[i] = kHole;
    const std::size_t leaf = i / ShapeIndex::kLeaf;
    if (--index.in_leaf[leaf] == 0) empty_ball(index, leaf);
  }
  index.left -= positions.size();
}

}  // namespace ilot
