// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/extend.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "kernels/core/radix_sort.h"

namespace ilot {
namespace {

constexpr int kBits = 21;  // of a coordinate of a voxel
// Choice: two planes of one bent surface that differ by more where they touch are two surfaces; a bend sharper than
// that ends at the border of the cell.
constexpr double kAgreement = 0.5;           // root mean square distance of a plane from another one, in epsilons
constexpr std::int64_t kContactPart = 1;     // planes touch in neighbouring voxels with an edge of the reach,
constexpr std::int64_t kSurfacePart = 3;     // and the surface is averaged over cubes with an edge of the reach
constexpr std::uint32_t kLeastContacts = 2;  // pairs of neighbouring voxels in which two planes touch

// Points are grouped by the voxel they are in and the label that they have before the call.
class Voxels {
 public:
  struct Group {
    std::uint64_t voxel = 0;
    std::uint32_t label = 0, begin = 0, end = 0;  // its points
    bool outside = false, inside = false;         // whether it has points outside of the cell, and inside
    double n = 0;
    Vec3 sum;
  };

  Voxels(Points points, std::span<const std::uint8_t> core, std::int64_t edge)
      : p_(points), core_(core), per_unit_(1 / static_cast<double>(edge)) {}

  void add(std::uint32_t i, std::uint32_t label) { members_.push_back({voxel_of(i), std::uint64_t{label} << 32 | i}); }

  void group() {
    sort_pairs(members_, {std::make_unique_for_overwrite<KeyValue[]>(members_.size()).get(), members_.size()});
    groups_.clear();
    for (std::uint32_t m = 0; m < members_.size(); ++m) {
      const std::uint64_t voxel = members_[m].key;
      const std::uint32_t label = static_cast<std::uint32_t>(members_[m].value >> 32), i = point(m);
      if (groups_.empty() || groups_.back().voxel != voxel || groups_.back().label != label)
        groups_.push_back({voxel, label, m, m, false, false, 0, {}});
      Group& g = groups_.back();
      g.end = m + 1;
      (core_[i] ? g.inside : g.outside) = true;
      g.n += 1;
      g.sum = g.sum + Vec3{p_.x[i], p_.y[i], p_.z[i]};
    }
    find_begins();
  }

  const std::vector<Group>& groups() const { return groups_; }
  std::uint32_t point(std::uint32_t member) const { return static_cast<std::uint32_t>(members_[member].value); }

  // Calls visit(index of group) for all groups in the 27 voxels around that of a group.
  template <class Visit>
  void around(std::size_t group, const Visit& visit) const {
    const std::uint32_t* begin = begins_.data() + std::size_t{voxel_number_[group]} * kColumns;
    for (std::size_t column = 0; column < kColumns; ++column) {
      const std::uint64_t last = groups_[group].voxel + offset(column) + 1;
      for (std::size_t g = begin[column]; g < groups_.size() && groups_[g].voxel <= last; ++g) visit(g);
    }
  }

 private:
  static constexpr std::size_t kColumns = 9;  // of three voxels each, one above the other, around a voxel

  // The difference of the keys of the middle voxel of a column and of the voxel itself; it may wrap.
  static std::uint64_t offset(std::size_t column) {
    return ((column / 3 - std::uint64_t{1}) << 2 * kBits) + ((column % 3 - std::uint64_t{1}) << kBits);
  }

  // Finds the first group of each column around each voxel. Voxels ascend, so the columns of one kind ascend too.
  void find_begins() {
    voxel_number_.resize(groups_.size());
    std::vector<std::uint64_t> voxels;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (g == 0 || groups_[g].voxel != voxels.back()) voxels.push_back(groups_[g].voxel);
      voxel_number_[g] = static_cast<std::uint32_t>(voxels.size() - 1);
    }
    begins_.resize(voxels.size() * kColumns);
    for (std::size_t column = 0; column < kColumns; ++column) {
      std::size_t g = 0;
      for (std::size_t v = 0; v < voxels.size(); ++v) {
        while (g < groups_.size() && groups_[g].voxel < voxels[v] + offset(column) - 1) ++g;
        begins_[v * kColumns + column] = static_cast<std::uint32_t>(g);
      }
    }
  }

