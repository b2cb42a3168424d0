// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/cell_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/products/roofs/faces/least_cut.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {
namespace {

using Cost = std::int64_t;
// Derived: whole numbers of square centimetres.
constexpr double kCostPerM2 = 1e4;
// Choice: gaps in a face by wet tiles or snow guards are narrower; time grows with it.
constexpr double kNearPlane = 3;  // metres around a plane's points where it is a candidate
// Choice: higher walls cost no more, so that towers stay.
constexpr double kTallestWall = 0.5;  // metres
constexpr Cost kForbidden = Cost{1} << 40;
// Choice: points within epsilon of two planes decide little.
constexpr double kForeign = 0.3;  // share of a point's area; cost of a point on another plane within epsilon
// Choice: outliers beyond a metre cost no more.
constexpr double kFar = 1;  // further shares that a point costs per metre off the plane, up to one metre
// Choice: half: such a point is vegetation as often as roof.
constexpr double kUnlabelled = 0.5;  // share of a point's area that a point without a plane can cost
constexpr int kRounds = 8;
constexpr std::size_t kMostCandidates = 1u << 18;  // of all cells together; 64 bytes each with all that belongs to them
constexpr std::uint32_t kNoCellLabel = 0xffffffffu;

// Returns true where the boxes are at most `by` apart along each axis.
bool near(const FlatBox& a, const FlatBox& b, double by) {
  return a.min.x - by <= b.max.x && b.min.x - by <= a.max.x && a.min.y - by <= b.max.y && b.min.y - by <= a.max.y;
}

// A plane that a cell may have, and its cost.
struct Candidate {
  std::uint32_t plane;
  Cost cost;
};

struct Border {
  std::uint32_t a, b;  // cells, from 0
  FlatPoint from, to;  // metres
  double length;
};

// The cells for which a plane is a candidate, and the borders of these cells.
struct Reach {
  std::vector<std::uint32_t> cells, borders;
  std::uint32_t done_at = 0;  // the last expansion
};

FlatPoint metres(Point2 p) {
  return {p.x / 1000.0, p.y / 1000.0};
}

// The rounded cost of an area of 0 or more.
Cost cost_of(double square_metres) {
  return static_cast<Cost>(square_metres * kCostPerM2 + 0.5);
}

// The share of its area that a point costs on a plane. `lean` is the length of the plane's normal whose z is 1.
double misfit(const RoofPlane& plane, double lean, Vec3 p, bool labelled, double epsilon) {
  const double gap = std::abs(p.z - plane.at(p.x, p.y)), off = gap / (lean * epsilon);
  if (!labelled) return off <= 1 ? 0 : kUnlabelled * std::min(1.0, (off - 1) / 2);
  if (off <= 1) return kForeign * off * off;
  return kForeign + (1 - kForeign) * std::min(1.0, (off - 1) / 2) + std::min(kFar, kFar * gap);
}

class Labelling {
 public:
  Labelling(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
            std::span<const std::uint32_t> cell_of_point, const CellLabelParams& params)
      : site_(site), planes_(planes), cells_(cells), params_(params) {
    find_borders();
    if (!find_candidates()) return;
    add_points(cell_of_point);
    forbid_beyond_limits();
  }

  // The result is empty where there are too many candidates.
  std::vector<std::uint32_t> solve() {
    if (candidates_.empty()) return {};
    label_.resize(cells_.regions);
    for (std::uint32_t r = 0; r < cells_.regions; ++r) label_[r] = cheapest(r);
    find_reaches();
    changed_at_.assign(cells_.regions, 1);
    node_.assign(cells_.regions, kNoCellLabel);
    bool changed = true;
    for (int round = 0; round < kRounds && changed; ++round) {
      changed = false;
      for (std::uint32_t plane = 0; plane < planes_.planes.size(); ++plane)
        if (has_changed(reaches_[plane])) changed |= expand(plane);
    }
    std::vector<std::uint32_t> labels;
    for (const std::uint32_t plane : label_) labels.push_back(plane + 1);
    return labels;
  }

