// SPDX-License-Identifier: Apache-2.0
#include "engine/visibility/line_of_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/visibility/embree_device.h"
#include "kernels/geometry/box3.h"
#include "kernels/geometry/ring.h"
#include "kernels/outlines/banded_region.h"

namespace ilot {
namespace {

constexpr double kLeastArea = 1e-12;  // square CRS units, doubled

// A face in its own plane.
struct FlatFace {
  Vec3 origin, u, v, normal;
  Box3<Vec3> box = Box3<Vec3>::none();
  BandedRegion region;

  FlatPoint flat(Vec3 p) const { return {dot(p - origin, u), dot(p - origin, v)}; }

  // The test is closed: an end of the line that is in the plane counts.
  bool meets(Vec3 from, Vec3 to) const {
    const double before = dot(from - origin, normal), after = dot(to - origin, normal);
    if (before == after || (before < 0 && after < 0) || (before > 0 && after > 0)) return false;
    return region.contains(flat(from + (before / (before - after)) * (to - from)));
  }
};

// False for faces without an area.
bool make_flat(const SectionFace& given, Vec3 anchor, FlatFace& face) {
  if (given.rings.empty() || given.rings[0].size() < 3) return false;
  const Vec3 area = doubled_area(given.rings[0]);
  if (!(norm(area) > kLeastArea)) return false;
  face.normal = (1 / norm(area)) * area;
  face.origin = given.rings[0][0] - anchor;
  const Vec3 n = face.normal, across = std::abs(n.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
  const Vec3 u = cross(across, n);
  face.u = (1 / norm(u)) * u;
  face.v = cross(face.normal, face.u);
  std::vector<FlatEdge> edges;
  std::vector<FlatPoint> flat;
  std::size_t corners = 0;
  for (const std::vector<Vec3>& ring : given.rings) corners += ring.size();
  edges.reserve(corners);
  for (const std::vector<Vec3>& ring : given.rings) {
    flat.clear();
    for (const Vec3& p : ring) flat.push_back(face.flat(p - anchor));
    for (const FlatPoint& p : flat) face.box.add(face.origin + p.x * face.u + p.y * face.v);
    add_ring(flat, edges);
  }
  face.region = BandedRegion(edges);
  return true;
}

// Clips a line to a box; the result may be empty.
bool clip(const Box3<Vec3>& box, Vec3& from, Vec3& to) {
  const Vec3 start = from, way = to - from;
  double first = 0, last = 1;
  for (double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    const double at = start.*axis, step = way.*axis;
    if (step == 0 && (at < box.min.*axis || at > box.max.*axis)) return false;
    if (step == 0) continue;
    const double a = (box.min.*axis - at) / step, b = (box.max.*axis - at) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  if (first > last) return false;
  from = start + first * way;
  to = start + last * way;
  return true;
}

// The data that Embree passes to occluded().
struct SightQuery {
  RTCIntersectContext context;
  Vec3 from, to;
};

}  // namespace

struct LineOfSight::State {
  std::vector<FlatFace> faces;  // relative to the anchor
  Vec3 anchor;
  Box3<Vec3> box = Box3<Vec3>::none();  // of all faces, enlarged
  double slack = 0;
  RTCScene scene = nullptr;

  ~State() {
    if (scene) rtcReleaseScene(scene);
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    const Box3<Vec3>& box = self.faces[args->primID].box;
    *args->bounds_o = embree_bounds(box.min, box.max, self.slack);
  }

  static void occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const State*>(args->geometryUserPtr);
    const auto& query = *reinterpret_cast<const SightQuery*>(args->context);
    if (self.faces[args->primID].meets(query.from, query.to))
      RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
  }
};

LineOfSight::LineOfSight(const std::vector<SectionFace>& faces) : state_(std::make_unique<State>()) {
  build([&](const std::function<void(const SectionFace&)>& visit) {
    for (const SectionFace& face : faces) visit(face);
  });
}

LineOfSight LineOfSight::past(const Faces& faces) {
  LineOfSight sight(std::vector<SectionFace>{});
  sight.build(faces);
  return sight;
}

void LineOfSight::build(const Faces& faces) {
  State& self = *state_;
  auto whole = Box3<Vec3>::none();
  std::size_t count = 0;
  faces([&](const SectionFace& face) {
    ++count;
    for (const auto& ring : face.rings)
      for (const Vec3& p : ring) whole.add(p);
  });
  if (!(whole.min.x <= whole.max.x)) return;
  self.anchor = 0.5 * whole.min + 0.5 * whole.max;
  self.faces.reserve(count);
  faces([&](const SectionFace& given) {
    FlatFace face;
    if (make_flat(given, self.anchor, face)) self.faces.push_back(std::move(face));
  });
  if (self.faces.empty()) return;
  for (const FlatFace& face : self.faces) self.box.add(face.box.min), self.box.add(face.box.max);
  self.slack = kEmbreeSlack * largest(whole.max - whole.min) + std::numeric_limits<float>::min();
  const Vec3 grown{self.slack, self.slack, self.slack};
  self.box = {self.box.min - grown, self.box.max + grown};
  self.scene = embree_scene(self.faces.size(), &self, {State::bounds, nullptr, State::occluded});
}

LineOfSight::~LineOfSight() = default;
LineOfSight::LineOfSight(LineOfSight&&) noexcept = default;
LineOfSight& LineOfSight::operator=(LineOfSight&&) noexcept = default;

bool LineOfSight::clear(Vec3 from, Vec3 to) const {
  const State& self = *state_;
  if (!self.scene) return true;
  SightQuery query{{}, from - self.anchor, to - self.anchor};
  Vec3 start = query.from, end = query.to;
  if (!clip(self.box, start, end)) return true;
  rtcInitIntersectContext(&query.context);
  RTCRay ray{};
  ray.org_x = static_cast<float>(start.x), ray.dir_x = static_cast<float>(end.x - start.x);
  ray.org_y = static_cast<float>(start.y), ray.dir_y = static_cast<float>(end.y - start.y);
  ray.org_z = static_cast<float>(start.z), ray.dir_z = static_cast<float>(end.z - start.z);
  if (ray.dir_x == 0 && ray.dir_y == 0 && ray.dir_z == 0) ray.dir_x = static_cast<float>(self.slack);
  ray.tnear = 0;
  ray.tfar = 1;
  ray.mask = 0xffffffffu;
  rtcOccluded1(self.scene, &query.context, &ray);
  return !(ray.tfar < 0);
}

}  // namespace ilot
