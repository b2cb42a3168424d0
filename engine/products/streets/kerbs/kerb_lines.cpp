// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/kerbs/kerb_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

constexpr std::size_t kNone = SIZE_MAX;
// Choice: kerbs of a street turn by less over a link; those of crossings have radii of half a metre and more.
constexpr double kLeastCosine = 0.85;  // of the angle between the edges of linked places
// Choice: 19 degrees, about as much as an edge turns (kLeastCosine); tighter curves break a line.
constexpr double kMostAside = 0.35;  // of the way to the next place; 19 degrees
// Derived: two bins of the search for an edge (StepFit) are a sixteenth of the window each.
constexpr double kSlack = 0.1;  // of the radius of a window; how far a place may be off its edge
// Choice: a dropped kerb rises over half a metre or more, two windows.
constexpr double kHeightStep = 0.05;  // metres; the height of a step changes by less from place to place
// Choice: cars hide straight kerbs; the way across a side street is no kerb.
constexpr double kBridgeCosine = 0.95, kBridgeAside = 0.1;
// Choice: a tenth of what a plan of a street at 1:500 shows; larger values flatten curves.
constexpr double kSameVertex = 0.01;  // metres; a vertex that is nearer to the line without it is left out

struct Grid {
  double side = 1;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> cells = {};

  std::int64_t cell(double v) const { return static_cast<std::int64_t>(std::floor(v / side)); }
  void add(double x, double y, std::size_t i) { cells[{cell(x), cell(y)}].push_back(i); }
  template <class Take>
  void near(double x, double y, const Take& take) const {
    for (std::int64_t v = cell(y) - 1; v <= cell(y) + 1; ++v)
      for (std::int64_t u = cell(x) - 1; u <= cell(x) + 1; ++u)
        if (const auto found = cells.find({u, v}); found != cells.end())
          for (const std::size_t i : found->second) take(i);
  }
};

// The way from one place to another along the first one's edge. The edge goes on with the upper surface on its left.
struct Way {
  double along = 0, aside = 0, length = 0;
};

Way way(const StepPoint& from, double x, double y) {
  const double dx = x - from.x, dy = y - from.y;
  return {dx * from.up_y - dy * from.up_x, dx * from.up_x + dy * from.up_y, norm(FlatPoint{dx, dy})};
}

class KerbLinker {
 public:
  KerbLinker(std::span<const StepPoint> places, const KerbLineParams& params) : places_(places), params_(params) {}

  std::vector<KerbLine> link() {
    choose();
    std::vector<KerbLine> lines;
    for (const std::vector<std::size_t>& chain : chains())
      if (length_of(chain) >= params_.least_length) lines.push_back(smoothed(chain));
    return bridged(lines);
  }

 private:
  bool continues(const StepPoint& a, const StepPoint& b) const {
    const double cosine = a.up_x * b.up_x + a.up_y * b.up_y;
    const double step = std::max(kHeightStep, 0.5 * std::min(a.height, b.height));
    return cosine >= kLeastCosine && std::abs(a.height - b.height) <= step && std::abs(a.z - b.z) <= 0.3;
  }

