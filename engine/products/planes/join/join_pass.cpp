// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/join_pass.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/pass/pass.h"
#include "engine/products/planes/cells/block_cells.h"
#include "engine/store/flushed.h"
#include "engine/store/sorted_columns.h"
#include "kernels/core/parallel_sort.h"
#include "kernels/core/union_find.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/knn.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 60;
constexpr int kNearest = 24;
constexpr std::uint32_t kLeastContacts = 2;
// Derived: epsilon is 3.5 standard deviations, so half of it is 1.75 of them: a plane that is off by its noise still
// joins.
constexpr double kAgreement = 0.5;  // root mean square distance of each part from the common plane, in epsilons

// The labelled points near the border of their cell: all points in reach of a point that may itself reach another cell.
// With fewer points, the nearest one would depend on the widest reach in the block, and so on the blocks.
struct BorderPoints : PaddedPoints {
  std::vector<std::uint32_t> segment;  // cell plane of each point
  std::vector<std::uint32_t> own;      // positions of the points that belong to the block
};

BorderPoints border_points(const View& view, const std::vector<std::uint32_t>& labels, PointRange own,
                           const std::vector<Cell>& cells, const CellPlanes& planes, std::int64_t reach) {
  BorderPoints border;
  std::uint32_t last_cell = UINT32_MAX;  // the points of a cell are consecutive
  IndexBox box;
  for (std::uint32_t i = 0; i < view.size; ++i) {
    if (labels[i] == 0) continue;
    const std::uint32_t segment = labels[i] - 1;
    if (planes.cell_of[segment] != last_cell) {
      last_cell = planes.cell_of[segment];
      box = cells[last_cell].node.box();
    }
    const Index3 p = view.position(i);
    const std::int64_t clear = std::min(
        {p.x - box.min.x, box.max.x - p.x, p.y - box.min.y, box.max.y - p.y, p.z - box.min.z, box.max.z - p.z});
    if (clear >= 2 * reach) continue;
    if (clear < reach && i >= own.begin && i < own.end)
      border.own.push_back(static_cast<std::uint32_t>(border.segment.size()));
    border.add(view.x[i], view.y[i], view.z[i]);
    border.segment.push_back(segment);
  }
  border.pad();
  return border;
}

std::vector<Contact> counted(std::vector<std::uint64_t> pairs) {
  std::sort(pairs.begin(), pairs.end());
  std::vector<Contact> contacts;
  for (const std::uint64_t pair : pairs) {
    const auto a = static_cast<std::uint32_t>(pair >> 32);
    const auto b = static_cast<std::uint32_t>(pair);
    if (contacts.empty() || contacts.back().a != a || contacts.back().b != b) contacts.push_back({a, b, 0});
    ++contacts.back().count;
  }
  return contacts;
}

// Adds pairs of planes: the plane of a border point, and a plane of another cell that has points among the nearest
// neighbours of the point.
void add_pairs(std::uint32_t own, std::span<const std::uint32_t> neighbours, const BorderPoints& border,
               const CellPlanes& planes, std::vector<std::uint64_t>& pairs) {
  std::uint32_t seen[kNearest];
  int count = 0;
  for (const std::uint32_t j : neighbours) {
    if (j == kNoNeighbour) break;
    const std::uint32_t other = border.segment[j];
    if (planes.cell_of[other] == planes.cell_of[own] || std::find(seen, seen + count, other) != seen + count) continue;
    seen[count++] = other;
    pairs.push_back(static_cast<std::uint64_t>(std::min(own, other)) << 32 | std::max(own, other));
  }
}

std::vector<Contact> block_contacts(const Store& store, std::uint32_t block, const BlockCells& own_cells,
                                    const std::vector<Cell>& cells, const CellPlanes& planes) {
  const std::int64_t reach = own_cells.widest_connectivity;
  const Block& b = store.blocks()[block];
  const View view = load_view(store, b.box.grown(reach), b.node.min_corner());
  const auto labels = load_column(store, view, columns::kSegment);
  const BorderPoints border = border_points(view, labels, range_of_block(view, block), cells, planes, reach);
  const NeighbourIndex index = build_neighbour_index(border.points());
  const auto reach_of = [&](std::uint32_t i) { return planes.cells[planes.cell_of[border.segment[i]]].connectivity; };
  constexpr std::size_t kBatch = 256;
  std::vector<std::uint32_t> neighbours(kBatch * kNearest);
  std::vector<std::int64_t> reach2(kBatch);
  std::vector<std::uint64_t> pairs;
  for (std::size_t begin = 0; begin < border.own.size();) {
    const std::int64_t r = reach_of(border.own[begin]);
    std::size_t end = begin;
    while (end < border.own.size() && end - begin < kBatch && reach_of(border.own[end]) == r) ++end;
    const auto batch = std::span(border.own).subspan(begin, end - begin);
    const auto lists = std::span(neighbours).first(batch.size() * kNearest);
    knn(index, batch, {kNearest, r * r}, lists, std::span(reach2).first(batch.size()));
    for (std::size_t i = 0; i < batch.size(); ++i)
      add_pairs(border.segment[batch[i]], lists.subspan(i * kNearest, kNearest), border, planes, pairs);
    begin = end;
  }
  return counted(std::move(pairs));
}

