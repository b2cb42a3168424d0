// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_ransac.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>
#include <optional>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/cluster_grid.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/morton.h"
#include "kernels/shapes/shape_fit.h"
#include "kernels/shapes/shape_pool.h"
#include "kernels/shapes/shape_sample.h"
#include "kernels/shapes/shape_score.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::uint64_t kBatchDraws = 1024;
constexpr std::size_t kPool = 4096;  // candidates of a kind that are kept
constexpr std::size_t kSample = std::size_t{1} << 17;
// Derived: the comment on the line.
constexpr double kLocality = 4;  // half of a cell around a point of a shape is that shape's: (1/2)^2
constexpr int kRefinements = 10;
// Choice: a start from normals is rough; starts that are off by more are lost.
constexpr double kFirstReach = 3;  // in epsilons; a start from normals is rough
// Choice: a plane with 3 % fewer points is preferred to a sphere; very flat shapes become planes.
constexpr double kSimpler = 0.97;  // share of the points for which a simpler kind is preferred
// Choice: more than for planes, since shapes touch along curves.
constexpr double kExplained = 2.0 / 3;  // share on earlier shapes that makes a fringe
// Choice: saves time; a better shape that begins with fewer points is found later or not at all.
constexpr double kWorthRefining = 0.5;  // share of the best count
// Choice: candidates are refined in the order of their counts, so that large shapes come first; small ones among dense
// plants are lost. In hedges thousands of candidates have many points in no connected component, and each costs a pass
// over the points: a cell took nine minutes without this limit.
constexpr std::uint64_t kMostFailures = 1024;  // refinements of one search that may end without a shape

constexpr std::uint32_t kNotSampled = 0xffffffffu;

// A shape and the positions of its points among the remaining points.
struct Part {
  Shape shape;
  Indices members;
};

class Search {
 public:
  Search(const OrientedPoints& points, const ShapeRansacParams& params) : points_(points), params_(params) {
    result_.label.assign(points.points.size, 0);
    Indices all(points.points.size);
    std::iota(all.begin(), all.end(), 0u);
    all_ = build_shape_index(points, all);
    grid_ = build_cluster_grid(remaining_points(), params.connectivity);
    max_radius_ = params.max_radius > 0 ? params.max_radius : 2 * all_.reach;
    needed_hits_ = -natural_log(1 - params.probability);
    rng_ = Rng(params.key);
    build_sample();
  }

  ShapeSegments run() {
    while (all_.left >= params_.min_points && failures_ < kMostFailures) {
      const std::optional<std::size_t> best = best_kind();
      const double least = params_.min_points;
      const double size = best ? std::max(least, static_cast<double>(pools_[*best].top().bound) * share_) : least;
      if (expected_hits_per_point_ * size < needed_hits_) {
        draw_batch();
      } else if (best) {
        take(*best);
      } else {
        break;
      }
    }
    return std::move(result_);
  }

 private:
  // ---- what candidates are drawn from and counted on -------------------------------------------------------------
  void build_sample() {
    const std::size_t stride = stride_for(all_.left);
    share_ = static_cast<double>(stride);
    sampled_ = stride > 1;
    if (!sampled_) return;
    Indices chosen;
    for (std::size_t i = 0; i < all_.size; ++i)
      if (!all_.is_hole(i) && mix64(all_.code[i]) % stride == 0) chosen.push_back(all_.index[i]);
    sample_ = build_shape_index(points_, chosen);  // from epoch 1 again: rescale() forgets all counts
    in_sample_.assign(points_.points.size, kNotSampled);
    for (std::uint32_t i = 0; i < sample_.size; ++i) in_sample_[sample_.index[i]] = i;
  }
  static std::size_t stride_for(std::size_t left) {
    std::size_t stride = 1;
    while (left > stride * kSample) stride *= 2;
    return stride;
  }
  const ShapeIndex& sample() const { return sampled_ ? sample_ : all_; }