  // Coordinates are integers. Half a unit keeps the quotient farther from the next integer than the rounding of
  // doubles.
  std::uint64_t voxel_of(std::uint32_t i) const {
    // Derived: half of what a key holds, so that coordinates of either sign are positive.
    constexpr double kMiddle = 1 << (kBits - 1);
    const auto at = [&](float v) {
      return static_cast<std::uint64_t>((static_cast<double>(v) + 0.5) * per_unit_ + kMiddle);
    };
    return at(p_.x[i]) << 2 * kBits | at(p_.y[i]) << kBits | at(p_.z[i]);
  }

  Points p_;
  std::span<const std::uint8_t> core_;
  double per_unit_;                // voxels
  std::vector<KeyValue> members_;  // voxel; label and point
  std::vector<Group> groups_;
  std::vector<std::uint32_t> voxel_number_, begins_;  // of each group; kColumns of each voxel
};

struct Pair {
  std::uint32_t winner = 0, loser = 0;  // labels; the loser has points in the cell
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

bool near_border(Points p, std::size_t i, const ExtendParams& params) {
  const auto low = static_cast<float>(params.reach), high = static_cast<float>(params.edge - params.reach);
  return p.x[i] < low || p.x[i] > high || p.y[i] < low || p.y[i] > high || p.z[i] < low || p.z[i] > high;
}

// The edge of voxels that contain points up to `part` of the reach apart. Where this is too fine for the keys of
// voxels, it is what they can hold.
std::int64_t voxel_edge(const ExtendParams& params, std::int64_t part) {
  return std::max<std::int64_t>({1, params.reach / part, (params.edge + 2 * params.reach) >> (kBits - 2)});
}

// The pairs of planes that touch across the border and can belong to one surface: they touch at a small angle, or the
// second has so few points that only its place says something, and there it is near the first.
std::vector<Pair> touching(Points points, std::span<const std::uint8_t> core, std::span<const ExtendedPlane> planes,
                           const ExtendParams& params, std::span<const std::uint32_t> label) {
  Voxels near(points, core, voxel_edge(params, kContactPart));
  for (std::uint32_t i = 0; i < points.size; ++i)
    if (label[i] != 0 && (!core[i] || near_border(points, i, params))) near.add(i, label[i]);
  near.group();
  struct Contact {
    std::uint32_t count = 0;
    double n = 0, squared = 0;  // points of the loser that touch, and their squared distances from the winner
  };
  std::map<Pair, Contact> contacts;
  for (std::size_t a = 0; a < near.groups().size(); ++a) {
    if (!near.groups()[a].inside) continue;
    const Voxels::Group& loser = near.groups()[a];
    near.around(a, [&](std::size_t g) {
      const Voxels::Group& winner = near.groups()[g];
      if (!winner.outside || winner.label == loser.label) return;
      Contact& contact = contacts[{winner.label, loser.label}];
      const double d = signed_distance(planes[winner.label - 1].plane, (1 / loser.n) * loser.sum);
      ++contact.count;
      contact.n += loser.n;
      contact.squared += loser.n * d * d;
    });
  }
  std::vector<Pair> pairs;
  for (const auto& [pair, contact] : contacts) {
    if (contact.count < kLeastContacts) continue;
    const ExtendedPlane& winner = planes[pair.winner - 1];
    const double limit = kAgreement * winner.epsilon;
    if (std::abs(dot(winner.plane.n, planes[pair.loser - 1].plane.n)) >= params.min_cos ||
        contact.squared <= contact.n * limit * limit)
      pairs.push_back(pair);
  }
  return pairs;
}

class Extender {
 public:
  Extender(Points points, std::span<const std::uint8_t> core, std::span<const ExtendedPlane> planes, double share,
           const Voxels& voxels, std::span<std::uint32_t> label)
      : p_(points),
        core_(core),
        planes_(planes),
        share_(share),
        voxels_(voxels),
        label_(label),
        seen_(voxels.groups().size(), 0) {
    for (std::uint32_t i = 0; i < voxels.groups().size(); ++i)
      if (const Voxels::Group& g = voxels.groups()[i]; g.outside) outside_.push_back({g.label, i});
    std::sort(outside_.begin(), outside_.end());
  }

