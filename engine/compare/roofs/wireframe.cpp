// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/wireframe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tuple>

#include "engine/compare/roofs/assignment.h"
#include "kernels/core/parallel.h"
#include "kernels/geometry/closest.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {
namespace {

double distance_to(Vec3 p, const Edge3& edge) {
  return norm(p - closest_on_segment(p, edge.a, edge.b));
}

// The Hausdorff distance of two segments. The distance to a segment is convex, so its largest value along another one
// is at an end.
double hausdorff(const Edge3& e, const Edge3& f) {
  return std::max({distance_to(e.a, f), distance_to(e.b, f), distance_to(f.a, e), distance_to(f.b, e)});
}

double corner_distance(const Edge3& e, const Edge3& f) {
  return std::min(norm(e.a - f.a) + norm(e.b - f.b), norm(e.a - f.b) + norm(e.b - f.a)) / 2;
}

std::optional<double> ratio(double part, double all) {
  return all > 0 ? std::optional(part / all) : std::nullopt;
}

FlatBox plan_box(std::span<const Vec3> points) {
  FlatBox box = FlatBox::none();
  for (const Vec3& p : points) box.add({p.x, p.y});
  return box;
}

std::vector<Vec3> ends_of(std::span<const Edge3> edges) {
  std::vector<Vec3> ends;
  for (const Edge3& e : edges) ends.insert(ends.end(), {e.a, e.b});
  return ends;
}

double box_iou(const FlatBox& a, const FlatBox& b) {
  if (!a.overlaps(b)) return 0;
  const double common = (std::min(a.max.x, b.max.x) - std::max(a.min.x, b.min.x)) *
                        (std::min(a.max.y, b.max.y) - std::max(a.min.y, b.min.y));
  return common / (a.width() * a.height() + b.width() * b.height() - common);
}

// Boxes in the order of their centres along x, from which the partner of another box is searched to both sides.
class BoxesByPlace {
 public:
  explicit BoxesByPlace(std::vector<FlatBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::make_pair(boxes_[a].middle().x, a) < std::make_pair(boxes_[b].middle().x, b);
    });
    for (const FlatBox& box : boxes_) widest_ = std::max(widest_, box.width());
  }

  std::size_t partner(const FlatBox& box) const {
    const double x = box.middle().x, y = box.middle().y;
    const auto from = std::lower_bound(order_.begin(), order_.end(), x,
                                       [&](std::uint32_t b, double at) { return boxes_[b].middle().x < at; });
    // Greater overlap first, then the nearer centre, then the earlier box.
    std::tuple<double, double, std::uint32_t> best{1, 0, 0};  // above every possible value
    const auto look = [&](std::uint32_t b) {
      const FlatPoint m = boxes_[b].middle();
      best = std::min(best, {-box_iou(box, boxes_[b]), std::hypot(m.x - x, m.y - y), b});
    };
    const auto useful = [&](std::uint32_t b) {
      const double away = std::abs(boxes_[b].middle().x - x);
      return away <= (widest_ + box.width()) / 2 || (std::get<0>(best) >= 0 && away <= limit(best));
    };
    for (auto at = from; at != order_.end() && useful(*at); ++at) look(*at);
    for (auto at = from; at != order_.begin() && useful(*(at - 1)); --at) look(*(at - 1));
    return std::get<2>(best);
  }

 private:
  // How far along x a nearer centre can be: everywhere while nothing is found.
  static double limit(const std::tuple<double, double, std::uint32_t>& best) {
    return std::get<0>(best) > 0 ? std::numeric_limits<double>::infinity() : std::get<1>(best);
  }

  std::vector<FlatBox> boxes_;
  std::vector<std::uint32_t> order_;
  double widest_ = 0;
};

}  // namespace

void EdgeScore::add(const EdgeScore& o) {
  truth += o.truth;
  drawn += o.drawn;
  matched += o.matched;
  close += o.close;
  corners_m += o.corners_m;
  judged_length += o.judged_length;
  short_edges += o.short_edges;
}