  ShapeScoreParams score_params() const { return {params_.epsilon, params_.min_cos}; }

  // Half of what the smallest shape should have, because the first fit from normals is rough.
  std::uint32_t least_count() const {
    return std::max(3u, static_cast<std::uint32_t>(static_cast<double>(params_.min_points) / (4 * share_)));
  }

  // ---- draws --------------------------------------------------------------------------------------------------------
  std::optional<std::size_t> living(std::size_t begin, std::size_t end) {
    constexpr int kTries = 8;
    for (int i = 0; i < kTries; ++i) {
      const std::size_t at = begin + rng_.below(end - begin);
      if (!sample().is_hole(at)) return at;
    }
    return std::nullopt;
  }

  void draw() {
    const ShapeIndex& s = sample();
    const auto first = living(0, s.size);
    if (!first) return;
    const int level = s.first_level + static_cast<int>(rng_.below(static_cast<std::uint64_t>(s.levels)));
    const ShapeIndex::Range cell = s.cell_around(*first, level);
    const auto second = living(cell.begin, cell.end), third = living(cell.begin, cell.end);
    if (!second || !third || *second == *first || *third == *first || *second == *third) return;
    ShapeSample sample_points;
    const std::size_t at[3]{*first, *second, *third};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 n = s.normal(at[i]);
      sample_points[i] = {s.position(at[i]), (1 / norm(n)) * n};
    }
    for (int kind = 0; kind < kShapeKinds; ++kind) {
      const auto k = static_cast<ShapeKind>(kind);
      if ((params_.kinds & shape_bit(k)) == 0) continue;
      const auto shape = sample_shape(k, sample_points, params_.epsilon, params_.min_cos);
      if (!shape || shape->radius > max_radius_) continue;
      const std::uint32_t bound = bound_shape(s, *shape, score_params());
      if (bound >= least_count()) pools_[static_cast<std::size_t>(kind)].push({*shape, bound, draw_count_, 0});
    }
  }

  void draw_batch() {
    for (std::uint64_t i = 0; i < kBatchDraws; ++i) {
      ++draw_count_;
      draw();
    }
    expected_hits_per_point_ +=
        static_cast<double>(kBatchDraws) / (static_cast<double>(all_.left) * sample().levels * kLocality);
    for (ShapePool& pool : pools_) pool.prune(least_count(), kPool);
  }

  // ---- choice -------------------------------------------------------------------------------------------------------
  bool exact(const ShapePool::Candidate& c) const { return c.counted == sample().epoch; }

  void count_top(ShapePool& pool) {
    ShapePool::Candidate c = pool.pop();
    c.bound = recount_shape(sample(), c.shape, score_params(), {c.bound, c.counted}, least_count());
    c.counted = sample().epoch;
    if (c.bound >= least_count()) pool.push(std::move(c));
  }

  // Returns the pool whose top has the most points, counted exactly.
  std::optional<std::size_t> best_kind() {
    for (;;) {
      std::optional<std::size_t> best;
      for (std::size_t k = 0; k < pools_.size(); ++k)
        if (!pools_[k].empty() && (!best || ShapePool::below(pools_[*best].top(), pools_[k].top()))) best = k;
      if (!best || exact(pools_[*best].top())) return best;
      count_top(pools_[*best]);
    }
  }

  // ---- refinement ---------------------------------------------------------------------------------------------------
  Points remaining_points() const { return {all_.x.data(), all_.y.data(), all_.z.data(), all_.size}; }

  // Returns the connected component that shares most points with `like`, or the largest when `like` is empty.
  Indices part_of(const Indices& members, const Indices& like) {
    const Clusters clusters = grid_.empty() ? euclidean_clusters(remaining_points(), members, params_.connectivity)
                                            : grid_clusters(grid_, remaining_points(), members, scratch_);
    Indices votes(clusters.count, 0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      while (at < like.size() && like[at] < members[i]) ++at;
      votes[clusters.id[i]] += like.empty() || (at < like.size() && like[at] == members[i]);
    }
    if (votes.empty()) return {};
    const auto chosen = static_cast<std::uint32_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
    Indices part;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (clusters.id[i] == chosen) part.push_back(members[i]);
    return part;
  }

  bool allowed(const Shape& s) const { return s.radius <= max_radius_; }

  // Refines a shape. A part with fewer than min_points may be any part of the shape.
  Part refine(const Shape& start) {
    ShapeScoreParams wide = score_params();
    wide.epsilon *= kFirstReach;
    Part part{start, points_on_shape(all_, start, wide)};
    if (part.members.size() < params_.min_points / 2) return part;  // too few to grow
    part.members = part_of(part.members, {});
    const Indices seed = part.members;
    for (int round = 0; round < kRefinements && part.members.size() >= params_.min_points / 2; ++round) {
      const ShapeFit fit = fit_shape(remaining_points(), part.members, part.shape);
      if (!fit.valid || !allowed(fit.shape)) break;
      auto around = Box3<Vec3>::none();
      for (const std::uint32_t i : part.members) around.add(all_.position(i));
      Indices next =
          points_on_shape(all_, fit.shape, score_params(), around.grown(static_cast<double>(params_.connectivity)));
      if (next.size() < params_.min_points) break;
      part.shape = fit.shape;
      const bool converged = next == part.members;
      part.members = std::move(next);
      if (converged) break;
    }
    // Whichever round ended the loop, the members are those of the shape that is kept.
    std::erase_if(part.members, [&](std::uint32_t i) {
      const ShapeView v = view_of(part.shape, all_.position(i));
      return std::abs(v.distance) > params_.epsilon || std::abs(dot(v.normal, all_.normal(i))) < params_.min_cos;
    });
    if (part.members.size() >= params_.min_points) part.members = part_of(part.members, seed);
    return part;
  }

  // Whether a point is on a shape that was found before, and its normal does not agree.
  bool is_explained(std::uint32_t i, std::span<const std::size_t> near) const {
    const Vec3 p = all_.position(i);
    return std::any_of(near.begin(), near.end(), [&](std::size_t s) {
      if (!extents_[s].contains(p)) return false;
      const ShapeView v = view_of(result_.shapes[s].shape, p);
      return std::abs(v.distance) <= params_.epsilon &&
             std::abs(dot(v.normal, all_.normal(i))) < params_.min_cos;  // else another part of the same shape
    });
  }

  bool is_edge_strip(const Indices& members, const Box3<Vec3>& extent) const {
    std::vector<std::size_t> near;  // shapes found before
    for (std::size_t s = 0; s < extents_.size(); ++s)
      if (extents_[s].intersects(extent)) near.push_back(s);
    const double enough = kExplained * static_cast<double>(members.size());
    std::size_t explained = 0, left = members.size();
    for (const std::uint32_t i : members) {
      if (static_cast<double>(explained + left) <= enough || static_cast<double>(explained) > enough) break;
      explained += is_explained(i, near);
      --left;
    }
    return static_cast<double>(explained) > enough;
  }

  // ---- taking -------------------------------------------------------------------------------------------------------
  void take(std::size_t best) {
    const auto enough = static_cast<std::uint32_t>(kWorthRefining * pools_[best].top().bound);
    Part chosen;
    for (std::size_t k = 0; k < pools_.size(); ++k) {
      while (!pools_[k].empty() && !exact(pools_[k].top())) count_top(pools_[k]);
      if (pools_[k].empty() || pools_[k].top().bound < enough) continue;
      ShapePool::Candidate c = pools_[k].pop();
      Part part = refine(c.shape);
      if (part.members.size() < params_.min_points) {  // the candidate had a higher bound than it has points
        ++failures_;
        continue;
      }
      c = {part.shape, bound_shape(sample(), part.shape, score_params()), c.draw, 0};
      pools_[k].push(std::move(c));  // other parts of the same shape may remain
      if (kSimpler * static_cast<double>(part.members.size()) > static_cast<double>(chosen.members.size()))
        chosen = std::move(part);
    }
    if (!chosen.members.empty()) keep(chosen);
  }

  void keep(const Part& part) {
    auto extent = Box3<Vec3>::none();
    for (const std::uint32_t i : part.members) extent.add(all_.position(i));
    if (!is_edge_strip(part.members, extent)) {
      double squares = 0;
      const auto label = static_cast<std::uint32_t>(result_.shapes.size() + 1);
      for (const std::uint32_t i : part.members) {
        const double d = view_of(part.shape, all_.position(i)).distance;
        squares += d * d;
        result_.label[all_.index[i]] = label;
      }
      result_.shapes.push_back({part.shape, std::sqrt(squares / static_cast<double>(part.members.size())),
                                static_cast<std::uint32_t>(part.members.size())});
      extents_.push_back(extent.grown(static_cast<double>(params_.connectivity)));
    }
    remove(part.members);
  }

  void remove(const Indices& members) {
    if (sampled_) {
      Indices sampled;
      for (const std::uint32_t i : members)
        if (const std::uint32_t at = in_sample_[all_.index[i]]; at != kNotSampled) sampled.push_back(at);
      std::sort(sampled.begin(), sampled.end());
      take_out(sample_, sampled);
    }
    take_out(all_, members, !sampled_);  // candidates are counted on the sample where there is one
    if (all_.left < all_.size / 2) compact();
    if (stride_for(all_.left) != static_cast<std::size_t>(share_)) {
      build_sample();
      for (ShapePool& pool : pools_) rescale(pool);
    }
  }

  void compact() {
    Indices left, bin_of(grid_.empty() ? 0 : points_.points.size), bins;
    for (std::size_t i = 0; i < all_.size; ++i) {
      if (all_.is_hole(i)) continue;
      left.push_back(all_.index[i]);
      if (!grid_.empty()) bin_of[all_.index[i]] = grid_.bin[i];
    }
    all_ = build_shape_index(points_, left, all_.epoch + 1);  // counts round anew
    if (grid_.empty()) return;
    for (const std::uint32_t i : all_.index) bins.push_back(bin_of[i]);
    grid_ = subset_grid(grid_, bins);
  }

  // Bounds on one sample are not valid for another.
  void rescale(ShapePool& pool) {
    ShapePool fresh;
    while (!pool.empty()) {
      ShapePool::Candidate c = pool.pop();
      c.bound = bound_shape(sample(), c.shape, score_params());
      c.counted = 0;
      fresh.push(std::move(c));
    }
    pool = std::move(fresh);
  }

  OrientedPoints points_;
  ShapeRansacParams params_;
  ShapeIndex all_, sample_;
  Indices in_sample_;  // per point of the caller: its position in the sample
  ClusterGrid grid_;   // of all_
  ClusterScratch scratch_;
  bool sampled_ = false;
  double share_ = 1;  // points that one point of the sample represents
  double max_radius_ = 0;
  Rng rng_{0};
  std::array<ShapePool, kShapeKinds> pools_;
  std::uint64_t draw_count_ = 0, failures_ = 0;
  double needed_hits_ = 0;
  double expected_hits_per_point_ = 0;  // sum over draws of the chance to hit a shape, per point of that shape
  ShapeSegments result_;
  std::vector<Box3<Vec3>> extents_;  // of the shapes, grown by the connectivity
};

}  // namespace

ShapeSegments ransac_shapes(const OrientedPoints& points, const ShapeRansacParams& params) {
  assert(params.min_points >= 3);
  if (points.nx == nullptr) return {std::vector<std::uint32_t>(points.points.size, 0), {}};
  return Search(points, params).run();
}

}  // namespace ilot
