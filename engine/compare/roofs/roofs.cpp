// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/roofs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "engine/visibility/closest_point.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNoPartner = 0xffffffffu;

// Faces sorted by their left end, so that the faces whose boxes meet another box are found without examining all faces.
class FacesByPlace {
 public:
  explicit FacesByPlace(std::span<const RoofFace> faces) : faces_(faces), order_(faces.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(faces[a].box.min.x, a) < std::tie(faces[b].box.min.x, b);
    });
    for (const RoofFace& face : faces) widest_ = std::max(widest_, face.box.width());
  }

  template <class Visit>
  void meeting(const FlatBox& box, Visit visit) const {
    auto at = std::lower_bound(order_.begin(), order_.end(), box.min.x - widest_,
                               [&](std::uint32_t f, double x) { return faces_[f].box.min.x < x; });
    for (; at != order_.end() && faces_[*at].box.min.x <= box.max.x; ++at) {
      const RoofFace& face = faces_[*at];
      if (face.box.max.x >= box.min.x && face.box.min.y <= box.max.y && face.box.max.y >= box.min.y) visit(*at);
    }
  }

 private:
  std::span<const RoofFace> faces_;
  std::vector<std::uint32_t> order_;
  double widest_ = 0;
};

struct FacePair {
  double iou = 0;
  std::uint32_t truth = 0, found = 0;
};

bool lean_alike(const RoofFace& a, const RoofFace& b, double most_angle_deg) {
  return dot(a.normal, b.normal) >= cos_degrees(most_angle_deg) * norm(a.normal) * norm(b.normal);
}

// The index of the found partner of each true face, or kNoPartner.
std::vector<std::uint32_t> match_faces(std::span<const RoofFace> truth, std::span<const RoofFace> found,
                                       const FacesByPlace& places, const RoofParams& params) {
  std::vector<std::vector<FacePair>> per_face(truth.size());
  parallel_for(truth.size(), [&](std::size_t t) {
    const FlatArea plan(truth[t].plan);
    places.meeting(truth[t].box, [&](std::uint32_t f) {
      if (!lean_alike(truth[t], found[f], params.most_angle_deg)) return;
      const double iou = intersection_over_union(plan, FlatArea(found[f].plan));
      if (iou >= params.least_iou) per_face[t].push_back({iou, static_cast<std::uint32_t>(t), f});
    });
  });
  std::vector<FacePair> pairs;
  for (const auto& part : per_face) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) {
    return std::tie(b.iou, a.truth, a.found) < std::tie(a.iou, b.truth, b.found);
  });
  std::vector<std::uint32_t> partner(truth.size(), kNoPartner);
  std::vector<char> taken(found.size());
  for (const FacePair& pair : pairs) {
    if (partner[pair.truth] != kNoPartner || taken[pair.found]) continue;
    partner[pair.truth] = pair.found;
    taken[pair.found] = 1;
  }
  return partner;
}

// The length of the first face's plan edges that run within reach of the second face's edges.
double shared_length(const RoofFace& a, const RoofFace& b, double reach) {
  const std::vector<FlatEdge> others = plan_edges(b);
  double shared = 0;
  for (const auto& [p, q] : plan_edges(a)) {
    const double length = std::hypot(q.x - p.x, q.y - p.y);
    const double samples = std::clamp(std::ceil(length / reach), 1.0, 1e5);
    for (double k = 0; k < samples; ++k) {
      const double t = (k + 0.5) / samples;
      const Vec3 at{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), 0};
      const bool near = std::any_of(others.begin(), others.end(), [&](const FlatEdge& e) {
        return norm(at - closest_on_segment(at, {e.a.x, e.a.y, 0}, {e.b.x, e.b.y, 0})) <= reach;
      });
      if (near) shared += length / samples;
    }
  }
  return shared;
}

