// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/ray_scene.h"

#include <algorithm>

#include "scan/optics/embree_device.h"

namespace ilot::scan {
namespace {

// Rays and boxes are floats within 4 km of the anchor. Rounding is below 0.5 mm at each end.
constexpr double kMargin = 0.05;

// The data that one cast passes through Embree's callbacks. The context must come first.
struct CastContext {
  RTCIntersectContext embree;
  const Ray* ray;
  CastResult* result;
};

}  // namespace

struct RayScene::State {
  std::span<const ConvexSolid> solids;
  std::span<const Crown> crowns;
  Vec3 anchor;
  RTCScene scene = nullptr;

  static void solid_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    set_embree_bounds(self.solids[args->primID].bounds, self.anchor, kMargin, *args->bounds_o);
  }

  static void crown_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    const Crown& crown = self.crowns[args->primID];
    set_embree_bounds({crown.centre - crown.radii, crown.centre + crown.radii}, self.anchor, kMargin, *args->bounds_o);
  }

  static void hit_solid(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    auto& context = *reinterpret_cast<CastContext*>(args->context);
    const ConvexSolid& solid = self.solids[args->primID];
    const std::optional<FaceHit> found = enter(*context.ray, solid);
    if (!found) return;
    const SolidHit hit{found->t, solid.first_face + found->face};
    std::optional<SolidHit>& best = context.result->solid;
    if (best && (best->t < hit.t || (best->t == hit.t && best->face < hit.face))) return;
    best = hit;
  }

  static void hit_crown(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    auto& context = *reinterpret_cast<CastContext*>(args->context);
    if (const auto chord = cross(*context.ray, self.crowns[args->primID]))
      context.result->crowns.push_back({args->primID, *chord});
  }

  void attach(std::size_t count, RTCBoundsFunction bounds, RTCIntersectFunctionN intersect) {
    if (count == 0) return;
    RTCGeometry geometry = rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

RayScene::RayScene(std::span<const ConvexSolid> solids, std::span<const Crown> crowns, Vec3 anchor)
    : state_(std::make_unique<State>(State{solids, crowns, anchor})) {
  state_->scene = rtcNewScene(embree_device());
  rtcSetSceneFlags(state_->scene, RTC_SCENE_FLAG_ROBUST);
  state_->attach(solids.size(), State::solid_bounds, State::hit_solid);
  state_->attach(crowns.size(), State::crown_bounds, State::hit_crown);
  rtcCommitScene(state_->scene);
  check_embree("solids", solids.size());
}

RayScene::~RayScene() {
  rtcReleaseScene(state_->scene);
}

void RayScene::cast(const Ray& ray, CastResult& result) const {
  result.solid.reset();
  result.crowns.clear();
  CastContext context{{}, &ray, &result};
  rtcInitIntersectContext(&context.embree);
  RTCRayHit query = embree_query(ray, state_->anchor);
  // The callbacks never shorten the ray. So every box that the ray meets is tested, in any order, and the nearest hit
  // wins.
  rtcIntersect1(state_->scene, &context.embree, &query);
  std::sort(result.crowns.begin(), result.crowns.end(),
            [](const CrownHit& a, const CrownHit& b) { return a.crown < b.crown; });
}

}  // namespace ilot::scan
