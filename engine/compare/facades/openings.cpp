// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/openings.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include "engine/compare/planes/boundary_error.h"
#include "engine/compare/planes/plane_frame.h"
#include "engine/flat_area.h"

namespace ilot {
namespace {

constexpr double kSample = 0.01;  // metres between samples of a ring

// A possible pair: `drawn` is the index of the drawn opening.
struct Candidate {
  OpeningPair pair;
  std::size_t drawn = 0;
};

// The plane of a ring; nullopt when it has no area.
std::optional<FlatFrame> frame_of_ring(const Ring3& ring, Vec3& normal) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum = sum + cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  if (!(norm(sum) > 0)) return std::nullopt;
  normal = (1 / norm(sum)) * sum;
  return plane_frame(normal, ring[0]);
}

std::vector<FlatPoint> flattened(const Ring3& ring, const FlatFrame& frame) {
  std::vector<FlatPoint> flat;
  for (const Vec3& p : ring) flat.push_back(frame.flat(p));
  return flat;
}

bool boxes_meet(const std::vector<FlatPoint>& a, const std::vector<FlatPoint>& b) {
  const auto [ax0, ax1] = std::minmax_element(a.begin(), a.end(), [](auto p, auto q) { return p.x < q.x; });
  const auto [bx0, bx1] = std::minmax_element(b.begin(), b.end(), [](auto p, auto q) { return p.x < q.x; });
  const auto [ay0, ay1] = std::minmax_element(a.begin(), a.end(), [](auto p, auto q) { return p.y < q.y; });
  const auto [by0, by1] = std::minmax_element(b.begin(), b.end(), [](auto p, auto q) { return p.y < q.y; });
  return ax0->x <= bx1->x && bx0->x <= ax1->x && ay0->y <= by1->y && by0->y <= ay1->y;
}

void compare(const TrueOpening& truth, std::size_t number, const std::vector<const FacadeElement*>& found,
             const OpeningMatching& params, std::vector<Candidate>& candidates) {
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
    candidates.push_back({{number, found[f], iou, distance, true_polygon.ring, polygon.ring}, f});
  }
}

std::vector<const FacadeElement*> drawn_openings(std::span<const Facade> facades) {
  std::vector<const FacadeElement*> drawn;
  for (const Facade& facade : facades)
    for (const FacadeElement& e : facade.elements)
      if (e.opening && e.status != DrawnStatus::occluded) drawn.push_back(&e);
  return drawn;
}

}  // namespace

std::vector<OpeningPair> match_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                        const OpeningMatching& params) {
  const std::vector<const FacadeElement*> drawn = drawn_openings(facades);
  std::vector<Candidate> candidates;
  for (std::size_t t = 0; t < truth.size(); ++t) compare(truth[t], t, drawn, params, candidates);
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(b.pair.iou, a.pair.truth, a.drawn) < std::tie(a.pair.iou, b.pair.truth, b.drawn);
  });
  std::vector<char> truth_taken(truth.size()), drawn_taken(drawn.size());
  std::vector<OpeningPair> pairs;
  for (Candidate& candidate : candidates) {
    if (truth_taken[candidate.pair.truth] || drawn_taken[candidate.drawn]) continue;
    truth_taken[candidate.pair.truth] = drawn_taken[candidate.drawn] = 1;
    pairs.push_back(std::move(candidate.pair));
  }
  return pairs;
}

OpeningResult evaluate_openings(std::span<const TrueOpening> truth, std::span<const Facade> facades,
                                const OpeningMatching& params) {
  OpeningResult result{truth.size(), drawn_openings(facades).size(), 0, 0, 0, 0};
  for (const OpeningPair& pair : match_openings(truth, facades, params)) {
    ++result.matched;
    result.iou_mean += pair.iou;
    result.ring_distance_m += pair.distance_m;
  }
  result.invented = result.found - result.matched;
  if (result.matched == 0) return result;
  result.iou_mean /= static_cast<double>(result.matched);
  result.ring_distance_m /= static_cast<double>(result.matched);
  return result;
}

}  // namespace ilot
