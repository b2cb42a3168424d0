// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/relabel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "kernels/neighbours/knn.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/refine.h"
#include "kernels/planes/run_neighbours.h"

namespace ilot {
namespace {

struct Vote {
  std::uint32_t label, count;
};

struct Votes {
  std::array<Vote, kMaxNeighbours> vote;
  std::size_t size = 0;

  void add(std::uint32_t label) {
    for (std::size_t v = 0; v < size; ++v)
      if (vote[v].label == label) {
        ++vote[v].count;
        return;
      }
    vote[size++] = {label, 1};
  }
};

class Neighbourhood {
 public:
  Neighbourhood(Points points, const NeighbourLists& neighbours, std::int64_t max_gap)
      : p_(points), neighbours_(neighbours), max_d2_(static_cast<double>(max_gap) * static_cast<double>(max_gap)) {
    assert(neighbours.k <= static_cast<std::uint32_t>(kMaxNeighbours));
  }

  // Returns the labels of the neighbours of i, without i itself and without those of a label that does not count.
  Votes votes(std::uint32_t i, std::span<const std::uint32_t> label, std::uint32_t without = 0) const {
    Votes votes;
    for (const std::uint32_t j : neighbours_.of(i)) {
      if (j == kNoNeighbour) break;
      if (j == i || label[j] == 0 || label[j] == without) continue;
      const double dx = p_.x[i] - p_.x[j], dy = p_.y[i] - p_.y[j], dz = p_.z[i] - p_.z[j];
      if (dx * dx + dy * dy + dz * dz <= max_d2_) votes.add(label[j]);
    }
    return votes;
  }
  bool any_in(std::uint32_t i, std::span<const std::uint8_t> set) const {
    std::uint8_t any = set[i];
    for (const std::uint32_t j : neighbours_.of(i)) any |= set[j == kNoNeighbour ? i : j];
    return any != 0;
  }
  // Whether all neighbours have this label, as i has. Most do, so all are looked at without branches.
  bool all_have(std::uint32_t i, std::uint32_t wanted, std::span<const std::uint32_t> label) const {
    std::uint32_t differing = 0;
    for (const std::uint32_t j : neighbours_.of(i)) differing |= label[j == kNoNeighbour ? i : j] ^ wanted;
    return differing == 0;
  }
  // Returns the side of the plane on which the neighbours with this label are. It is the sum of the signed distances of
  // those that are clearly not on the plane, or 0 when there are none.
  double side(std::uint32_t i, std::span<const std::uint32_t> label, std::uint32_t wanted, const Plane& plane,
              double epsilon) const {
    double sum = 0;
    for (const std::uint32_t j : neighbours_.of(i)) {
      if (j == kNoNeighbour) break;
      if (j == i || label[j] != wanted) continue;
      const double d = signed_distance(plane, {p_.x[j], p_.y[j], p_.z[j]});
      if (std::abs(d) > epsilon) sum += d;
    }
    return sum;
  }
  double signed_from(std::uint32_t i, const Plane& plane) const {
    return signed_distance(plane, {p_.x[i], p_.y[i], p_.z[i]});
  }
  double distance(std::uint32_t i, const Plane& plane) const {
    return std::abs(signed_distance(plane, {p_.x[i], p_.y[i], p_.z[i]}));
  }