  // Passes points of the loser to the winner, from the voxels where the winner has points outside of the cell.
  std::size_t extend(Pair pair) {
    ++run_;
    std::size_t moved = 0;
    std::vector<std::uint32_t> open;
    auto seed = std::lower_bound(outside_.begin(), outside_.end(), std::pair{pair.winner, std::uint32_t{0}});
    for (; seed != outside_.end() && seed->first == pair.winner; ++seed) open.push_back(seed->second);
    while (!open.empty()) {
      const std::uint32_t from = open.back();
      open.pop_back();
      voxels_.around(from, [&](std::size_t i) {
        const Voxels::Group& g = voxels_.groups()[i];
        if (g.label != pair.loser || !g.inside || seen_[i] == run_) return;
        seen_[i] = run_;
        const std::size_t passed = pass(pair, i);
        if (passed > 0) open.push_back(static_cast<std::uint32_t>(i));
        moved += passed;
      });
    }
    return moved;
  }

 private:
  // The mean place of the points of both planes in the voxels around a group.
  Vec3 surface_at(Pair pair, std::size_t group) const {
    Vec3 sum;
    double n = 0;
    voxels_.around(group, [&](std::size_t i) {
      const Voxels::Group& g = voxels_.groups()[i];
      if (g.label != pair.winner && g.label != pair.loser) return;
      sum = sum + g.sum;
      n += g.n;
    });
    return (1 / n) * sum;
  }

  std::size_t pass(Pair pair, std::size_t index) {
    const Voxels::Group& group = voxels_.groups()[index];
    const ExtendedPlane &w = planes_[pair.winner - 1], &l = planes_[pair.loser - 1];
    const double from_loser = signed_distance(l.plane, surface_at(pair, index));
    const double c = dot(w.plane.n, l.plane.n);
    std::size_t passed = 0;
    for (std::uint32_t m = group.begin; m < group.end; ++m) {
      const std::uint32_t i = voxels_.point(m);
      if (label_[i] != pair.loser || !core_[i]) continue;
      const Vec3 at{p_.x[i], p_.y[i], p_.z[i]};
      const double to_winner = signed_distance(w.plane, at);
      if (std::abs(to_winner) > w.epsilon) continue;
      // The point is moved along the normal of the loser to the surface.
      const double from_winner = to_winner - (signed_distance(l.plane, at) - from_loser) * c;
      if (!wins(pair, std::abs(from_winner), std::abs(from_loser))) continue;
      label_[i] = pair.winner;
      ++passed;
    }
    return passed;
  }

  bool wins(Pair pair, double from_winner, double from_loser) const {
    const double kept = share_ * std::min(planes_[pair.winner - 1].epsilon, planes_[pair.loser - 1].epsilon);
    if (pair.winner < pair.loser) return from_winner <= kept || from_winner <= from_loser;
    return from_loser > kept && from_winner < from_loser;
  }

  Points p_;
  std::span<const std::uint8_t> core_;
  std::span<const ExtendedPlane> planes_;
  double share_;
  const Voxels& voxels_;
  std::span<std::uint32_t> label_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
      outside_;                      // labels of groups outside of the cell, and the groups
  std::vector<std::uint32_t> seen_;  // number of the last run that came to a group
  std::uint32_t run_ = 0;
};

}  // namespace

std::size_t extend_planes(Points points, std::span<const std::uint8_t> core, std::span<const ExtendedPlane> planes,
                          const ExtendParams& params, std::span<std::uint32_t> label) {
  const std::vector<Pair> pairs = touching(points, core, planes, params, label);
  if (pairs.empty()) return 0;
  std::vector<std::uint8_t> concerned(planes.size() + 1, 0);
  for (const Pair& pair : pairs) concerned[pair.winner] = concerned[pair.loser] = 1;
  Voxels voxels(points, core, voxel_edge(params, kSurfacePart));
  for (std::uint32_t i = 0; i < points.size; ++i)
    if (concerned[label[i]]) voxels.add(i, label[i]);
  voxels.group();
  Extender extender(points, core, planes, params.share, voxels, label);
  std::size_t moved = 0;
  for (const Pair& pair : pairs) moved += extender.extend(pair);
  return moved;
}

}  // namespace ilot
