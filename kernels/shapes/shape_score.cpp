// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_score.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "kernels/shapes/shape_score_body.h"

namespace ilot {
namespace {

struct Request {
  simd::ShapeArgs args{};
  std::array<float, 9> shape{};
  std::vector<const float*> balls;
  std::unique_ptr<std::uint32_t[]> leaves;

  std::span<const std::uint32_t> met() const { return {leaves.get(), args.leaf_count}; }
};

// Prepares a shape in float32. Its origin is moved near the points where that does not change the shape. The slack is
// what rounding may add to a distance: a few units in the last place of the longest vector.
void prepare(Request& r, const ShapeIndex& index, const Shape& s, const ShapeScoreParams& params) {
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
  for (const auto& level : index.balls) r.balls.push_back(level.data());
  r.leaves = std::make_unique_for_overwrite<std::uint32_t[]>(index.in_leaf.size() + 8);
  r.args = {index.x.data(),
            index.y.data(),
            index.z.data(),
            index.nx.data(),
            index.ny.data(),
            index.nz.data(),
            r.balls.data(),
            static_cast<int>(r.balls.size()),
            index.cones.data(),
            r.shape.data(),
            static_cast<int>(s.kind),
            static_cast<float>(params.epsilon),
            static_cast<float>(params.min_cos),
            static_cast<float>(longest * 0x1p-19),
            static_cast<float>(cosine),
            static_cast<float>(std::sqrt(1 - cosine * cosine)),
            static_cast<float>(kRounding),
            r.leaves.get(),
            0,
            nullptr};
  if (index.size > 0) r.args.leaf_count = simd::kShapeScore.best().shape_leaves(r.args);
}

bool may_hold(const Box3<Vec3>& box, const ShapeIndex& index, std::uint32_t leaf) {
  const float* ball = index.balls[0].data() + leaf / 8 * 32 + leaf % 8;
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
  prepare(r, index, shape, params);
  const auto as_before = [&](std::uint32_t leaf) { return index.changed[leaf] <= before.epoch; };
  if (before.epoch > 0 && std::all_of(r.met().begin(), r.met().end(), as_before)) return before.points;
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