 private:
  Points p_;
  const NeighbourLists& neighbours_;
  double max_d2_;
};

}  // namespace

std::size_t assign_unlabelled(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                              PlaneSegments& segments) {
  const Neighbourhood around(points, neighbours, params.max_gap);
  std::vector<std::uint32_t> strays;
  for (std::uint32_t i = 0; i < points.size; ++i)
    if (segments.label[i] == 0) strays.push_back(i);
  std::size_t adopted = 0;
  std::vector<std::uint32_t> chosen;
  std::vector<std::uint8_t> changed(points.size, 0);  // whether a point got its label in the round before
  for (int round = 0; round < params.max_rounds && !strays.empty(); ++round) {
    chosen.assign(strays.size(), 0);
    for (std::size_t s = 0; s < strays.size(); ++s) {
      if (round > 0 && !around.any_in(strays[s], changed)) continue;  // as before: it stays without a label
      const Votes votes = around.votes(strays[s], segments.label);
      double least = params.epsilon;
      for (std::size_t v = 0; v < votes.size; ++v) {
        const Vote& vote = votes.vote[v];
        if (vote.count < params.min_votes) continue;
        const double d = around.distance(strays[s], segments.planes[vote.label - 1]);
        const bool nearer = d < least || (d == least && (chosen[s] == 0 || vote.label < chosen[s]));
        if (!nearer) continue;
        least = d;
        chosen[s] = vote.label;
      }
    }
    std::size_t left = 0;
    if (round > 0) std::fill(changed.begin(), changed.end(), std::uint8_t{0});
    for (std::size_t s = 0; s < strays.size(); ++s) {
      segments.label[strays[s]] = chosen[s];
      changed[strays[s]] = chosen[s] != 0;
      if (chosen[s] == 0) strays[left++] = strays[s];
    }
    if (left == strays.size()) break;
    adopted += strays.size() - left;
    strays.resize(left);
  }
  return adopted;
}

namespace {

// Returns the nearest of its own plane and those that enough neighbours have. In a tie it keeps its own plane, then the
// smaller label wins.
std::uint32_t nearest(const Neighbourhood& around, std::uint32_t i, const RelabelParams& params,
                      const PlaneSegments& segments, const Votes& votes) {
  std::uint32_t best = segments.label[i];
  double least = around.distance(i, segments.planes[best - 1]);
  for (std::size_t v = 0; v < votes.size; ++v) {
    const Vote& vote = votes.vote[v];
    if (vote.count < params.min_votes) continue;
    const double d = around.distance(i, segments.planes[vote.label - 1]);
    if (d > params.epsilon || d > least || (d == least && (best == segments.label[i] || vote.label > best))) continue;
    least = d;
    best = vote.label;
  }
  return best;
}

// Returns the label that a point should have: its own, or that of a plane on whose side of the bisector it is.
std::uint32_t split_label(const Neighbourhood& around, std::uint32_t i, const RelabelParams& params,
                          const PlaneSegments& segments, const std::vector<std::uint32_t>& size) {
  const std::uint32_t own = segments.label[i];
  if (around.all_have(i, own, segments.label)) return own;
  const Votes votes = around.votes(i, segments.label, own);
  if (votes.size == 0) return own;
  if (params.border == RelabelParams::Border::nearest) return nearest(around, i, params, segments, votes);
  const Plane& a = segments.planes[own - 1];
  std::uint32_t best = own;
  double margin = 0;
  for (std::size_t v = 0; v < votes.size; ++v) {
    const Vote& vote = votes.vote[v];
    if (vote.count < params.min_votes) continue;
    const Plane& b = segments.planes[vote.label - 1];
    const double to_b = around.signed_from(i, b), to_a = around.signed_from(i, a);
    if (std::abs(to_b) > params.epsilon) continue;
    // How far the point is on the side of a plane where the points of the other plane are.
    const double side_of_a = around.side(i, segments.label, vote.label, a, params.epsilon);
    if (side_of_a == 0) continue;  // no neighbour here clearly belongs to the other plane
    const double side_of_b = around.side(i, segments.label, own, b, params.epsilon);
    const double beyond_a = side_of_a < 0 ? -to_a : to_a;
    const double beyond_b = side_of_b == 0 ? -params.epsilon : side_of_b < 0 ? -to_b : to_b;
    const double lean = size[vote.label] > size[own] ? params.lean : size[vote.label] < size[own] ? -params.lean : 0;
    const double gain = beyond_a - beyond_b + lean;
    if (gain > margin || (gain == margin && gain > 0 && vote.label < best)) {
      margin = gain;
      best = vote.label;
    }
  }
  return best;
}

std::size_t split_borders(Points points, const NeighbourLists& neighbours, const RunNeighbours& runs,
                          const RelabelParams& params, PlaneSegments& segments) {
  const Neighbourhood around(points, neighbours, params.max_gap);
  std::size_t moves = 0;
  struct Move {
    std::uint32_t point, label;
  };
  std::vector<Move> round;
  std::vector<std::uint32_t> moved;  // points moved in the round before; a point without such a neighbour does not move
  std::vector<std::uint8_t> in_moved(points.size, 0);
  std::vector<std::uint32_t> size(segments.planes.size() + 1, 0);  // before the first round
  for (const std::uint32_t l : segments.label) ++size[l];
  for (int r = 0; r < params.max_rounds; ++r) {
    round.clear();
    const std::vector<std::uint8_t> quiet = r == 0 ? uniform_runs(runs, segments.label) : unaffected_runs(runs, moved);
    for (std::uint32_t i = 0; i < points.size; ++i) {
      if (quiet[i / RunNeighbours::kRun]) continue;
      if (segments.label[i] == 0 || (r > 0 && !around.any_in(i, in_moved))) continue;
      const std::uint32_t label = split_label(around, i, params, segments, size);
      if (label != segments.label[i]) round.push_back({i, label});
    }
    for (const std::uint32_t i : moved) in_moved[i] = 0;
    moved.clear();
    for (const Move& m : round) {
      segments.label[m.point] = m.label;
      in_moved[m.point] = 1;
      moved.push_back(m.point);
    }
    moves += round.size();
    if (round.empty()) break;
  }
  return moves;
}

}  // namespace

std::size_t split_borders(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          PlaneSegments& segments) {
  return split_borders(points, neighbours, RunNeighbours(points.size, neighbours), params, segments);
}

namespace {

// Fits the least-squares planes of the labels. Points beyond epsilon lose their label. Planes with fewer than
// min_points lose all points.
void refit(Points points, double epsilon, std::uint32_t min_points, PlaneSegments& s) {
  std::vector<std::vector<std::uint32_t>> members(s.planes.size());
  for (std::uint32_t i = 0; i < points.size; ++i)
    if (s.label[i] != 0) members[s.label[i] - 1].push_back(i);
  std::vector<Plane> planes;
  for (std::size_t p = 0; p < members.size(); ++p) {
    for (const std::uint32_t i : members[p]) s.label[i] = 0;
    if (members[p].size() < min_points) continue;
    const PlaneFit fit = fit_plane(moments_of(points, members[p]));
    const Plane plane = fit.unique ? fit.plane : s.planes[p];
    const auto kept = consensus_set({points}, members[p], plane, {epsilon});
    if (kept.size() < min_points) continue;
    planes.push_back(plane);
    for (const std::uint32_t i : kept) s.label[i] = static_cast<std::uint32_t>(planes.size());
  }
  s.planes = std::move(planes);
}

}  // namespace

void relabel_until_stable(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                          std::uint32_t min_points, PlaneSegments& segments) {
  relabel_until_stable(points, neighbours, RunNeighbours(points.size, neighbours), params, min_points, segments);
}

void relabel_until_stable(Points points, const NeighbourLists& neighbours, const RunNeighbours& runs,
                          const RelabelParams& params, std::uint32_t min_points, PlaneSegments& segments) {
  std::vector<std::uint32_t> before;
  for (int round = 0; round < params.max_rounds && before != segments.label; ++round) {
    before = segments.label;
    assign_unlabelled(points, neighbours, params, segments);
    split_borders(points, neighbours, runs, params, segments);
    refit(points, params.epsilon, min_points, segments);
  }
}

std::size_t relabel_islands(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                            PlaneSegments& segments) {
  const Neighbourhood around(points, neighbours, params.max_gap);
  const std::vector<std::uint32_t> before = segments.label;
  std::size_t moved = 0;
  for (std::uint32_t i = 0; i < points.size; ++i) {
    if (before[i] == 0) continue;
    const Votes votes = around.votes(i, before);
    const auto end = votes.vote.begin() + static_cast<std::ptrdiff_t>(votes.size);
    const auto top =
        std::max_element(votes.vote.begin(), end, [](const Vote& a, const Vote& b) { return a.count < b.count; });
    if (top == end || top->label == before[i]) continue;
    const auto rivals = std::count_if(votes.vote.begin(), end, [&](const Vote& v) { return v.count == top->count; });
    if (rivals > 1 || around.distance(i, segments.planes[top->label - 1]) > params.epsilon) continue;
    segments.label[i] = top->label;
    ++moved;
  }
  return moved;
}

}  // namespace ilot
