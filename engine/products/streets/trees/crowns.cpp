// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/crowns.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace ilot {
namespace {

// Two regions that may become one, the smaller number first. Higher passes come first, then smaller numbers.
struct Join {
  double share = 0;  // height of the pass over that of the lower top
  std::uint32_t first = 0, second = 0;

  friend bool operator<(const Join& a, const Join& b) {
    return std::tie(a.share, b.first, b.second) < std::tie(b.share, a.first, a.second);
  }
};

class CrownFinder {
 public:
  CrownFinder(const Image& above, std::span<const TrunkCell> trunks, const CrownParams& params)
      : above_(above), trunks_(trunks), params_(params) {}

  CrownRegions find() {
    climb();
    give_trunks();
    find_passes();
    join();
    return numbered();
  }

 private:
  bool in_crown(std::size_t i) const { return above_.values[i] >= params_.least_height; }

  template <class Take>
  void for_neighbours(std::size_t i, const Take& take) const {
    const auto x = static_cast<std::int64_t>(i % above_.width), y = static_cast<std::int64_t>(i / above_.width);
    for (std::int64_t v = std::max<std::int64_t>(0, y - 1); v <= std::min<std::int64_t>(above_.height - 1, y + 1); ++v)
      for (std::int64_t u = std::max<std::int64_t>(0, x - 1); u <= std::min<std::int64_t>(above_.width - 1, x + 1); ++u)
        if (const auto j = static_cast<std::size_t>(v * above_.width + u); j != i && in_crown(j)) take(j);
  }