std::optional<double> EdgeScore::precision() const {
  return ratio(static_cast<double>(matched), static_cast<double>(drawn));
}
std::optional<double> EdgeScore::recall() const {
  return ratio(static_cast<double>(matched), static_cast<double>(truth));
}
std::optional<double> EdgeScore::f1() const {
  return ratio(2 * static_cast<double>(matched), static_cast<double>(drawn + truth));
}
std::optional<double> EdgeScore::f1_close() const {
  return ratio(2 * static_cast<double>(close), static_cast<double>(drawn + truth));
}
std::optional<double> EdgeScore::corner_offset_m() const {
  return ratio(corners_m, static_cast<double>(matched));
}
std::optional<double> EdgeScore::drawn_over_true() const {
  return ratio(static_cast<double>(drawn), static_cast<double>(truth));
}
std::optional<double> EdgeScore::short_share() const {
  return ratio(static_cast<double>(short_edges), static_cast<double>(judged_length));
}

double radius_of(std::span<const Vec3> points) {
  if (points.empty()) return 0;
  Vec3 sum;
  for (const Vec3& p : points) sum = sum + (p - points[0]);
  const Vec3 mean = points[0] + (1.0 / static_cast<double>(points.size())) * sum;
  double most = 0;
  for (const Vec3& p : points) most = std::max(most, norm(p - mean));
  return most;
}

double radius_of(std::span<const Edge3> edges) {
  return radius_of(ends_of(edges));
}

EdgeScore compare_edges(const Wireframe& truth, std::span<const RoofEdge> drawn, bool outline_given,
                        double metres_per_unit) {
  EdgeScore score;
  score.truth = truth.edges.size();
  score.drawn = drawn.size();
  for (const RoofEdge& edge : drawn) {
    const bool is_short = norm(edge.edge.b - edge.edge.a) * metres_per_unit < kShortEdge;
    if (edge.inside_face || (outline_given && edge.of_outline && is_short)) continue;
    ++score.judged_length;
    score.short_edges += is_short;
  }
  std::vector<double> costs;
  costs.reserve(truth.edges.size() * drawn.size());
  for (const Edge3& edge : truth.edges)
    for (const RoofEdge& other : drawn) costs.push_back(hausdorff(edge, other.edge));
  const std::vector<std::uint32_t> partner = least_assignment(costs, truth.edges.size(), drawn.size());
  for (std::size_t i = 0; i < partner.size(); ++i) {
    if (partner[i] == kUnassigned) continue;
    const double distance = costs[i * drawn.size() + partner[i]];
    score.close += distance * metres_per_unit <= kCloseEdge;
    if (distance > kEdgeShare * truth.radius) continue;
    ++score.matched;
    score.corners_m += metres_per_unit * corner_distance(truth.edges[i], drawn[partner[i]].edge);
  }
  return score;
}

std::vector<EdgeScore> compare_wireframes(std::span<const Wireframe> truth, std::span<const PolygonModel> models,
                                          bool outline_given, double metres_per_unit) {
  if (truth.empty()) return {};
  std::vector<FlatBox> boxes;
  for (const Wireframe& wireframe : truth) boxes.push_back(plan_box(ends_of(wireframe.edges)));
  const BoxesByPlace places(std::move(boxes));
  std::vector<std::vector<RoofEdge>> drawn(truth.size());
  for (const PolygonModel& model : models) {
    const std::vector<RoofEdge> edges = roof_edges(model, metres_per_unit);
    if (edges.empty()) continue;
    std::vector<RoofEdge>& all = drawn[places.partner(plan_box(model.vertices))];
    all.insert(all.end(), edges.begin(), edges.end());
  }
  std::vector<EdgeScore> scores(truth.size());
  parallel_for(truth.size(),
               [&](std::size_t i) { scores[i] = compare_edges(truth[i], drawn[i], outline_given, metres_per_unit); });
  return scores;
}

}  // namespace ilot
