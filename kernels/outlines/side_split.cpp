// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/side_split.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: one side in ten of a building follows none of its main directions; smaller shares lose oblique walls.
constexpr double kOwnShare = 0.1;

// Sums over the first vertices of a ring, for the scatter of any stretch of it.
struct Sums {
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
};

// The scatter matrix of a stretch, with its sum of squares across a line of any direction.
struct Scatter {
  double xx, xy, yy;
  Scatter(const Sums& a, const Sums& b, double n) {
    const double x = b.x - a.x, y = b.y - a.y;
    xx = b.xx - a.xx - x * x / n;
    xy = b.xy - a.xy - x * y / n;
    yy = b.yy - a.yy - y * y / n;
  }
  double across(FlatPoint d) const { return std::max(0.0, d.y * d.y * xx - 2 * d.x * d.y * xy + d.x * d.x * yy); }
  double least() const { return std::max(0.0, (xx + yy - std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy)) / 2); }
};

class Splitter {
 public:
  Splitter(std::span<const FlatPoint> ring, std::span<const FlatPoint> axes, double sigma)
      : ring_(ring), axes_(axes), choices_(axes.size() + 1), weight_(1 / (2 * sigma * sigma)) {
    // Derived: an index among the vertices, and half the logarithm of their number for a real parameter [Rissanen
    // 1978].
    const double place = natural_log(static_cast<double>(ring.size())), parameter = place / 2;
    const double axis_choice = axes.empty() ? 0 : natural_log(static_cast<double>(axes.size()) / (1 - kOwnShare));
    price_.assign(choices_, place + parameter + axis_choice);
    price_.back() = place + 2 * parameter - (axes.empty() ? 0 : natural_log(kOwnShare));
    step_price_ = place + parameter + axis_choice;
  }

  // Returns the best sides of the ring that is cut open before vertex `start`.
  std::vector<SideSpan> solve(std::uint32_t start) {
    const std::size_t n = ring_.size();
    add_up(start);
    nodes_.assign((n + 1) * choices_, {});
    before_.assign((n + 1) * choices_, 0);
    reached_.resize(choices_);
    open_.assign(choices_, {0});
    for (std::size_t end = 1; end <= n; ++end) {
      least_ = std::numeric_limits<double>::infinity();
      for (std::size_t c = 0; c < choices_; ++c) close_sides(end, c);
      for (std::size_t c = 0; c < choices_; ++c) prune(end, c);
      for (std::size_t c = 0; c < choices_; ++c) {
        const std::size_t k = last_before(end, c);
        before_[end * choices_ + c] = nodes_[end * choices_ + k].cost + step(k, c);
      }
    }
    return traced(start);
  }

 private:
  // The best way to divide the vertices before an end, with a last side of a given choice.
  struct Node {
    double cost = std::numeric_limits<double>::infinity();
    std::uint32_t from = 0;
  };

  void add_up(std::uint32_t start) {
    const std::size_t n = ring_.size();
    FlatPoint middle;
    for (const FlatPoint p : ring_) middle = middle + (1 / static_cast<double>(n)) * p;
    sums_.assign(n + 1, {});
    for (std::size_t i = 0; i < n; ++i) {
      const FlatPoint p = ring_[(start + i) % n] - middle;
      const Sums& s = sums_[i];
      sums_[i + 1] = {s.x + p.x, s.y + p.y, s.xx + p.x * p.x, s.xy + p.x * p.y, s.yy + p.y * p.y};
    }
  }

  double misfit(std::size_t from, std::size_t end, std::size_t c) const {
    const Scatter scatter(sums_[from], sums_[end], static_cast<double>(end - from));
    return weight_ * (c < axes_.size() ? scatter.across(axes_[c]) : scatter.least());
  }

  // The price of a step, where the sides before and after an end are parallel.
  double step(std::size_t k, std::size_t c) const { return k == c && c < axes_.size() ? step_price_ : 0; }

