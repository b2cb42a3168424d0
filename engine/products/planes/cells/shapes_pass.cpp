// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/shapes_pass.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/store/flushed.h"
#include "kernels/core/rng.h"
#include "kernels/core/union_find.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/shapes/shape_fit.h"

namespace ilot {

struct StoredShapeTally {
  std::uint32_t shape = 0;
  ShapeTally tally;
};

namespace {

// Derived: as in join_pass.cpp.
constexpr double kAgreement = 0.5;  // root mean square distance of each part from the common shape, in epsilons
// Derived: above the rounding of float32.
constexpr double kStrictly = 1 - 1e-6;
constexpr std::uint64_t kShapeBytesPerPoint = 24;

// Shapes of different cells that are one shape.
struct Group {
  Index3 anchor;
  Shape shape;
  double epsilon = 0;
  std::uint64_t points = 0;
  std::vector<Index3> samples;
};

// A shape of one cell and its place.
struct Part {
  std::uint32_t cell = 0;
  IndexBox near;  // its box, grown by half of the connectivity
  ShapeKind kind = ShapeKind::kPlane;
  std::uint64_t points = 0;
};

struct Samples : PaddedPoints {
  std::vector<std::uint32_t> all;
};

Samples relative(const std::vector<Index3>& a, const std::vector<Index3>& b, Index3 anchor) {
  Samples s;
  for (const auto* list : {&a, &b})
    for (const Index3 p : *list)
      s.add(static_cast<float>(p.x - anchor.x), static_cast<float>(p.y - anchor.y), static_cast<float>(p.z - anchor.z));
  s.all.resize(s.size);
  std::iota(s.all.begin(), s.all.end(), 0u);
  s.pad();
  return s;
}

double rms_of(const Samples& s, std::size_t first, std::size_t count, const Shape& shape) {
  double sum = 0;
  for (std::size_t i = first; i < first + count; ++i) {
    const double d = view_of(shape, {s.x[i], s.y[i], s.z[i]}).distance;
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(count));
}

Shape moved(Shape shape, Index3 from, Index3 to) {
  shape.origin = shape.origin + Vec3{static_cast<double>(from.x - to.x), static_cast<double>(from.y - to.y),
                                     static_cast<double>(from.z - to.z)};
  return shape;
}

class Joiner {
 public:
  Joiner(const Store& store, const std::vector<Cell>& cells) {
    for (std::uint32_t c = 0; c < cells.size(); ++c) {
      first_.push_back(static_cast<std::uint32_t>(groups_.size()));
      const CellShapes found = read_cell_shapes(store, cells[c], CellPart::shapes);
      for (const CellShape& s : found.shapes) add(c, cells[c].node.min_corner(), s, found.samples);
    }
    first_.push_back(static_cast<std::uint32_t>(groups_.size()));
  }

  JoinedShapes join() {
    std::vector<std::uint32_t> parent(groups_.size());
    UnionFind sets(parent);
    for (const auto& [a, b] : near_pairs()) try_join(sets.find(a), sets.find(b), sets);
    JoinedShapes out{{}, std::vector<std::uint32_t>(groups_.size(), 0), std::move(first_)};
    for (std::uint32_t i = 0; i < groups_.size(); ++i) {
      const std::uint32_t root = sets.find(i);
      if (root == i) out.shapes.push_back({groups_[i].anchor, groups_[i].shape, groups_[i].epsilon});
      out.of_segment[i] = root == i ? static_cast<std::uint32_t>(out.shapes.size()) : out.of_segment[root];
    }
    return out;
  }

 private:
  void add(std::uint32_t cell, Index3 corner, const CellShape& s, const std::vector<std::array<std::int32_t, 3>>& all) {
    const auto place = [&](const std::array<std::int32_t, 3>& p) {
      return Index3{corner.x + p[0], corner.y + p[1], corner.z + p[2]};
    };
    parts_.push_back(
        {cell, IndexBox{place(s.min), place(s.max)}.grown((s.connectivity + 1) / 2), s.shape.kind, s.points});
    Group group{corner, s.shape, s.epsilon, s.points, {}};
    for (std::uint32_t k = 0; k < s.samples; ++k) group.samples.push_back(place(all[s.first_sample + k]));
    groups_.push_back(std::move(group));
  }

