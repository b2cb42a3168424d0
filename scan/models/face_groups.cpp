// SPDX-License-Identifier: Apache-2.0
#include "scan/models/face_groups.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/core/union_find.h"

namespace ilot::scan {
namespace {

constexpr double kSameDirection = 0.99985;  // cosine of 1 degree
constexpr double kSamePlane = 0.01;         // metres

bool is_element(FaceClass c) {
  return c == FaceClass::window || c == FaceClass::door || c == FaceClass::installation;
}

std::vector<Box3<Vec3>> boxes_of(std::span<const ScannedFace> faces) {
  std::vector<Box3<Vec3>> boxes;
  for (const ScannedFace& face : faces) {
    boxes.push_back(Box3<Vec3>::none());
    for (const Vec3& p : face.rings[0]) boxes.back().add(p);
    boxes.back() = boxes.back().grown(kTouching / 2);
  }
  return boxes;
}

// All corners of b are near the plane of a.
bool lies_on(const ScannedFace& a, const ScannedFace& b) {
  return std::all_of(b.rings[0].begin(), b.rings[0].end(),
                     [&](const Vec3& p) { return std::abs(dot(a.normal, p - a.rings[0][0])) <= kSamePlane; });
}

// Numbers the sets from `first` on, in the order of their first members; faces that `skip` get 0.
template <class Skip>
std::vector<std::uint32_t> numbered(UnionFind& sets, std::size_t count, std::uint32_t first, Skip skip) {
  std::vector<std::uint32_t> number(count), of_root(count, 0);
  std::vector<char> known(count);
  std::uint32_t next = first;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (skip(i)) continue;
    const std::uint32_t root = sets.find(i);
    if (!known[root]) of_root[root] = next++;
    known[root] = 1;
    number[i] = of_root[root];
  }
  return number;
}

}  // namespace

void for_touching(std::span<const ScannedFace> faces, const std::function<void(std::uint32_t, std::uint32_t)>& pair) {
  const std::vector<Box3<Vec3>> boxes = boxes_of(faces);
  std::vector<std::uint32_t> order(faces.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return boxes[a].min.x != boxes[b].min.x ? boxes[a].min.x < boxes[b].min.x : a < b;
  });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && boxes[order[j]].min.x <= boxes[order[i]].max.x; ++j)
      if (boxes[order[i]].intersects(boxes[order[j]])) pair(std::min(order[i], order[j]), std::max(order[i], order[j]));
}

std::vector<std::uint32_t> element_of_faces(const ScannedModel& model) {
  const std::vector<ScannedFace>& faces = model.faces;
  std::vector<std::uint32_t> parents(faces.size());
  UnionFind sets(parents);
  std::vector<std::uint32_t> first(model.surfaces.size(), static_cast<std::uint32_t>(faces.size()));
  for (std::uint32_t i = 0; i < faces.size(); ++i) {
    if (!is_element(faces[i].face_class) || !model.surfaces[faces[i].surface].semantic) continue;
    std::uint32_t& one = first[faces[i].surface];
    if (one < faces.size())
      sets.unite(one, i);
    else
      one = i;
  }
  for_touching(faces, [&](std::uint32_t a, std::uint32_t b) {
    const ScannedFace &f = faces[a], &g = faces[b];
    const bool loose = !model.surfaces[f.surface].semantic && !model.surfaces[g.surface].semantic;
    if (loose && is_element(f.face_class) && f.face_class == g.face_class && f.building == g.building) sets.unite(a, b);
  });
  return numbered(sets, faces.size(), 1, [&](std::uint32_t i) { return !is_element(faces[i].face_class); });
}

std::vector<std::uint32_t> plane_of_faces(const ScannedModel& model, std::span<const std::uint32_t> elements) {
  const std::vector<ScannedFace>& faces = model.faces;
  std::vector<std::uint32_t> parents(faces.size());
  UnionFind sets(parents);
  for_touching(faces, [&](std::uint32_t a, std::uint32_t b) {
    const ScannedFace &f = faces[a], &g = faces[b];
    if (f.building != g.building || f.face_class != g.face_class || elements[a] != elements[b]) return;
    if (std::abs(dot(f.normal, g.normal)) < kSameDirection) return;
    const bool on = f.area >= g.area ? lies_on(f, g) : lies_on(g, f);
    if (on) sets.unite(a, b);
  });
  return numbered(sets, faces.size(), 0, [](std::uint32_t) { return false; });
}

}  // namespace ilot::scan
