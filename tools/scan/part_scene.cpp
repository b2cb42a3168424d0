// SPDX-License-Identifier: Apache-2.0
#include "tools/scan/part_scene.h"

#include <algorithm>
#include <cassert>

#include "tools/scan/embree_device.h"

namespace ilot::scan {
namespace {

// Rays and boxes are floats about the anchor: each rounding is below 2^-24 of the extent, and a direction's error grows
// with the way. Sixteen of them are more than there are.
constexpr double kRounding = 0x1p-20;

struct CastContext {
  RTCIntersectContext embree;  // must come first
  std::vector<std::uint32_t>* found;
};

}  // namespace

struct PartScene::State {
  std::span<const Part> parts;
  Vec3 anchor;
  double margin = 0;
  RTCScene scene = nullptr;

  static void part_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    set_embree_bounds(bounds_of(self.parts[args->primID]), self.anchor, self.margin, *args->bounds_o);
  }

  // Never shortens the ray: every box it pierces is reported, in whatever order.
  static void hit_box(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    reinterpret_cast<CastContext*>(args->context)->found->push_back(args->primID);
  }
};

Bounds3 bounds_of(std::span<const Part> parts) {
  Bounds3 all = parts.empty() ? Bounds3{} : bounds_of(parts[0]);
  for (const Part& part : parts) {
    const Bounds3 box = bounds_of(part);
    all.min = {std::min(all.min.x, box.min.x), std::min(all.min.y, box.min.y), std::min(all.min.z, box.min.z)};
    all.max = {std::max(all.max.x, box.max.x), std::max(all.max.y, box.max.y), std::max(all.max.z, box.max.z)};
  }
  return all;
}

PartScene::PartScene(std::span<const Part> parts, double reach) : state_(std::make_unique<State>()) {
  const Bounds3 all = bounds_of(parts);
  state_->parts = parts;
  state_->anchor = 0.5 * (all.min + all.max);
  // Sensors stand outside the parts, but not further away than a few times their extent.
  state_->margin = reach + 1e-4 + kRounding * 4 * norm(all.max - all.min);
  state_->scene = rtcNewScene(embree_device());
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  if (!parts.empty()) {
    RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(parts.size()));
    rtcSetGeometryUserData(geometry, state_.get());
    rtcSetGeometryBoundsFunction(geometry, State::part_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, State::hit_box);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(state_->scene, geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(state_->scene);
  check_embree("parts", parts.size());
}

PartScene::~PartScene() {
  rtcReleaseScene(state_->scene);
}

void PartScene::candidates(const Ray& ray, std::vector<std::uint32_t>& out) const {
  out.clear();
  CastContext context{{}, &out};
  rtcInitIntersectContext(&context.embree);
  RTCRayHit query = embree_query(ray, state_->anchor);
  rtcIntersect1(state_->scene, &context.embree, &query);
  std::sort(out.begin(), out.end());
}

std::optional<PartHit> PartScene::nearest(const Ray& ray, std::span<const std::uint32_t> candidates,
                                          double from) const {
  std::optional<PartHit> best;
  for (std::uint32_t index : candidates) {
    const auto hit = meet(ray, state_->parts[index], from);
    if (hit && (!best || hit->t < best->t)) best = hit;
  }
  return best;
}

std::optional<PartHit> PartScene::cast(const Ray& ray, double from) const {
  std::vector<std::uint32_t> found;
  candidates(ray, found);
  return nearest(ray, found, from);
}

}  // namespace ilot::scan
