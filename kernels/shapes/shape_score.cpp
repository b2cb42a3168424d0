// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_score.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <memory>

#include "kernels/shapes/shape_score_body.h"

namespace ilot {
namespace {

static_assert(simd::kBallGroup == 8 * ShapeLeaves::kBallFloats && simd::kConeGroup == 8 * ShapeLeaves::kConeFloats);

struct Request {
  simd::ShapeArgs args{};
  std::array<float, 9> shape{};
  std::array<const float*, 16> balls{};
  std::unique_ptr<std::uint32_t[]> leaves;

  std::span<const std::uint32_t> met() const { return {leaves.get(), args.leaf_count}; }
};

// Prepares a shape in float32. Its origin is moved near the points where that does not change the shape. The slack is
// what rounding may add to a distance: a few units in the last place of the longest vector.
void prepare_shape(Request& r, const ShapeIndex& index, const Shape& s, const ShapeScoreParams& params) {
  Vec3 origin = s.origin;
  const double along = dot(index.centre - origin, s.axis);
  if (s.kind == ShapeKind::kPlane) origin = index.centre - along * s.axis;
  if (s.kind == ShapeKind::kCylinder) origin = origin + along * s.axis;
  r.shape = {static_cast<float>(origin.x), static_cast<float>(origin.y), static_cast<float>(origin.z),
             static_cast<float>(s.axis.x), static_cast<float>(s.axis.y), static_cast<float>(s.axis.z),
             static_cast<float>(s.radius), static_cast<float>(s.sine),   static_cast<float>(s.cosine)};
  // Derived: above the rounding of packed normals, 1 / 32767.
  constexpr double kRounding = 1e-3;  // of cosines, and of the lengths of normals
  const double cosine = std::max(0.0, params.min_cos - kRounding);
  const double longest = norm(index.centre) + index.reach + norm(index.centre - origin) + s.radius;
  r.args.shape = r.shape.data();
  r.args.kind = static_cast<int>(s.kind);
  r.args.max_distance = static_cast<float>(params.epsilon);
  r.args.min_cos = static_cast<float>(params.min_cos);
  r.args.slack = static_cast<float>(longest * 0x1p-19);
  r.args.angle_cosine = static_cast<float>(cosine);
  r.args.angle_sine = static_cast<float>(std::sqrt(1 - cosine * cosine));
  r.args.cosine_rounding = static_cast<float>(kRounding);
}

// Finds the leaves near the shape. Where there is one level of balls, groups of them before `first` are left out.
void find_leaves(Request& r, const ShapeLeaves& points, std::size_t first = 0) {
  const std::size_t leaves = points.x.size() / ShapeLeaves::kLeaf;
  r.leaves = std::make_unique_for_overwrite<std::uint32_t[]>(leaves + 8);
  r.args.x = points.x.data();
  r.args.y = points.y.data();
  r.args.z = points.z.data();
  r.args.nx = points.nx.data();
  r.args.ny = points.ny.data();
  r.args.nz = points.nz.data();
  assert(points.balls.size() <= r.balls.size());
  for (std::size_t level = 0; level < points.balls.size(); ++level) r.balls[level] = points.balls[level].data();
  r.args.balls = r.balls.data();
  r.args.levels = static_cast<int>(points.balls.size());
  r.args.cones = points.cones.data();
  r.args.first_group = static_cast<std::uint32_t>(first);
  r.args.groups = static_cast<std::uint32_t>((leaves + 7) / 8);
  r.args.leaves = r.leaves.get();
  r.args.leaf_count = leaves > 0 ? simd::kShapeScore.best().shape_leaves(r.args) : 0;
}

void prepare(Request& r, const ShapeIndex& index, const Shape& s, const ShapeScoreParams& params) {
  prepare_shape(r, index, s, params);
  find_leaves(r, index);
}

// Counts the points on the shape among those that were removed after an epoch.
std::uint32_t removed_hits(Request& r, const RemovedPoints& removed, std::uint64_t epoch) {
  const auto first = static_cast<std::uint32_t>(std::upper_bound(removed.epoch.begin(), removed.epoch.end(), epoch) -
                                                removed.epoch.begin());
  if (first == removed.epoch.size()) return 0;
  find_leaves(r, removed, first / 8);
  while (r.args.leaf_count > 0 && *r.args.leaves < first) {
    ++r.args.leaves;
    --r.args.leaf_count;
  }
  return simd::kShapeScore.best().shape_hits(r.args);
}

bool may_hold(const Box3<Vec3>& box, const ShapeIndex& index, std::uint32_t leaf) {
  const float* ball = index.balls[0].data() + leaf / 8 * simd::kBallGroup + leaf % 8;
  const double x = ball[0], y = ball[8], z = ball[16], radius = ball[24];
  return x + radius >= box.min.x && x - radius <= box.max.x && y + radius >= box.min.y && y - radius <= box.max.y &&
         z + radius >= box.min.z && z - radius <= box.max.z;
}

// Returns those points on the shape in the leaves near it for which `wanted` is true, judged in double.
template <class Wanted>
std::vector<std::uint32_t> found_points(Request& r, const ShapeIndex& index, const Shape& shape,
                                        const ShapeScoreParams& params, const Wanted& wanted) {
  // Derived: above the rounding of float32 in a cosine.
  constexpr float kCosineRounding = 1e-4f;
  r.args.max_distance += r.args.slack;
  r.args.min_cos -= kCosineRounding;
  const std::size_t most = std::size_t{r.args.leaf_count} * ShapeIndex::kLeaf + 8;
  const auto hits = std::make_unique_for_overwrite<std::uint32_t[]>(most);
  r.args.found = hits.get();
  const std::uint32_t count = simd::kShapeScore.best().shape_hits(r.args);
  std::vector<std::uint32_t> found;
  for (const std::uint32_t i : std::span(hits.get(), count)) {
    const Vec3 p = index.position(i);
    if (!wanted(p)) continue;
    const ShapeView v = view_of(shape, p);
    if (std::abs(v.distance) <= params.epsilon && std::abs(dot(v.normal, index.normal(i))) >= params.min_cos)
      found.push_back(i);
  }
  return found;
}

std::uint32_t points_in(const ShapeIndex& index, std::span<const std::uint32_t> leaves) {
  std::uint32_t points = 0;
  for (const std::uint32_t leaf : leaves) points += index.in_leaf[leaf];
  return points;
}

}  // namespace

std::uint32_t bound_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  return points_in(index, r.met());
}

std::uint32_t score_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  return simd::kShapeScore.best().shape_hits(r.args);
}

std::uint32_t recount_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                            ShapeCount before, std::uint32_t least) {
  Request r;
  prepare_shape(r, index, shape, params);
  if (before.epoch >= index.built) {
    // Exact, because a point is judged in the list of the removed as it was in the index: by the same operations on the
    // same values, and a leaf is left out only where none of its points can be a hit.
    const std::uint32_t gone = removed_hits(r, index.removed, before.epoch);
    assert(gone <= before.points);
    return before.points - gone;
  }
  find_leaves(r, index);
  const std::uint32_t bound = points_in(index, r.met());
  return bound < least ? bound : simd::kShapeScore.best().shape_hits(r.args);
}

std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape,
                                           const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  return found_points(r, index, shape, params, [](Vec3) { return true; });
}

std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params,
                                           const Box3<Vec3>& box) {
  Request r;
  prepare(r, index, shape, params);
  std::uint32_t left = 0;
  for (const std::uint32_t leaf : r.met())
    if (may_hold(box, index, leaf)) r.leaves[left++] = leaf;
  r.args.leaf_count = left;
  return found_points(r, index, shape, params, [&](Vec3 p) { return box.contains(p); });
}

}  // namespace ilot
