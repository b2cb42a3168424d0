// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawn_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr double kSampleM = 0.01;  // metres between samples of an edge

std::vector<FlatEdge> edges_of(const std::vector<FlatPoint>& ring) {
  std::vector<FlatEdge> edges;
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  return edges;
}

double distance_to(FlatPoint p, std::span<const FlatEdge> edges) {
  double best = std::numeric_limits<double>::infinity();
  for (const FlatEdge& edge : edges) best = std::min(best, squared_distance(p, edge));
  return std::sqrt(best);
}

// Calls use(distance) for evenly spaced samples of the edge, and returns their number.
template <class Use>
double sample(const FlatEdge& edge, std::span<const FlatEdge> others, double metres_per_unit, const Use& use) {
  const double length = distance(edge.a, edge.b) * metres_per_unit;
  const double samples = std::clamp(std::ceil(length / kSampleM), 1.0, 1e5);
  for (double k = 0; k < samples; ++k)
    use(metres_per_unit * distance_to(edge.a + ((k + 0.5) / samples) * (edge.b - edge.a), others));
  return samples;
}

DrawnStatus status_of(const FacadeElement& e, std::size_t edge) {
  return e.edges.size() == e.ring.size() && e.edges[edge].status != DrawnStatus::seen ? e.edges[edge].status : e.status;
}

// The drawn edges that are not occluded.
std::vector<FlatEdge> known_edges(const OpeningPair& pair) {
  const std::vector<FlatEdge> all = edges_of(pair.drawn_ring);
  std::vector<FlatEdge> known;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (status_of(*pair.found, i) != DrawnStatus::occluded) known.push_back(all[i]);
  return known;
}

void add_lengths(const OpeningPair& pair, double metres_per_unit, DrawnEdges& result) {
  const std::vector<FlatEdge> known = known_edges(pair);
  for (const FlatEdge& edge : edges_of(pair.true_ring)) {
    std::array<double, kEdgeLimitsM.size()> hits{};
    const double samples = sample(edge, known, metres_per_unit, [&](double d) {
      for (std::size_t i = 0; i < hits.size(); ++i) hits[i] += d <= kEdgeLimitsM[i];
    });
    const double length = distance(edge.a, edge.b) * metres_per_unit;
    for (std::size_t i = 0; i < hits.size(); ++i) result.within_m[i] += length * hits[i] / samples;
  }
}

struct EdgeErrors {
  std::vector<double> stated, measured;
};

void add_errors(const OpeningPair& pair, double metres_per_unit, std::array<EdgeErrors, 2>& errors) {
  if (pair.found->edges.size() != pair.drawn_ring.size()) return;
  const std::vector<FlatEdge> true_ring = edges_of(pair.true_ring), drawn = edges_of(pair.drawn_ring);
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const DrawnStatus status = status_of(*pair.found, i);
    const double stated = pair.found->edges[i].error_m;
    if (status == DrawnStatus::occluded || !(stated > 0)) continue;
    double sum = 0;
    const double samples = sample(drawn[i], true_ring, metres_per_unit, [&](double d) { sum += d; });
    EdgeErrors& of_status = errors[status == DrawnStatus::seen ? 0 : 1];
    of_status.stated.push_back(stated);
    of_status.measured.push_back(sum / samples);
  }
}

double median(std::vector<double> values) {
  return values.empty() ? 0 : upper_median(values);
}

}  // namespace

double DrawnEdges::share(std::size_t limit) const {
  return true_m > 0 ? within_m[limit] / true_m : 0;
}

DrawnEdges evaluate_drawn_edges(std::span<const TrueOpening> truth, std::span<const OpeningPair> pairs,
                                double metres_per_unit) {
  DrawnEdges result;
  result.stated[1].status = DrawnStatus::completed;
  for (const TrueOpening& opening : truth)
    for (std::size_t i = 0; i < opening.ring.size(); ++i)
      result.true_m += metres_per_unit * norm(opening.ring[(i + 1) % opening.ring.size()] - opening.ring[i]);
  std::array<EdgeErrors, 2> errors;
  for (const OpeningPair& pair : pairs) {
    add_lengths(pair, metres_per_unit, result);
    add_errors(pair, metres_per_unit, errors);
  }
  for (std::size_t s = 0; s < errors.size(); ++s) {
    result.stated[s].edges = errors[s].stated.size();
    for (std::size_t i = 0; i < errors[s].stated.size(); ++i)
      result.stated[s].within += errors[s].measured[i] <= errors[s].stated[i];
    result.stated[s].median_stated_m = median(errors[s].stated);
    result.stated[s].median_true_m = median(errors[s].measured);
  }
  return result;
}

}  // namespace ilot
