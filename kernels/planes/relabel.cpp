// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/relabel.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "kernels/neighbours/knn.h"

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

  // Labels of the neighbours of i, itself left out.
  Votes votes(std::uint32_t i, std::span<const std::uint32_t> label) const {
    Votes votes;
    for (const std::uint32_t j : neighbours_.of(i)) {
      if (j == kNoNeighbour) break;
      if (j == i || label[j] == 0) continue;
      const double dx = p_.x[i] - p_.x[j], dy = p_.y[i] - p_.y[j], dz = p_.z[i] - p_.z[j];
      if (dx * dx + dy * dy + dz * dz <= max_d2_) votes.add(label[j]);
    }
    return votes;
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

std::size_t adopt_strays(Points points, const NeighbourLists& neighbours, const RelabelParams& params,
                         PlaneSegments& segments) {
  const Neighbourhood around(points, neighbours, params.max_gap);
  std::vector<std::uint32_t> strays;
  for (std::uint32_t i = 0; i < points.size; ++i)
    if (segments.label[i] == 0) strays.push_back(i);
  std::size_t adopted = 0;
  std::vector<std::uint32_t> chosen;
  for (int round = 0; round < params.max_rounds && !strays.empty(); ++round) {
    chosen.assign(strays.size(), 0);
    for (std::size_t s = 0; s < strays.size(); ++s) {
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
    for (std::size_t s = 0; s < strays.size(); ++s) {
      segments.label[strays[s]] = chosen[s];
      if (chosen[s] == 0) strays[left++] = strays[s];
    }
    if (left == strays.size()) break;
    adopted += strays.size() - left;
    strays.resize(left);
  }
  return adopted;
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