  // The choice of the last side before `from`, where a side of choice c is next.
  std::size_t last_before(std::size_t from, std::size_t c) const {
    std::size_t best = 0;
    const auto cost = [&](std::size_t k) { return nodes_[from * choices_ + k].cost + step(k, c); };
    for (std::size_t k = 1; k < choices_; ++k)
      if (cost(k) < cost(best)) best = k;
    return best;
  }

  void close_sides(std::size_t end, std::size_t c) {
    Node& node = nodes_[end * choices_ + c];
    reached_[c].clear();
    for (const std::uint32_t from : open_[c]) {
      const double cost = before_[from * choices_ + c] + misfit(from, end, c);
      reached_[c].push_back(cost);
      if (cost + price_[c] < node.cost) node = {cost + price_[c], from};
    }
    least_ = std::min(least_, node.cost);
  }

  // Forgets beginnings of sides that can never be better than to end a side here, and adds this place as a beginning.
  void prune(std::size_t end, std::size_t c) {
    std::vector<std::uint32_t>& open = open_[c];
    std::size_t kept = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
      if (reached_[c][i] < least_ + step_price_) open[kept++] = open[i];
    open.resize(kept);
    open.push_back(static_cast<std::uint32_t>(end));
  }

  std::vector<SideSpan> traced(std::uint32_t start) const {
    const std::size_t n = ring_.size();
    std::vector<SideSpan> sides;
    std::size_t end = n, c = 0;
    for (std::size_t k = 1; k < choices_; ++k)
      if (nodes_[n * choices_ + k].cost < nodes_[n * choices_ + c].cost) c = k;
    while (end > 0) {
      const std::uint32_t from = nodes_[end * choices_ + c].from;
      sides.push_back({static_cast<std::uint32_t>((start + from) % n), static_cast<std::uint32_t>(end - from),
                       c < axes_.size() ? static_cast<std::int32_t>(c) : kOwnDirection});
      if (from > 0) c = last_before(from, c);
      end = from;
    }
    std::reverse(sides.begin(), sides.end());
    return sides;
  }

  std::span<const FlatPoint> ring_, axes_;
  std::size_t choices_;  // the axes, then a direction of its own
  double weight_, step_price_ = 0;
  std::vector<double> price_;  // per choice
  std::vector<Sums> sums_;
  std::vector<Node> nodes_;                       // per end and choice
  std::vector<double> before_;                    // per beginning and choice of the next side: the cost of all before
  double least_ = 0;                              // of the nodes at the end
  std::vector<std::vector<std::uint32_t>> open_;  // per choice: where a side may begin
  std::vector<std::vector<double>> reached_;      // per choice: the costs of these beginnings up to the end
};

// The vertex farthest from the middle of the ring, and the first of equals by position.
std::uint32_t farthest_vertex(std::span<const FlatPoint> ring) {
  FlatPoint low = ring[0], high = ring[0];
  for (const FlatPoint p : ring) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const FlatPoint middle = 0.5 * (low + high);
  std::uint32_t best = 0;
  for (std::uint32_t i = 1; i < ring.size(); ++i) {
    const double d = squared_distance(ring[i], middle), most = squared_distance(ring[best], middle);
    const bool first = ring[i].x < ring[best].x || (ring[i].x == ring[best].x && ring[i].y < ring[best].y);
    if (d > most || (d == most && first)) best = i;
  }
  return best;
}

}  // namespace

std::vector<SideSpan> split_sides(std::span<const FlatPoint> ring, std::span<const FlatPoint> axes, double sigma) {
  if (ring.empty()) return {};
  Splitter splitter(ring, axes, sigma);
  const std::vector<SideSpan> guess = splitter.solve(farthest_vertex(ring));
  std::vector<SideSpan> sides = splitter.solve(guess[guess.size() / 2].first);
  const auto first = std::min_element(sides.begin(), sides.end(),
                                      [](const SideSpan& a, const SideSpan& b) { return a.first < b.first; });
  std::rotate(sides.begin(), first, sides.end());
  return sides;
}

}  // namespace ilot