 private:
  void find_borders() {
    boxes_.resize(cells_.regions, FlatBox::none());
    for (const PartitionEdge& e : cells_.edges) {
      const FlatPoint p = metres(cells_.vertices[e.from]), q = metres(cells_.vertices[e.to]);
      for (const std::uint32_t r : {e.left, e.right})
        if (r != kOutside) {
          boxes_[r - 1].add(p);
          boxes_[r - 1].add(q);
        }
      if (e.left == kOutside || e.right == kOutside) continue;
      const double length = std::sqrt((q.x - p.x) * (q.x - p.x) + (q.y - p.y) * (q.y - p.y));
      borders_.push_back({e.left - 1, e.right - 1, p, q, length});
    }
  }

  bool find_candidates() {
    std::vector<FlatBox> around(planes_.planes.size(), FlatBox::none());
    for (std::size_t i = 0; i < site_.points.size(); ++i)
      if (planes_.of_point[i] != 0) around[planes_.of_point[i] - 1].add({site_.points[i].x, site_.points[i].y});
    candidates_.resize(cells_.regions);
    std::size_t count = 0;
    for (std::uint32_t r = 0; r < cells_.regions; ++r) {
      for (double by = kNearPlane; candidates_[r].empty(); by *= 4)
        for (std::uint32_t p = 0; p < around.size(); ++p)
          if (near(around[p], boxes_[r], by)) candidates_[r].push_back({p, 0});
      count += candidates_[r].size();
      if (count <= kMostCandidates) continue;
      candidates_ = {};
      return false;
    }
    return true;
  }

  void add_points(std::span<const std::uint32_t> region) {
    const double area = planes_.step * planes_.step;
    std::vector<double> lean;  // per plane: length of the normal whose z is 1
    for (const RoofPlane& p : planes_.planes) lean.push_back(std::sqrt(1 + p.gx * p.gx + p.gy * p.gy));
    for (std::size_t i = 0; i < region.size(); ++i) {
      if (region[i] == kOutside || planes_.on_wall[i]) continue;
      const std::uint32_t own = planes_.of_point[i];
      for (Candidate& c : candidates_[region[i] - 1])
        if (c.plane + 1 != own)
          c.cost += cost_of(area *
                            misfit(planes_.planes[c.plane], lean[c.plane], site_.points[i], own != 0, planes_.epsilon));
    }
  }

  void forbid_beyond_limits() {
    const auto check = [&](std::uint32_t region, FlatPoint at) {
      if (region == kOutside) return;
      for (Candidate& c : candidates_[region - 1]) {
        const RoofPlane& plane = planes_.planes[c.plane];
        double over = too_high(plane, at, params_.limits);
        if (params_.forbid_falls) over = std::max(over, too_low(plane, at, params_.limits));
        if (over > 0) c.cost = std::max(c.cost, kForbidden + cost_of(std::min(over, 1e4)));
      }
    };
    for (const PartitionEdge& e : cells_.edges)
      for (const std::uint32_t v : {e.from, e.to}) {
        check(e.left, metres(cells_.vertices[v]));
        check(e.right, metres(cells_.vertices[v]));
      }
  }

  std::uint32_t cheapest(std::uint32_t region) const {
    const auto& c = candidates_[region];
    return std::min_element(c.begin(), c.end(), [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; })
        ->plane;
  }

  const Candidate* candidate(std::uint32_t region, std::uint32_t plane) const {
    const auto& c = candidates_[region];
    const auto at =
        std::lower_bound(c.begin(), c.end(), plane, [](const Candidate& a, std::uint32_t p) { return a.plane < p; });
    return at != c.end() && at->plane == plane ? &*at : nullptr;
  }

  Cost between(const Border& border, std::uint32_t p, std::uint32_t q) const {
    if (p == q) return 0;
    const auto gap = [&](FlatPoint at) {
      return std::min(kTallestWall, std::abs(planes_.planes[p].at(at.x, at.y) - planes_.planes[q].at(at.x, at.y)));
    };
    const double height = (gap(border.from) + gap(border.to)) / 2;
    return cost_of(border.length * (params_.border + params_.wall * height));
  }

  // Finds the cells that an expansion of each plane can change, and the borders on which that depends.
  void find_reaches() {
    reaches_.resize(planes_.planes.size());
    for (std::uint32_t r = 0; r < cells_.regions; ++r)
      for (const Candidate& c : candidates_[r]) reaches_[c.plane].cells.push_back(r);
    for (std::uint32_t b = 0; b < borders_.size(); ++b) {
      const auto &p = candidates_[borders_[b].a], &q = candidates_[borders_[b].b];
      for (const Candidate& c : p) reaches_[c.plane].borders.push_back(b);
      for (const Candidate& c : q)
        if (!candidate(borders_[b].a, c.plane)) reaches_[c.plane].borders.push_back(b);
    }
  }

