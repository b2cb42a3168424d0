// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/least_cut.h"

#include <algorithm>

namespace ilot {
namespace {

constexpr std::uint32_t kNever = 0xffffffffu;

// One direction of an arc; the other direction is `twin`.
struct Half {
  std::uint32_t to = 0, twin = 0;
  std::int64_t residual = 0;
};

// Source and sink are stored as the excess of each node: what it still has to give (above 0) or can still take (below
// 0).
class Network {
 public:
  Network(std::span<const std::int64_t> gain, std::span<const CutArc> arcs)
      : excess_(gain.begin(), gain.end()),
        first_(gain.size() + 1, 0),
        halves_(2 * arcs.size()),
        level_(gain.size()),
        current_(gain.size()) {
    for (const CutArc& a : arcs) {
      ++first_[a.from];
      ++first_[a.to];
    }
    for (std::uint32_t end = 0, v = 0; v < first_.size(); ++v) end = first_[v] += end;  // ends, later moved to starts
    for (const CutArc& a : arcs) {
      const std::uint32_t there = --first_[a.from], back = --first_[a.to];
      halves_[there] = {a.to, back, a.capacity};
      halves_[back] = {a.from, there, 0};
    }
  }

  // Sends all the flow that can be sent, and returns which nodes can then still reach the sink.
  std::vector<std::uint8_t> sink_side() {
    while (measure_levels()) {
      std::copy(first_.begin(), first_.end() - 1, current_.begin());
      for (std::uint32_t v = 0; v < excess_.size(); ++v)
        while (excess_[v] > 0 && level_[v] != kNever && send_from(v)) {
        }
    }
    std::vector<std::uint8_t> side(excess_.size());
    for (std::size_t v = 0; v < side.size(); ++v) side[v] = level_[v] != kNever;
    return side;
  }

 private:
  // Computes for each node the number of arcs to the nearest node that can take flow. Returns true when a node that has
  // flow to give can reach such a node.
  bool measure_levels() {
    std::fill(level_.begin(), level_.end(), kNever);
    queue_.clear();
    for (std::uint32_t v = 0; v < excess_.size(); ++v)
      if (excess_[v] < 0) {
        level_[v] = 0;
        queue_.push_back(v);
      }
    bool any = false;
    for (std::size_t next = 0; next < queue_.size(); ++next) {
      const std::uint32_t v = queue_[next];
      any |= excess_[v] > 0;
      for (std::uint32_t h = first_[v]; h < first_[v + 1]; ++h) {
        const std::uint32_t u = halves_[h].to;
        if (level_[u] != kNever || halves_[halves_[h].twin].residual == 0) continue;
        level_[u] = level_[v] + 1;
        queue_.push_back(u);
      }
    }
    return any;
  }

  // Sends flow along one path down the levels. Returns false when there is no such path.
  bool send_from(std::uint32_t start) {
    path_.clear();
    std::uint32_t v = start;
    while (excess_[v] >= 0) {
      std::uint32_t& h = current_[v];
      while (h < first_[v + 1] &&
             (halves_[h].residual == 0 || level_[halves_[h].to] == kNever || level_[halves_[h].to] + 1 != level_[v]))
        ++h;
      if (h < first_[v + 1]) {
        path_.push_back(h);
        v = halves_[h].to;
      } else {  // a dead end: go back and skip the arc that led here
        if (path_.empty()) return false;
        v = halves_[halves_[path_.back()].twin].to;
        path_.pop_back();
        ++current_[v];
      }
    }
    std::int64_t amount = std::min(excess_[start], -excess_[v]);
    for (const std::uint32_t h : path_) amount = std::min(amount, halves_[h].residual);
    for (const std::uint32_t h : path_) {
      halves_[h].residual -= amount;
      halves_[halves_[h].twin].residual += amount;
    }
    excess_[start] -= amount;
    excess_[v] += amount;
    return true;
  }

  std::vector<std::int64_t> excess_;
  std::vector<std::uint32_t> first_;  // per node: its first half; one entry more than there are nodes
  std::vector<Half> halves_;
  std::vector<std::uint32_t> level_, current_;
  std::vector<std::uint32_t> queue_, path_;
};

// Reduces the network. Most nodes gain more by staying than all their arcs could cost. They stay whatever the others
// do, so their arcs become gains of the nodes at the other ends. What is left is a small network, or none.
class Core {
 public:
  Core(std::span<const std::int64_t> gain, std::span<const CutArc> arcs)
      : gain_(gain.begin(), gain.end()), arcs_(arcs.begin(), arcs.end()), open_(gain.size(), 1) {
    while (remove_decided()) {
    }
  }

  std::vector<std::uint8_t> solve() {
    std::vector<std::uint32_t> number(gain_.size(), kNever);
    std::vector<std::int64_t> gain;
    for (std::size_t v = 0; v < gain_.size(); ++v) {
      if (open_[v] == 0) continue;
      number[v] = static_cast<std::uint32_t>(gain.size());
      gain.push_back(gain_[v]);
    }
    std::vector<std::uint8_t> goes(gain_.size(), 0);
    if (gain.empty()) return goes;
    for (CutArc& a : arcs_) a = {number[a.from], number[a.to], a.capacity};
    const std::vector<std::uint8_t> side = Network(gain, arcs_).sink_side();
    for (std::size_t v = 0; v < goes.size(); ++v)
      if (open_[v] != 0) goes[v] = side[number[v]];
    return goes;
  }

 private:
  // Makes one sweep over nodes and arcs. Returns true when a node was found to stay.
  bool remove_decided() {
    outgoing_capacity_.assign(gain_.size(), 0);
    for (const CutArc& a : arcs_) outgoing_capacity_[a.from] += a.capacity;
    bool any = false;
    for (std::size_t v = 0; v < gain_.size(); ++v)
      if (open_[v] != 0 && gain_[v] >= outgoing_capacity_[v]) {
        open_[v] = 0;
        any = true;
      }
    if (!any) return false;
    std::size_t kept = 0;
    for (const CutArc& a : arcs_) {
      if (open_[a.from] == 0) {
        gain_[a.to] += a.capacity;
      } else if (open_[a.to] != 0) {
        arcs_[kept++] = a;
      }
    }
    arcs_.resize(kept);
    return true;
  }

  std::vector<std::int64_t> gain_, outgoing_capacity_;
  std::vector<CutArc> arcs_;
  std::vector<std::uint8_t> open_;
};

}  // namespace

std::vector<std::uint8_t> least_cut(std::span<const std::int64_t> gain, std::span<const CutArc> arcs) {
  return Core(gain, arcs).solve();
}

}  // namespace ilot