std::vector<std::set<std::uint32_t>> neighbours_of(std::span<const RoofFace> faces, const FacesByPlace& places,
                                                   const RoofParams& params) {
  const double reach = params.touching_m / params.metres_per_unit, least = params.shared_m / params.metres_per_unit;
  std::vector<std::set<std::uint32_t>> neighbours(faces.size());
  parallel_for(faces.size(), [&](std::size_t i) {
    const RoofFace& face = faces[i];
    places.meeting(face.box.grown(reach), [&](std::uint32_t j) {
      if (j == i || faces[j].building != face.building) return;
      const bool first = i < j;  // both directions are measured along the same face
      if (shared_length(faces[first ? i : j], faces[first ? j : i], reach) >= least) neighbours[i].insert(j);
    });
  });
  return neighbours;
}

void count_classes(std::span<const RoofFace> truth, std::span<const RoofFace> found,
                   const std::vector<std::uint32_t>& partner, const FacesByPlace& found_places,
                   const RoofParams& params, RoofResult& result) {
  const auto true_neighbours = neighbours_of(truth, FacesByPlace(truth), params);
  const auto found_neighbours = neighbours_of(found, found_places, params);
  const std::set<std::uint32_t> matched(partner.begin(), partner.end());
  for (std::size_t t = 0; t < truth.size(); ++t) {
    const double area = truth[t].area() * params.metres_per_unit * params.metres_per_unit;
    RoofSizeClass& size = *std::find_if(result.classes.begin(), result.classes.end(),
                                        [&](const RoofSizeClass& c) { return area >= c.from_m2; });
    ++size.truth;
    if (partner[t] == kNoPartner) continue;
    ++size.matched;
    ++result.matched_faces;
    std::set<std::uint32_t> wanted, got;
    for (const std::uint32_t n : true_neighbours[t])
      if (partner[n] != kNoPartner) wanted.insert(partner[n]);
    for (const std::uint32_t n : found_neighbours[partner[t]])
      if (matched.contains(n)) got.insert(n);
    size.right_neighbours += wanted == got;
  }
}

// Visits the lattice points under a face, row by row.
template <class Visit>
void each_sample(const RoofFace& face, double step, Visit visit) {
  for (double row = std::ceil(face.box.min.y / step); row * step <= face.box.max.y; ++row)
    for (double column = std::ceil(face.box.min.x / step); column * step <= face.box.max.x; ++column)
      if (const FlatPoint p{column * step, row * step}; covers(face, p)) visit(p);
}

struct HeightSums {
  double squares = 0;
  std::uint64_t samples = 0, covered = 0;
};

void compare_heights(std::span<const RoofFace> truth, std::span<const RoofFace> found, const FacesByPlace& places,
                     double step, const RoofParams& params, RoofResult& result) {
  std::vector<HeightSums> sums(truth.size());
  parallel_for(truth.size(), [&](std::size_t t) {
    std::vector<std::uint32_t> near;
    places.meeting(truth[t].box, [&](std::uint32_t f) { near.push_back(f); });
    each_sample(truth[t], step, [&](FlatPoint p) {
      double highest = -kInfinity;
      for (const std::uint32_t f : near)
        if (covers(found[f], p)) highest = std::max(highest, found[f].height(p));
      ++sums[t].samples;
      if (highest == -kInfinity) return;
      ++sums[t].covered;
      const double gap = (highest - truth[t].height(p)) * params.metres_per_unit;
      sums[t].squares += gap * gap;
    });
  });
  HeightSums all;
  for (const HeightSums& s : sums) all = {all.squares + s.squares, all.samples + s.samples, all.covered + s.covered};
  result.rms_m = all.covered ? std::sqrt(all.squares / static_cast<double>(all.covered)) : kInfinity;
  result.covered = all.samples ? static_cast<double>(all.covered) / static_cast<double>(all.samples) : 0;
}