  // Labels each cell with the treetop that it leads to: from the highest cell down, each takes the region of its
  // highest neighbour, or begins one.
  void climb() {
    std::vector<std::uint32_t> order;
    order.reserve(static_cast<std::size_t>(std::count_if(above_.values.begin(), above_.values.end(),
                                                         [&](Height v) { return v >= params_.least_height; })));
    for (std::size_t i = 0; i < above_.size(); ++i)
      if (in_crown(i)) order.push_back(static_cast<std::uint32_t>(i));
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return above_.values[a] != above_.values[b] ? above_.values[a] > above_.values[b] : a < b;
    });
    of_.assign(above_.size(), 0);
    for (const std::size_t i : order) {
      std::size_t best = i;
      for_neighbours(i, [&](std::size_t j) {
        if (of_[j] != 0 && (best == i || above_.values[j] > above_.values[best])) best = j;
      });
      if (best == i)
        of_[i] = add_region(i);
      else
        of_[i] = of_[best];
    }
  }

  std::uint32_t add_region(std::size_t top) {
    tops_.push_back(top);
    trunk_.push_back(-1);
    return static_cast<std::uint32_t>(tops_.size());
  }

  // The region over a trunk: that of its cell, or of the first cell around it.
  std::uint32_t region_over(const TrunkCell& t) const {
    const std::size_t i = std::size_t{t.y} * above_.width + t.x;
    if (of_[i] != 0) return of_[i];
    std::uint32_t found = 0;
    for_neighbours(i, [&](std::size_t j) {
      if (found == 0) found = of_[j];
    });
    return found;
  }

  void give_trunks() {
    std::map<std::uint32_t, std::vector<int>> by_region;
    for (std::size_t t = 0; t < trunks_.size(); ++t)
      if (const std::uint32_t region = region_over(trunks_[t]); region != 0)
        by_region[region].push_back(static_cast<int>(t));
    std::map<std::uint32_t, std::vector<std::pair<int, std::uint32_t>>> split;  // trunks and their regions
    for (auto& [region, list] : by_region) {
      const int thickest =
          *std::max_element(list.begin(), list.end(), [&](int a, int b) { return radius_of(a) < radius_of(b); });
      std::erase_if(list, [&](int t) { return t != thickest && is_post(t, thickest); });
      trunk_[region - 1] = list[0];
      if (list.size() == 1) continue;
      split[region].emplace_back(list[0], region);
      for (std::size_t k = 1; k < list.size(); ++k) {
        const std::uint32_t added = add_region(tops_[region - 1]);
        trunk_[added - 1] = list[k];
        split[region].emplace_back(list[k], added);
      }
    }
    if (split.empty()) return;
    for (std::size_t i = 0; i < of_.size(); ++i)
      if (const auto found = split.find(of_[i]); of_[i] != 0 && found != split.end())
        of_[i] = nearest(i, found->second);
    find_tops();
  }

  std::uint32_t nearest(std::size_t cell, const std::vector<std::pair<int, std::uint32_t>>& choices) const {
    const auto x = static_cast<std::int64_t>(cell % above_.width), y = static_cast<std::int64_t>(cell / above_.width);
    std::int64_t least = INT64_MAX;
    std::uint32_t best = 0;
    for (const auto& [t, region] : choices) {
      const TrunkCell& trunk = trunks_[static_cast<std::size_t>(t)];
      const std::int64_t dx = x - trunk.x, dy = y - trunk.y, d = dx * dx + dy * dy;
      if (d < least) least = d, best = region;
    }
    return best;
  }

  void find_tops() {
    std::vector<std::size_t> tops(tops_.size(), above_.size());
    for (std::size_t i = 0; i < of_.size(); ++i) {
      if (of_[i] == 0) continue;
      std::size_t& top = tops[of_[i] - 1];
      if (top == above_.size() || above_.values[i] > above_.values[top]) top = i;
    }
    for (std::size_t r = 0; r < tops.size(); ++r)
      if (tops[r] != above_.size()) tops_[r] = tops[r];
  }

  // The highest pass between each two regions that touch.
  void find_passes() {
    passes_.resize(tops_.size() + 1);
    cells_.assign(tops_.size() + 1, 0);
    for (const std::uint32_t region : of_) ++cells_[region];
    for (std::size_t i = 0; i < of_.size(); ++i) {
      if (of_[i] == 0) continue;
      for_neighbours(i, [&](std::size_t j) {
        if (j > i && of_[j] != of_[i]) raise(of_[i], of_[j], std::min(above_.values[i], above_.values[j]));
      });
    }
  }

  void raise(std::uint32_t a, std::uint32_t b, Height pass) {
    Height& known = passes_[a].try_emplace(b, 0).first->second;
    known = std::max(known, pass);
    passes_[b][a] = known;
  }

  Height top_of(std::uint32_t region) const { return above_.values[tops_[region - 1]]; }

  double radius_of(int trunk) const { return trunks_[static_cast<std::size_t>(trunk)].radius; }

  // Whether one of two trunks is so thin beside the other that it is a post.
  bool is_post(int a, int b) const {
    const double thin = std::min(radius_of(a), radius_of(b)), thick = std::max(radius_of(a), radius_of(b));
    return thick >= params_.post * thin;
  }

  // The trunk of two joined regions.
  int trunk_of(int a, int b) const {
    if (a < 0 || b < 0) return std::max(a, b);
    return radius_of(a) >= radius_of(b) ? a : b;
  }

  bool is_slender(std::uint32_t region) const {
    constexpr double kPi = 3.14159265358979323846;
    const double radius = std::sqrt(static_cast<double>(cells_[region]) / kPi) * params_.cell;
    return radius < params_.slender * top_of(region);
  }

  bool may_join(const Join& j) const {
    const bool a = trunk_[j.first - 1] >= 0, b = trunk_[j.second - 1] >= 0;
    if (a && b && !is_post(trunk_[j.first - 1], trunk_[j.second - 1])) return false;
    const bool part = (!a && is_slender(j.first)) || (!b && is_slender(j.second));
    const double pass = a || b ? params_.pass_with_trunk : params_.pass_without_trunk;
    return j.share >= (part ? params_.pass_of_slender : pass);
  }

  void offer(std::uint32_t a, std::uint32_t b, Height pass) {
    const Height lower = std::max(1, std::min(top_of(a), top_of(b)));
    const Join join{static_cast<double>(pass) / static_cast<double>(lower), std::min(a, b), std::max(a, b)};
    if (may_join(join)) joins_.push(join);
  }

  // Joins the pair with the highest share first. An offer that is no longer true is dropped: a newer one is there.
  void join() {
    into_.resize(tops_.size() + 1);
    std::iota(into_.begin(), into_.end(), 0);
    for (std::uint32_t a = 1; a < passes_.size(); ++a)
      for (const auto& [b, pass] : passes_[a])
        if (a < b) offer(a, b, pass);
    while (!joins_.empty()) {
      const Join best = joins_.top();
      joins_.pop();
      const auto pass = passes_[best.first].find(best.second);
      if (into_[best.first] != best.first || into_[best.second] != best.second || pass == passes_[best.first].end())
        continue;
      const Height lower = std::max(1, std::min(top_of(best.first), top_of(best.second)));
      if (best.share == static_cast<double>(pass->second) / static_cast<double>(lower) && may_join(best))
        unite(best.first, best.second);
    }
  }

  // The second region becomes part of the first.
  void unite(std::uint32_t a, std::uint32_t b) {
    into_[b] = a;
    cells_[a] += cells_[b];
    trunk_[a - 1] = trunk_of(trunk_[a - 1], trunk_[b - 1]);
    if (top_of(b) > top_of(a)) tops_[a - 1] = tops_[b - 1];
    for (const auto& [other, pass] : passes_[b]) {
      passes_[other].erase(b);
      if (other != a) raise(a, other, pass);
    }
    passes_[b].clear();
    for (const auto& [other, pass] : passes_[a]) offer(a, other, pass);
  }

  CrownRegions numbered() {
    CrownRegions out;
    std::vector<std::uint32_t> number(into_.size(), 0);
    out.of.assign(of_.size(), 0);
    for (std::size_t i = 0; i < of_.size(); ++i) {
      if (of_[i] == 0) continue;
      std::uint32_t root = of_[i];
      while (into_[root] != root) root = into_[root];
      if (number[root] == 0) {
        out.regions.push_back({trunk_[root - 1], tops_[root - 1]});
        number[root] = static_cast<std::uint32_t>(out.regions.size());
      }
      out.of[i] = number[root];
    }
    return out;
  }

  const Image& above_;
  std::span<const TrunkCell> trunks_;
  const CrownParams& params_;
  std::vector<std::uint32_t> of_;
  std::vector<std::size_t> tops_;  // by region - 1
  std::vector<int> trunk_;
  std::vector<std::uint32_t> into_;
  std::vector<std::size_t> cells_;                       // by region
  std::vector<std::map<std::uint32_t, Height>> passes_;  // by region, to its neighbours
  std::priority_queue<Join> joins_;
};

}  // namespace

CrownRegions find_crowns(const Image& above, std::span<const TrunkCell> trunks, const CrownParams& params) {
  return CrownFinder(above, trunks, params).find();
}

}  // namespace ilot