  // The pairs of shapes that are near each other, those with the most points first.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs() const {
    std::vector<std::uint32_t> order(parts_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return parts_[a].near.min.x < parts_[b].near.min.x; });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const Part &a = parts_[order[i]], &b = parts_[order[j]];
        if (b.near.min.x > a.near.max.x) break;
        if (a.kind == b.kind && a.cell != b.cell && a.near.intersects(b.near))
          pairs.emplace_back(std::min(order[i], order[j]), std::max(order[i], order[j]));
      }
    std::sort(pairs.begin(), pairs.end(), [&](const auto& p, const auto& q) {
      const std::uint64_t np = parts_[p.first].points + parts_[p.second].points;
      const std::uint64_t nq = parts_[q.first].points + parts_[q.second].points;
      return np != nq ? np > nq : p < q;
    });
    return pairs;
  }

  void try_join(std::uint32_t a, std::uint32_t b, UnionFind& sets) {
    if (a == b) return;
    if (b < a) std::swap(a, b);
    Group &first = groups_[a], &second = groups_[b];
    const Samples both = relative(first.samples, second.samples, first.anchor);
    const Shape start = first.points >= second.points ? first.shape : moved(second.shape, second.anchor, first.anchor);
    const ShapeFit fit = fit_shape(both.points(), both.all, start);
    if (!fit.valid) return;
    if (rms_of(both, 0, first.samples.size(), fit.shape) > kAgreement * first.epsilon) return;
    if (rms_of(both, first.samples.size(), second.samples.size(), fit.shape) > kAgreement * second.epsilon) return;
    sets.unite(a, b);
    first.shape = fit.shape;
    first.epsilon = std::max(first.epsilon, second.epsilon);
    first.points += second.points;
    first.samples.insert(first.samples.end(), second.samples.begin(), second.samples.end());
    decltype(second.samples)().swap(second.samples);
  }

  std::vector<Part> parts_;
  std::vector<Group> groups_;  // ordered by their first part
  std::vector<std::uint32_t> first_;
};

// The signed distance of a point from a shape divided by its epsilon; its magnitude must be at most 1.
double share_of_epsilon(const JoinedShape& j, Index3 p) {
  return view_of(j.shape, {static_cast<double>(p.x - j.anchor.x), static_cast<double>(p.y - j.anchor.y),
                           static_cast<double>(p.z - j.anchor.z)})
             .distance /
         j.epsilon;
}

void label_block(const Store& store, std::uint32_t block, const std::vector<Cell>& cells,
                 const std::vector<CellPiece>& pieces, const JoinedShapes& joined, const PassContext& context) {
  const auto codes = store.read(block, columns::kCodes);
  const auto plane = store.read(block, columns::kPlane);
  const Tile tile = store.blocks()[block].node.tile;
  std::vector<std::uint32_t> shape(codes.size(), 0);
  std::map<std::uint32_t, ShapeTally> tallies;
  for (const CellPiece& piece : pieces) {
    const CellShapes found = read_cell_shapes(store, cells[piece.cell], CellPart::labels);
    if (found.labels.empty()) continue;
    for (std::uint32_t k = 0; k < piece.slice.count; ++k) {
      const std::uint32_t label = found.labels[piece.offset + k], i = piece.slice.first + k;
      if (label == 0 || plane[i] != 0) continue;
      const Index3 p = index_of({tile, codes[i]});
      const std::uint32_t s = joined.of_segment[joined.first[piece.cell] + label - 1];
      const JoinedShape& j = joined.shapes[s - 1];
      const double d = share_of_epsilon(j, p);
      if (std::abs(d) > kStrictly - context.rounding / j.epsilon || (context.wanted && !context.wanted(p))) continue;
      shape[i] = s;
      ShapeTally& t = tallies[s];
      ++t.points;
      t.content_id += mix64(codes[i]);
      t.squared_errors += static_cast<std::uint64_t>(d * d / kErrorUnit);
      t.box.min = {std::min(t.box.min.x, p.x), std::min(t.box.min.y, p.y), std::min(t.box.min.z, p.z)};
      t.box.max = {std::max(t.box.max.x, p.x), std::max(t.box.max.y, p.y), std::max(t.box.max.z, p.z)};
    }
  }
  std::vector<StoredShapeTally> stored;
  for (const auto& [s, t] : tallies) stored.push_back({s, t});
  store.write(block, columns::kShapeTally, stored);
  store.write(block, columns::kShape, shape);
}

}  // namespace

JoinedShapes join_shapes(const Store& store, const std::vector<Cell>& cells) {
  return Joiner(store, cells).join();
}

std::vector<ShapeTally> shapes_pass(const Store& store, const std::vector<Cell>& cells, const JoinedShapes& joined,
                                    const PassContext& context) {
  const auto pieces = pieces_of_blocks(store, cells);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kShapeBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, columns::kShape)) label_block(store, block, cells, pieces[block], joined, context);
  });
  flush_pass(store, Pass::shapes);
  std::vector<ShapeTally> sums(joined.shapes.size());
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block)
    for (const auto& [shape, t] : store.read(block, columns::kShapeTally)) {
      ShapeTally& sum = sums[shape - 1];
      sum.points += t.points;
      sum.content_id += t.content_id;
      sum.squared_errors += t.squared_errors;
      sum.box.min = {std::min(sum.box.min.x, t.box.min.x), std::min(sum.box.min.y, t.box.min.y),
                     std::min(sum.box.min.z, t.box.min.z)};
      sum.box.max = {std::max(sum.box.max.x, t.box.max.x), std::max(sum.box.max.y, t.box.max.y),
                     std::max(sum.box.max.z, t.box.max.z)};
    }
  return sums;
}

}  // namespace ilot
