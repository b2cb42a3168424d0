// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/openings.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "engine/compare/boundary_error.h"
#include "engine/compare/overlay.h"
#include "engine/compare/plane_frame.h"

namespace ilot {
namespace {

constexpr double kSample = 0.01;  // metres between samples of a ring

struct OpeningPair {
  double iou = 0, distance = 0;
  std::size_t truth = 0, found = 0;
};

// The plane of a ring; nullopt when it has no area.
std::optional<FlatFrame> frame_of_ring(const Ring3& ring, Vec3& normal) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  if (!(norm(sum) > 0)) return std::nullopt;
  normal = (1 / norm(sum)) * sum;
  return plane_frame(normal, ring[0]);
}

bool boxes_meet(const std::vector<FlatPoint>& a, const std::vector<FlatPoint>& b) {
  const auto [ax0, ax1] = std::minmax_element(a.begin(), a.end(), [](auto p, auto q) { return p.x < q.x; });
  const auto [bx0, bx1] = std::minmax_element(b.begin(), b.end(), [](auto p, auto q) { return p.x < q.x; });
  const auto [ay0, ay1] = std::minmax_element(a.begin(), a.end(), [](auto p, auto q) { return p.y < q.y; });
  const auto [by0, by1] = std::minmax_element(b.begin(), b.end(), [](auto p, auto q) { return p.y < q.y; });
  return ax0->x <= bx1->x && bx0->x <= ax1->x && ay0->y <= by1->y && by0->y <= ay1->y;
}

void compare(const TrueOpening& truth, std::size_t number, const std::vector<const FacadeElement*>& found,
             const OpeningMatching& params, std::vector<OpeningPair>& pairs) {
  Vec3 normal;
  const std::optional<FlatFrame> frame = frame_of_ring(truth.ring, normal);
  if (!frame) return;
  const FlatPolygon true_polygon{flattened(truth.ring, *frame), {}};
  const FlatArea true_area(std::span(&true_polygon, 1));
  for (std::size_t f = 0; f < found.size(); ++f) {
    const double depth = dot(found[f]->ring[0] - truth.ring[0], normal) * params.metres_per_unit;
    const FlatPolygon polygon{flattened(found[f]->ring, *frame), {}};
    if (std::abs(depth) > params.depth_m || !boxes_meet(polygon.ring, true_polygon.ring)) continue;
    const double iou = intersection_over_union(true_area, FlatArea(std::span(&polygon, 1)));
    if (iou < params.least_iou) continue;
    const double step = kSample / params.metres_per_unit;
    const double distance = mean_ring_distance(polygon.ring, true_area.edges(), step) * params.metres_per_unit;
    pairs.push_back({iou, distance, number, f});
  }
}

}  // namespace

OpeningResult evaluate_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                const OpeningMatching& params) {
  std::vector<const FacadeElement*> found;
  for (const Facade& facade : facades)
    for (const FacadeElement& e : facade.elements)
      if (e.opening && e.status != DrawnStatus::occluded) found.push_back(&e);
  std::vector<OpeningPair> pairs;
  for (std::size_t t = 0; t < truth.size(); ++t) compare(truth[t], t, found, params, pairs);
  std::sort(pairs.begin(), pairs.end(), [](const OpeningPair& a, const OpeningPair& b) {
    return std::tie(b.iou, a.truth, a.found) < std::tie(a.iou, b.truth, b.found);
  });
  std::vector<char> truth_taken(truth.size()), found_taken(found.size());
  OpeningResult result{truth.size(), found.size(), 0, 0, 0, 0};
  for (const OpeningPair& pair : pairs) {
    if (truth_taken[pair.truth] || found_taken[pair.found]) continue;
    truth_taken[pair.truth] = found_taken[pair.found] = 1;
    ++result.matched;
    result.iou_mean += pair.iou;
    result.ring_distance_m += pair.distance;
  }
  result.invented = result.found - result.matched;
  if (result.matched == 0) return result;
  result.iou_mean /= static_cast<double>(result.matched);
  result.ring_distance_m /= static_cast<double>(result.matched);
  return result;
}

}  // namespace ilot