  // For each place the nearest that continues it ahead and behind.
  void choose() {
    const double reach = 2 * params_.radius, least = 0.4 * params_.spacing, slack = kSlack * params_.radius;
    Grid grid{reach, {}};
    for (std::size_t i = 0; i < places_.size(); ++i) grid.add(places_[i].x, places_[i].y, i);
    next_.assign(places_.size(), kNone), before_ = next_;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      double ahead = reach, behind = reach;
      const StepPoint& p = places_[i];
      grid.near(p.x, p.y, [&](std::size_t j) {
        const StepPoint& q = places_[j];
        const Way w = way(p, q.x, q.y), back = way(q, p.x, p.y);
        const double most = kMostAside * w.length + slack;
        if (j == i || w.length < least || std::abs(w.aside) > most || std::abs(back.aside) > most || !continues(p, q))
          return;
        const double cost = w.length + 2 * (std::abs(w.aside) + std::abs(back.aside));
        if (w.along > 0 && cost < ahead) ahead = cost, next_[i] = j;
        if (w.along < 0 && cost < behind) behind = cost, before_[i] = j;
      });
    }
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (next_[i] != kNone && before_[next_[i]] != i) next_[i] = kNone;
    std::vector<std::uint8_t> has(places_.size(), 0);
    for (const std::size_t n : next_)
      if (n != kNone) has[n] = 1;
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (has[i] == 0) before_[i] = kNone;
  }

  std::vector<std::vector<std::size_t>> chains() const {
    std::vector<std::vector<std::size_t>> all;
    std::vector<std::uint8_t> used(places_.size(), 0);
    const auto follow = [&](std::size_t first) {
      std::vector<std::size_t> chain;
      for (std::size_t i = first; i != kNone && used[i] == 0; i = next_[i]) used[i] = 1, chain.push_back(i);
      if (chain.size() > 2) all.push_back(std::move(chain));
    };
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (before_[i] == kNone) follow(i);
    for (std::size_t i = 0; i < places_.size(); ++i)
      if (used[i] == 0) follow(i);  // rings
    return all;
  }

  double length_of(const std::vector<std::size_t>& chain) const {
    double length = 0;
    for (std::size_t i = 1; i < chain.size(); ++i)
      length +=
          norm(FlatPoint{places_[chain[i]].x - places_[chain[i - 1]].x, places_[chain[i]].y - places_[chain[i - 1]].y});
    return length;
  }

  // The value at s of the weighted straight line through values over a way; weights fall to 0 at the ends of it.
  static double value_at(const std::vector<double>& s, const std::vector<double>& v, std::size_t i, double reach) {
    double n = 0, a = 0, aa = 0, b = 0, ab = 0;
    const auto add = [&](std::size_t k) {
      const double d = s[k] - s[i], u = std::abs(d) / reach;
      const double w = (1 - u * u) * (1 - u * u);
      n += w, a += w * d, aa += w * d * d, b += w * v[k], ab += w * d * v[k];
    };
    for (std::size_t k = i; k < s.size() && s[k] - s[i] < reach; ++k) add(k);
    for (std::size_t k = i; k-- > 0 && s[i] - s[k] < reach;) add(k);
    const double det = n * aa - a * a;
    return det > 1e-9 * n * n * reach * reach ? (b * aa - a * ab) / det : b / n;
  }

  KerbLine smoothed(const std::vector<std::size_t>& chain) const {
    std::vector<double> s, x, y, z, h;
    for (const std::size_t i : chain) {
      const StepPoint& p = places_[i];
      s.push_back(s.empty() ? 0 : s.back() + norm(FlatPoint{p.x - x.back(), p.y - y.back()}));
      x.push_back(p.x), y.push_back(p.y), z.push_back(p.z), h.push_back(p.height);
    }
    KerbLine line;
    const double reach = std::max(params_.smoothing, 2 * params_.radius);
    for (std::size_t i = 0; i < s.size(); ++i)
      line.vertices.push_back(
          {value_at(s, x, i, reach), value_at(s, y, i, reach), value_at(s, z, i, reach), value_at(s, h, i, reach)});
    line.vertices = simplified(line.vertices);
    return line;
  }

  // How far a vertex is from the chord between two others, in plan, height and height of the step: the largest.
  static double off_chord(const KerbVertex& a, const KerbVertex& b, const KerbVertex& v) {
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double t = square > 0 ? std::clamp(((v.x - a.x) * dx + (v.y - a.y) * dy) / square, 0.0, 1.0) : 0;
    return std::max({norm(FlatPoint{v.x - a.x - t * dx, v.y - a.y - t * dy}), std::abs(v.z - a.z - t * (b.z - a.z)),
                     std::abs(v.height - a.height - t * (b.height - a.height))});
  }

  // Leaves out vertices that are near the line through the others [Douglas and Peucker 1973].
  static std::vector<KerbVertex> simplified(const std::vector<KerbVertex>& all) {
    std::vector<std::uint8_t> kept(all.size(), 0);
    kept.front() = kept.back() = 1;
    std::vector<std::pair<std::size_t, std::size_t>> open{{0, all.size() - 1}};
    while (!open.empty()) {
      const auto [from, to] = open.back();
      open.pop_back();
      double most = kSameVertex;
      std::size_t worst = kNone;
      for (std::size_t i = from + 1; i < to; ++i)
        if (const double d = off_chord(all[from], all[to], all[i]); d > most) most = d, worst = i;
      if (worst == kNone) continue;
      kept[worst] = 1;
      open.emplace_back(from, worst), open.emplace_back(worst, to);
    }
    std::vector<KerbVertex> out;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (kept[i] != 0) out.push_back(all[i]);
    return out;
  }

  // The end of a line (or its start), with the edge's direction there.
  static StepPoint end_of(const KerbLine& line, bool last) {
    const std::vector<KerbVertex>& v = line.vertices;
    const KerbVertex& at = last ? v.back() : v.front();
    // The direction over the last metre or more, as the last link alone is short.
    std::size_t other = last ? v.size() - 1 : 0;
    while ((last ? other > 0 : other + 1 < v.size()) && norm(FlatPoint{v[other].x - at.x, v[other].y - at.y}) < 1)
      other = last ? other - 1 : other + 1;
    double dx = last ? at.x - v[other].x : v[other].x - at.x, dy = last ? at.y - v[other].y : v[other].y - at.y;
    const double length = std::max(1e-9, norm(FlatPoint{dx, dy}));
    dx /= length, dy /= length;
    return {at.x, at.y, at.z, -dy, dx, at.height};
  }

  // The way from the end of one line to the start of another that continues it.
  struct Bridge {
    double length;
    std::size_t from, to;
  };

  std::vector<Bridge> bridges_between(const std::vector<KerbLine>& lines) const {
    std::vector<Bridge> bridges;
    Grid grid{params_.longest_bridge, {}};
    for (std::size_t i = 0; i < lines.size(); ++i)
      grid.add(lines[i].vertices.front().x, lines[i].vertices.front().y, i);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const StepPoint end = end_of(lines[i], true);
      grid.near(end.x, end.y, [&](std::size_t j) {
        if (j == i) return;
        const StepPoint start = end_of(lines[j], false);
        const Way w = way(end, start.x, start.y), back = way(start, end.x, end.y);
        const double most = kBridgeAside * w.length + 0.25 * params_.radius;
        const bool near = w.along > 0 && w.length <= params_.longest_bridge;
        if (!near || std::abs(w.aside) > most || std::abs(back.aside) > most) return;
        if (end.up_x * start.up_x + end.up_y * start.up_y >= kBridgeCosine) bridges.push_back({w.length, i, j});
      });
    }
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) {
      return std::tie(a.length, a.from, a.to) < std::tie(b.length, b.from, b.to);
    });
    return bridges;
  }

  // Lines that continue each other within two windows are one: both windows saw the edge. Over longer gaps they are
  // connected by lines that are not seen.
  std::vector<KerbLine> bridged(const std::vector<KerbLine>& lines) const {
    std::vector<std::size_t> after(lines.size(), kNone);
    std::vector<std::uint8_t> left(lines.size(), 0), entered(lines.size(), 0), joined(lines.size(), 0);
    std::vector<KerbLine> all, hidden;
    for (const Bridge& b : bridges_between(lines)) {
      if (left[b.from] != 0 || entered[b.to] != 0) continue;
      left[b.from] = entered[b.to] = 1;
      if (b.length <= 2 * params_.radius)
        after[b.from] = b.to, joined[b.to] = 1;
      else
        hidden.push_back({false, {lines[b.from].vertices.back(), lines[b.to].vertices.front()}});
    }
    std::vector<std::uint8_t> used(lines.size(), 0);
    const auto follow = [&](std::size_t first) {
      KerbLine line;
      for (std::size_t i = first; i != kNone && used[i] == 0; i = after[i]) {
        used[i] = 1;
        line.vertices.insert(line.vertices.end(), lines[i].vertices.begin(), lines[i].vertices.end());
      }
      if (!line.vertices.empty()) all.push_back(std::move(line));
    };
    for (std::size_t i = 0; i < lines.size(); ++i)
      if (joined[i] == 0) follow(i);
    for (std::size_t i = 0; i < lines.size(); ++i) follow(i);  // rings
    all.insert(all.end(), hidden.begin(), hidden.end());
    return all;
  }

  std::span<const StepPoint> places_;
  const KerbLineParams& params_;
  std::vector<std::size_t> next_, before_;
};

}  // namespace

std::vector<KerbLine> link_kerbs(std::span<const StepPoint> places, const KerbLineParams& params) {
  return KerbLinker(places, params).link();
}

}  // namespace ilot
