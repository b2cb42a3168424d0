// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/shape_score.h"

#include <array>

#include "kernels/simd/dispatch.h"

namespace ilot {
namespace {

struct Request {
  simd::ShapeArgs args{};
  std::array<float, 9> shape{};
  std::vector<const float*> balls;
  std::vector<std::uint32_t> leaves;
};

// A shape in float32, its origin moved near the points where that does not change it, and what rounding may add to a
// distance: a few units in the last place of the longest vector.
void prepare(Request& r, const ShapeIndex& index, const Shape& s, const ShapeScoreParams& params) {
  Vec3 origin = s.origin;
  const double along = dot(index.centre - origin, s.axis);
  if (s.kind == ShapeKind::kPlane) origin = index.centre - along * s.axis;
  if (s.kind == ShapeKind::kCylinder) origin = origin + along * s.axis;
  r.shape = {static_cast<float>(origin.x), static_cast<float>(origin.y), static_cast<float>(origin.z),
             static_cast<float>(s.axis.x), static_cast<float>(s.axis.y), static_cast<float>(s.axis.z),
             static_cast<float>(s.radius), static_cast<float>(s.sine),   static_cast<float>(s.cosine)};
  const double longest = norm(index.centre) + index.reach + norm(index.centre - origin) + s.radius;
  for (const auto& level : index.balls) r.balls.push_back(level.data());
  r.leaves.resize(index.in_leaf.size() + 8);
  r.args = {index.x.data(),
            index.y.data(),
            index.z.data(),
            index.nx.data(),
            index.ny.data(),
            index.nz.data(),
            r.balls.data(),
            static_cast<int>(r.balls.size()),
            r.shape.data(),
            static_cast<int>(s.kind),
            static_cast<float>(params.epsilon),
            static_cast<float>(params.min_cos),
            static_cast<float>(longest * 0x1p-19),
            r.leaves.data(),
            0,
            nullptr};
  if (index.size > 0) r.args.leaf_count = simd::table().shape_leaves(r.args);
}

}  // namespace

std::uint32_t bound_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  std::uint32_t bound = 0;
  for (std::uint32_t i = 0; i < r.args.leaf_count; ++i) bound += index.in_leaf[r.leaves[i]];
  return bound;
}

std::uint32_t score_shape(const ShapeIndex& index, const Shape& shape, const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  return simd::table().shape_hits(r.args);
}

std::vector<std::uint32_t> points_on_shape(const ShapeIndex& index, const Shape& shape,
                                           const ShapeScoreParams& params) {
  Request r;
  prepare(r, index, shape, params);
  constexpr float kCosineRounding = 1e-4f;
  r.args.max_distance += r.args.slack;
  r.args.min_cos -= kCosineRounding;
  std::vector<std::uint32_t> found(std::size_t{r.args.leaf_count} * ShapeIndex::kLeaf + 8);
  r.args.found = found.data();
  found.resize(simd::table().shape_hits(r.args));
  std::size_t to = 0;
  for (const std::uint32_t i : found) {
    const ShapeView v = view_of(shape, index.position(i));
    found[to] = i;
    to += std::abs(v.distance) <= params.epsilon && std::abs(dot(v.normal, index.normal(i))) >= params.min_cos;
  }
  found.resize(to);
  return found;
}

}  // namespace ilot