struct Group {
  Moments moments;  // relative to the anchor of the first plane of the group
  double epsilon = 0;
  std::uint32_t min_points = 3;
};

Index3 minus(Index3 a, Index3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

class Joiner {
 public:
  Joiner(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes, const JoinParams& params)
      : cells_(cells), planes_(planes), params_(params), parents_(planes.cell_of.size()), sets_(parents_) {
    groups_.reserve(planes.cell_of.size());
    normals_.reserve(planes.cell_of.size());
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      for (const CellPlane& p : read_cell_planes(store, cells[c])) {
        groups_.push_back({p.moments, planes.cells[c].epsilon, planes.cells[c].min_points});
        normals_.push_back(p.plane.n);
      }
    }
  }

  void try_join(const Contact& contact) {
    std::uint32_t a = sets_.find(contact.a), b = sets_.find(contact.b);
    if (a == b) return;
    if (b < a) std::swap(a, b);
    if (std::abs(dot(normals_[contact.a], normals_[contact.b])) < params_.min_cos) return;
    const Moments moved = shifted(groups_[b].moments, minus(anchor(b), anchor(a)));
    Moments both = groups_[a].moments;
    both.add(moved);
    const PlaneFit fit = fit_plane(both);
    if (!fit.unique) return;
    if (rms_to_plane(groups_[a].moments, fit.plane) > kAgreement * groups_[a].epsilon) return;
    if (rms_to_plane(moved, fit.plane) > kAgreement * groups_[b].epsilon) return;
    sets_.unite(a, b);
    groups_[a] = {both, std::max(groups_[a].epsilon, groups_[b].epsilon),
                  std::min(groups_[a].min_points, groups_[b].min_points)};
  }

  JoinedPlanes result() {
    JoinedPlanes r;
    r.of_segment.assign(planes_.cell_of.size(), 0);
    for (std::uint32_t i = 0; i < planes_.cell_of.size(); ++i) {
      const std::uint32_t root = sets_.find(i);
      if (root == i) {
        const PlaneFit fit = fit_plane(groups_[i].moments);
        if (!fit.unique || groups_[i].moments.n < groups_[i].min_points) continue;
        r.planes.push_back({anchor(i), fit.plane, groups_[i].epsilon, groups_[i].min_points,
                            static_cast<std::uint64_t>(groups_[i].moments.n)});
        r.of_segment[i] = static_cast<std::uint32_t>(r.planes.size());
      } else {
        r.of_segment[i] = r.of_segment[root];  // a root has a smaller index than its members
      }
    }
    return r;
  }

 private:
  Index3 anchor(std::uint32_t plane) const { return cells_[planes_.cell_of[plane]].node.min_corner(); }

  const std::vector<Cell>& cells_;
  const CellPlanes& planes_;
  JoinParams params_;
  std::vector<std::uint32_t> parents_;
  UnionFind sets_;
  std::vector<Group> groups_;
  std::vector<Vec3> normals_;  // normals of the cell planes
};

// Sums the contacts of each pair over all blocks, for some planes at a time.
std::vector<Contact> merged_contacts(const Store& store) {
  constexpr std::uint64_t kPlanesTogether = 1 << 12;
  SortedColumns parts(store, columns::kContacts, [](const Contact& c) { return std::uint64_t{c.a}; });
  std::vector<Contact> merged;
  while (parts.next() != parts.kEnd) {
    std::vector<Contact> some = parts.until(parts.next() + kPlanesTogether);
    parallel_sort(some, [](const Contact& a, const Contact& b) {
      return std::tie(a.a, a.b, a.count) < std::tie(b.a, b.b, b.count);
    });
    for (const Contact& c : some) {
      const bool same = !merged.empty() && merged.back().a == c.a && merged.back().b == c.b;
      if (!same) merged.push_back({c.a, c.b, 0});
      merged.back().count += c.count;
    }
  }
  return merged;
}

}  // namespace

std::vector<Contact> contact_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                                  const PassContext& context) {
  const std::vector<BlockCells> block_cells = cells_of_blocks(store, cells, planes);
  std::vector<PassTask> tasks;
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b)
    tasks.push_back({points_around(store, b, block_cells[b]) * kBytesPerPoint, store.blocks()[b].points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, columns::kContacts)) {
      const auto contacts = block_contacts(store, block, block_cells[block], cells, planes);
      store.write(block, columns::kContacts, contacts);
    }
    context.advance(store.blocks()[block].points / 2);  // the other half follows with the labels
  });
  flush_pass(store, Pass::contacts);
  return merged_contacts(store);
}

JoinedPlanes join_planes(const Store& store, const std::vector<Cell>& cells, const CellPlanes& planes,
                         std::vector<Contact> contacts, const JoinParams& params) {
  parallel_sort(contacts, [](const Contact& a, const Contact& b) {
    return a.count != b.count ? a.count > b.count : std::tie(a.a, a.b) < std::tie(b.a, b.b);
  });
  Joiner joiner(store, cells, planes, params);
  for (const Contact& c : contacts)
    if (c.count >= kLeastContacts) joiner.try_join(c);
  return joiner.result();
}

}  // namespace ilot