  // Returns true where a cell that this expansion examines has changed since the last expansion, which left nothing to
  // gain.
  bool has_changed(const Reach& reach) const {
    return std::any_of(reach.cells.begin(), reach.cells.end(),
                       [&](std::uint32_t r) { return changed_at_[r] > reach.done_at; }) ||
           std::any_of(reach.borders.begin(), reach.borders.end(), [&](std::uint32_t b) {
             return std::max(changed_at_[borders_[b].a], changed_at_[borders_[b].b]) > reach.done_at;
           });
  }

  // Expands one plane: of all sets of cells that could take the plane, it finds the cheapest. Returns true when a cell
  // changed.
  bool expand(std::uint32_t alpha) {
    Reach& reach = reaches_[alpha];
    std::vector<std::uint32_t> movable;
    for (const std::uint32_t r : reach.cells)
      if (label_[r] != alpha) {
        node_[r] = static_cast<std::uint32_t>(movable.size());
        movable.push_back(r);
      }
    const std::vector<std::uint8_t> taken = cells_to_take(alpha, movable, reach.borders);
    for (const std::uint32_t r : movable) node_[r] = kNoCellLabel;
    bool changed = false;
    ++clock_;
    for (std::size_t i = 0; i < taken.size(); ++i)
      if (taken[i]) {
        label_[movable[i]] = alpha;
        changed_at_[movable[i]] = clock_;
        changed = true;
      }
    reach.done_at = clock_;
    return changed;
  }

  // Returns a flag per movable cell: 1 = it takes the plane. Empty: no cell does.
  std::vector<std::uint8_t> cells_to_take(std::uint32_t alpha, std::span<const std::uint32_t> movable,
                                          std::span<const std::uint32_t> borders) const {
    std::vector<Cost> gain(movable.size());  // gain of staying compared with moving
    for (std::size_t i = 0; i < movable.size(); ++i)
      gain[i] = candidate(movable[i], alpha)->cost - candidate(movable[i], label_[movable[i]])->cost;
    std::vector<CutArc> arcs;
    for (const std::uint32_t at : borders) {
      const Border& border = borders_[at];
      const std::uint32_t a = node_[border.a], b = node_[border.b];
      if (a == kNoCellLabel && b == kNoCellLabel) continue;
      const Cost stay = between(border, label_[border.a], label_[border.b]);
      const Cost only_b = between(border, label_[border.a], alpha), only_a = between(border, alpha, label_[border.b]);
      if (b == kNoCellLabel) {
        gain[a] += only_a - stay;
      } else if (a == kNoCellLabel) {
        gain[b] += only_b - stay;
      } else {
        gain[a] += only_a - stay;
        gain[b] -= only_a;
        arcs.push_back({a, b, std::max<Cost>(0, only_a + only_b - stay)});
      }
    }
    if (std::none_of(gain.begin(), gain.end(), [](Cost g) { return g < 0; })) return {};
    return least_cut(gain, arcs);
  }

  const RoofSite& site_;
  const RoofPlanes& planes_;
  const Partition& cells_;
  CellLabelParams params_;
  std::vector<FlatBox> boxes_;
  std::vector<Border> borders_;
  std::vector<std::vector<Candidate>> candidates_;  // per cell, ascending by plane
  std::vector<Reach> reaches_;                      // per plane
  std::vector<std::uint32_t> label_;                // per cell, from 0
  std::vector<std::uint32_t> node_;                 // per cell: its index among the movable ones, or kNoCellLabel
  std::vector<std::uint32_t> changed_at_;           // per cell: the expansion that changed it last
  std::uint32_t clock_ = 1;                         // counts expansions
};

}  // namespace

std::vector<std::uint32_t> label_cells(const RoofSite& site, const RoofPlanes& planes, const Partition& cells,
                                       std::span<const std::uint32_t> cell_of_point, const CellLabelParams& params) {
  return Labelling(site, planes, cells, cell_of_point, params).solve();
}

}  // namespace ilot
