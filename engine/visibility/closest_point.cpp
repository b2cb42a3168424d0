// SPDX-License-Identifier: Apache-2.0
#include "engine/visibility/closest_point.h"

#include <algorithm>
#include <cmath>

#include "engine/visibility/embree_device.h"

namespace ilot {
namespace {

struct Query {
  Vec3 p;  // relative to the anchor
  double slack = 0;
  SurfacePoint best;
};

float above(double v) {
  return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

}  // namespace

struct ClosestPoint::State {
  std::vector<Triangle3> triangles;  // relative to the anchor
  Vec3 anchor;
  double slack = 0;
  RTCScene scene = nullptr;

  ~State() {
    if (scene) rtcReleaseScene(scene);
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    const auto& [a, b, c] = self.triangles[args->primID];
    *args->bounds_o =
        embree_bounds({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})},
                      {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})}, self.slack);
  }

  static bool measure(RTCPointQueryFunctionArguments* args) {
    auto& [self, query] = *static_cast<std::pair<const State*, Query>*>(args->userPtr);
    const Vec3 point = closest_on_triangle(query.p, self->triangles[args->primID]);
    const Vec3 gap = query.p - point;
    const double d2 = dot(gap, gap);
    SurfacePoint& best = query.best;
    if (d2 > best.squared_distance || (d2 == best.squared_distance && args->primID >= best.triangle)) return false;
    best = {args->primID, point, d2};
    const float radius = above(std::sqrt(d2) * (1 + kEmbreeSlack) + query.slack);
    if (radius >= args->query->radius) return false;
    args->query->radius = radius;
    return true;
  }
};

ClosestPoint::ClosestPoint(std::vector<Triangle3> triangles) : state_(std::make_unique<State>()) {
  State& self = *state_;
  self.triangles = std::move(triangles);
  if (self.triangles.empty()) return;
  Vec3 low = self.triangles[0].a, high = low;
  for (const Triangle3& t : self.triangles) {
    for (const Vec3 v : {t.a, t.b, t.c}) {
      low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
      high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
  }
  self.anchor = 0.5 * low + 0.5 * high;
  for (Triangle3& t : self.triangles) t = {t.a - self.anchor, t.b - self.anchor, t.c - self.anchor};
  self.slack = kEmbreeSlack * largest(high - low) + std::numeric_limits<float>::min();
  self.scene = embree_scene(self.triangles.size(), &self, {State::bounds, State::measure, nullptr});
}

ClosestPoint::~ClosestPoint() = default;
ClosestPoint::ClosestPoint(ClosestPoint&&) noexcept = default;
ClosestPoint& ClosestPoint::operator=(ClosestPoint&&) noexcept = default;

SurfacePoint ClosestPoint::nearest(Vec3 p, double reach) const {
  const State& self = *state_;
  if (!self.scene || !(reach >= 0)) return {};
  std::pair<const State*, Query> asked{&self, {}};
  Query& query = asked.second;
  query.p = p - self.anchor;
  query.slack = self.slack + kEmbreeSlack * largest(query.p);
  query.best.squared_distance = reach * reach;
  RTCPointQuery ball{};
  ball.x = static_cast<float>(query.p.x);
  ball.y = static_cast<float>(query.p.y);
  ball.z = static_cast<float>(query.p.z);
  ball.radius = above(reach * (1 + kEmbreeSlack) + query.slack);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(self.scene, &ball, &context, nullptr, &asked);
  if (query.best.triangle == kNoTriangle) return {};
  query.best.point = query.best.point + self.anchor;
  return query.best;
}

}  // namespace ilot
