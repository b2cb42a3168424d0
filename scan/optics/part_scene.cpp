// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/part_scene.h"

#include <algorithm>
#include <limits>

#include "scan/optics/embree_device.h"
#include "scan/optics/ray_box.h"

namespace ilot::scan {
namespace {

// Rays and boxes are floats relative to the anchor. Each rounding is below 2^-24 of the extent, and the error of a
// direction grows with the distance. The constant allows sixteen roundings, which is more than there are.
constexpr double kRounding = 0x1p-20;

struct CastContext {
  RTCIntersectContext embree;  // must come first
  const Ray* ray;
  std::vector<Candidate>* found;
};

}  // namespace

struct PartScene::State {
  std::span<const Part> parts;
  Vec3 anchor;
  double margin = 0;              // of Embree's boxes
  std::vector<Box3<Vec3>> boxes;  // of the parts, grown by the reach
  RTCScene scene = nullptr;

  static void part_bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    set_embree_bounds(self.boxes[args->primID], self.anchor, self.margin, *args->bounds_o);
  }

  // Never shortens the ray, so every box that the ray meets is reported, in any order.
  static void hit_box(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    auto& context = *reinterpret_cast<CastContext*>(args->context);
    const double enters = entry(*context.ray, self.boxes[args->primID]);
    if (enters < std::numeric_limits<double>::infinity()) context.found->push_back({enters, args->primID});
  }
};

Box3<Vec3> bounds_of(std::span<const Part> parts) {
  Box3<Vec3> all = parts.empty() ? Box3<Vec3>{} : bounds_of(parts[0]);
  for (const Part& part : parts) all.add_box(bounds_of(part));
  return all;
}

PartScene::PartScene(std::span<const Part> parts, double reach) : state_(std::make_unique<State>()) {
  const Box3<Vec3> all = bounds_of(parts);
  state_->parts = parts;
  state_->anchor = 0.5 * (all.min + all.max);
  // Sensors are outside the parts, but not farther away than a few times their extent.
  state_->margin = 1e-4 + kRounding * 4 * norm(all.max - all.min);
  // The boxes are grown in double by more than the rounding of double, so that flat boxes are met too.
  const double by = reach + 1e-5;
  for (const Part& part : parts) {
    const Box3<Vec3> box = bounds_of(part);
    state_->boxes.push_back({box.min - Vec3{by, by, by}, box.max + Vec3{by, by, by}});
  }
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

void PartScene::candidates(const Ray& ray, std::vector<Candidate>& out) const {
  out.clear();
  CastContext context{{}, &ray, &out};
  rtcInitIntersectContext(&context.embree);
  RTCRayHit query = embree_query(ray, state_->anchor);
  rtcIntersect1(state_->scene, &context.embree, &query);
  std::sort(out.begin(), out.end(), [](const Candidate& a, const Candidate& b) {
    return a.enters != b.enters ? a.enters < b.enters : a.part < b.part;
  });
}

std::optional<PartHit> PartScene::nearest(const Ray& ray, std::span<const Candidate> candidates, double from) const {
  std::optional<PartHit> best;
  std::uint32_t best_part = 0;
  for (const Candidate& candidate : candidates) {
    if (best && candidate.enters > best->t) break;
    const auto hit = meet(ray, state_->parts[candidate.part], from);
    if (!hit || (best && (hit->t > best->t || (hit->t == best->t && best_part < candidate.part)))) continue;
    best = hit;
    best_part = candidate.part;
  }
  return best;
}

std::optional<PartHit> PartScene::cast(const Ray& ray, double from) const {
  std::vector<Candidate> found;
  candidates(ray, found);
  return nearest(ray, found, from);
}

}  // namespace ilot::scan