// The largest distance from samples and corners of `from` to `to`.
double farthest(std::span<const RoofFace> from, const ClosestPoint& to, double step) {
  std::vector<double> most(from.size());
  parallel_for(from.size(), [&](std::size_t i) {
    const auto look = [&](Vec3 p) { most[i] = std::max(most[i], to.nearest(p).squared_distance); };
    each_sample(from[i], step, [&](FlatPoint p) { look({p.x, p.y, from[i].height(p)}); });
    for (const Triangle3& t : from[i].triangles)
      for (const Vec3 corner : {t.a, t.b, t.c}) look(corner);
  });
  return std::sqrt(*std::max_element(most.begin(), most.end()));
}

ClosestPoint surface_of(std::span<const RoofFace> faces) {
  std::vector<Triangle3> triangles;
  for (const RoofFace& face : faces) triangles.insert(triangles.end(), face.triangles.begin(), face.triangles.end());
  return ClosestPoint(std::move(triangles));
}

// The outlines of buildings in plan.
std::vector<FlatEdge> outlines(std::span<const RoofFace> faces) {
  std::map<std::uint32_t, std::vector<FlatPolygon>> buildings;
  for (const RoofFace& face : faces) {
    std::vector<FlatPolygon>& plans = buildings[face.building];
    plans.insert(plans.end(), face.plan.begin(), face.plan.end());
  }
  std::vector<FlatEdge> edges;
  for (const auto& [building, plans] : buildings) {
    const std::vector<FlatEdge> own = FlatArea(plans, 1e-4).edges();
    edges.insert(edges.end(), own.begin(), own.end());
  }
  return edges;
}

void append_distances(const std::vector<FlatEdge>& from, const std::vector<FlatEdge>& to, double step,
                      std::vector<double>& distances) {
  std::vector<Triangle3> lines;  // edges are triangles without area
  for (const auto& [a, b] : to) lines.push_back({{a.x, a.y, 0}, {b.x, b.y, 0}, {b.x, b.y, 0}});
  const ClosestPoint line(std::move(lines));
  for (const auto& [a, b] : from) {
    const double samples = std::clamp(std::ceil(std::hypot(b.x - a.x, b.y - a.y) / step), 1.0, 1e6);
    for (double k = 0; k < samples; ++k) {
      const double t = (k + 0.5) / samples;
      distances.push_back(line.nearest({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), 0}).squared_distance);
    }
  }
}

double outline_p95(std::span<const RoofFace> truth, std::span<const RoofFace> found, double step) {
  const std::vector<FlatEdge> wanted = outlines(truth), got = outlines(found);
  std::vector<double> distances;
  append_distances(wanted, got, step, distances);
  append_distances(got, wanted, step, distances);
  if (distances.empty()) return kInfinity;
  std::sort(distances.begin(), distances.end());
  return std::sqrt(distances[(distances.size() * 95 + 99) / 100 - 1]);
}

std::uint64_t count_buildings(std::span<const RoofFace> faces) {
  std::set<std::uint32_t> buildings;
  for (const RoofFace& face : faces) buildings.insert(face.building);
  return buildings.size();
}

}  // namespace

RoofResult evaluate_roofs(std::span<const RoofFace> truth, std::span<const RoofFace> found, const RoofParams& params) {
  RoofResult result;
  result.true_buildings = count_buildings(truth);
  result.found_buildings = count_buildings(found);
  result.true_faces = truth.size();
  result.found_faces = found.size();
  const double step = params.sample_m / params.metres_per_unit;
  const FacesByPlace places(found);
  count_classes(truth, found, match_faces(truth, found, places, params), places, params, result);
  compare_heights(truth, found, places, step, params, result);
  result.hausdorff_m = result.outline_p95_m = kInfinity;
  if (truth.empty() || found.empty()) return result;
  result.hausdorff_m = params.metres_per_unit *
                       std::max(farthest(truth, surface_of(found), step), farthest(found, surface_of(truth), step));
  result.outline_p95_m = params.metres_per_unit * outline_p95(truth, found, step);
  return result;
}

}  // namespace ilot
