// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/ransac.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/remaining_points.h"

namespace ilot {
namespace {

constexpr int kFirstWindow = 16;  // points; doubled for each of the levels
constexpr int kLevels = 7;        // windows of 16 to 1,024 points
// Derived: the comment on the line.
constexpr double kLocality = 4;              // half of a window around a point of a plane is that plane's: (1/2)^2
constexpr std::size_t kBatch = 64;           // hypotheses scored together
constexpr std::uint64_t kBatchDraws = 2048;  // draws after which a batch is scored even if not full
constexpr std::size_t kPool = 512;           // candidates kept between planes
constexpr std::size_t kSample = 1 << 14;     // points on which candidates are scored while more remain
constexpr int kRefinements = 10;
// Derived: a majority.
constexpr double kExplained = 0.5;  // share of a set within epsilon of an earlier plane that makes it a fringe

// Hypotheses and the number of points of the sample that each has now. Ties go to the earlier draw.
struct Pool {
  std::vector<PlaneHypothesis> planes;
  std::vector<std::uint32_t> counts;
  std::vector<std::uint64_t> draws;

  bool better(std::size_t a, std::size_t b) const {
    return counts[a] != counts[b] ? counts[a] > counts[b] : draws[a] < draws[b];
  }
  std::size_t best() const {
    std::size_t top = 0;
    for (std::size_t i = 1; i < planes.size(); ++i)
      if (better(i, top)) top = i;
    return top;
  }
  void drop(std::size_t i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    planes.erase(planes.begin() + at);
    counts.erase(counts.begin() + at);
    draws.erase(draws.begin() + at);
  }
  // Keeps the hypotheses with at least so many points, and only the best `most` when there are twice as many.
  void prune(std::uint32_t least, std::size_t most) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < planes.size(); ++i)
      if (counts[i] >= least) order.push_back(i);
    if (order.size() > 2 * most) {
      std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(most), order.end(),
                       [&](std::size_t a, std::size_t b) { return better(a, b); });
      order.resize(most);
      std::sort(order.begin(), order.end());
    }
    for (std::size_t to = 0; to < order.size(); ++to) {
      planes[to] = planes[order[to]];
      counts[to] = counts[order[to]];
      draws[to] = draws[order[to]];
    }
    planes.resize(order.size());
    counts.resize(order.size());
    draws.resize(order.size());
  }
};

class Search {
 public:
  Search(const OrientedPoints& points, const RansacParams& params)
      : params_(params), remaining_(with_normals(points)), rng_(params.key) {
    result_.label.assign(points.points.size, 0);
    runs_.update(remaining_, 0);
    // By the Poisson distribution, n draws miss a plane with probability exp(-n q) when a draw hits it with chance q.
    needed_hits_ = -natural_log(1 - params.probability);
  }

  RansacPlanes run() {
    while (remaining_.size >= params_.min_points) {
      refresh_sample();
      const bool any = !pool_.planes.empty();
      const std::size_t best = any ? pool_.best() : 0;
      const double least = params_.min_points;
      const double size = any ? std::max(least, static_cast<double>(pool_.counts[best] * stride_)) : least;
      if (expected_hits_per_point_ * size < needed_hits_) {
        draw_batch();
      } else if (any) {
        take(best);
      } else {
        break;
      }
    }
    return std::move(result_);
  }

 private:
  // Samples every stride-th of the caller's points. The stride is halved as fewer points remain, and candidates are
  // then counted again.
  void refresh_sample() {
    std::size_t stride = 1;
    while (remaining_.size > stride * kSample) stride *= 2;
    if (stride == stride_) return;
    stride_ = stride;
    sample_ = {};
    for (std::size_t i = 0; stride_ > 1 && i < remaining_.size; ++i)
      if (remaining_.index[i] % stride_ == 0) sample_.add(remaining_, i);
    sample_.pad();
    count_inliers(sample().oriented(), pool_.planes, score_params(), pool_.counts);
    pool_.prune(least_count(), kPool);
  }

  const RemainingPoints& sample() const { return stride_ == 1 ? remaining_ : sample_; }

  // A candidate with fewer points of the sample is not worth keeping. The limit is half of what the smallest plane
  // should have.
  std::uint32_t least_count() const {
    if (stride_ == 1) return params_.min_points;
    return std::max(3u, params_.min_points / static_cast<std::uint32_t>(2 * stride_));
  }

  PlaneScoreParams score_params() const {
    return {static_cast<float>(params_.epsilon), static_cast<float>(params_.min_cos)};
  }

  void draw_batch() {
    const std::size_t before = pool_.planes.size();
    std::uint64_t made = 0;
    while (pool_.planes.size() - before < kBatch && made < kBatchDraws) {
      ++made;
      if (const auto plane = draw()) {
        pool_.planes.push_back(*plane);
        pool_.draws.push_back(draw_count_ + made);
      }
    }
    draw_count_ += made;
    expected_hits_per_point_ +=
        static_cast<double>(made) / (static_cast<double>(remaining_.size) * kLevels * kLocality);
    pool_.counts.resize(pool_.planes.size());
    count_inliers(sample().oriented(), std::span(pool_.planes).subspan(before), score_params(),
                  std::span(pool_.counts).subspan(before));
    pool_.prune(least_count(), kPool);
  }

  // Removes the members (positions, ascending) from the remaining points and from the count of every candidate.
  void take_out(const std::vector<std::uint32_t>& members) {
    RemainingPoints gone;
    for (const std::uint32_t i : members)
      if (remaining_.index[i] % stride_ == 0) gone.add(remaining_, i);
    gone.pad();
    std::vector<std::uint32_t> in_sample, lost(pool_.planes.size());
    for (std::uint32_t i = 0, next = 0; stride_ > 1 && next < gone.size; ++i) {
      if (sample_.index[i] != gone.index[next]) continue;
      in_sample.push_back(i);
      ++next;
    }
    count_inliers(gone.oriented(), pool_.planes, score_params(), lost);
    for (std::size_t i = 0; i < lost.size(); ++i) pool_.counts[i] -= lost[i];
    pool_.prune(least_count(), kPool);
    remove(sample_, in_sample);
    remove(remaining_, members);
    runs_.update(remaining_, members.front());
  }

  bool allowed(Vec3 normal) const {
    return std::abs(dot(normal, params_.across[0])) <= params_.max_across &&
           std::abs(dot(normal, params_.across[1])) <= params_.max_across;
  }

  std::optional<PlaneHypothesis> draw() {
    const std::size_t n = remaining_.size;
    const std::uint64_t bits = rng_.next();
    const std::size_t window = std::min<std::size_t>(n, std::size_t{kFirstWindow} << bits % kLevels);
    const std::size_t i = rng_.below(n);
    const std::size_t begin = std::min(i > window / 2 ? i - window / 2 : 0, n - window);
    const std::size_t j = begin + (bits >> 8 & 0xfffff) % window;
    const std::size_t k = begin + (bits >> 32 & 0xfffff) % window;
    const Vec3 ni = remaining_.normal(i), nj = remaining_.normal(j), nk = remaining_.normal(k);
    if (std::abs(dot(ni, nj)) < params_.min_cos || std::abs(dot(ni, nk)) < params_.min_cos) return std::nullopt;
    const Vec3 a = remaining_.position(j) - remaining_.position(i);
    const Vec3 b = remaining_.position(k) - remaining_.position(i);
    Vec3 normal = cross(a, b);
    const double length = norm(normal);
    // Derived: 6 degrees; at less, noise turns the plane of three points freely.
    constexpr double kThinnest = 0.1;  // sine of the angle at the first point
    if (!(length > kThinnest * norm(a) * norm(b)) || length == 0) return std::nullopt;
    normal = (1 / length) * normal;
    if (!allowed(normal)) return std::nullopt;
    for (const Vec3& v : {ni, nj, nk})
      if (std::abs(dot(normal, v)) < params_.min_cos) return std::nullopt;
    const double d = -dot(normal, remaining_.position(i));
    return PlaneHypothesis{static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z),
                           static_cast<float>(d)};
  }

  bool agrees(const Plane& plane, std::size_t i) const {
    return std::abs(signed_distance(plane, remaining_.position(i))) <= params_.epsilon &&
           std::abs(dot(plane.n, remaining_.normal(i))) >= params_.min_cos;
  }

  // Distances come first, in one loop without branches, because most points of a run are not near.
  std::vector<std::uint32_t> consensus(const Plane& plane) const {
    std::vector<std::uint32_t> members;
    std::array<double, RunBoxes::kRun> distance;
    for (std::size_t run = 0; run < runs_.count(); ++run) {
      if (!runs_[run].may_reach(plane, params_.epsilon)) continue;
      const std::size_t begin = run * RunBoxes::kRun, size = RunBoxes::end(run, remaining_) - begin;
      const float *x = &remaining_.x[begin], *y = &remaining_.y[begin], *z = &remaining_.z[begin];
      for (std::size_t i = 0; i < size; ++i) distance[i] = std::abs(signed_distance(plane, {x[i], y[i], z[i]}));
      for (std::size_t i = 0; i < size; ++i)
        if (distance[i] <= params_.epsilon && std::abs(dot(plane.n, remaining_.normal(begin + i))) >= params_.min_cos)
          members.push_back(static_cast<std::uint32_t>(begin + i));
    }
    return members;
  }

  std::int64_t connectivity_of(const Plane& plane) const {
    const double stretch = 1 / std::max(std::abs(plane.n.z), 1 / params_.most_stretch);
    return static_cast<std::int64_t>(static_cast<double>(params_.connectivity) * stretch);
  }

  // Returns the part of the consensus set that is within the connectivity of the box.
  std::vector<std::uint32_t> consensus_around(const Plane& plane, const PointExtent& box) const {
    std::vector<std::uint32_t> members;
    const std::int64_t connectivity = connectivity_of(plane);
    const auto margin = static_cast<double>(connectivity);
    for (std::size_t run = 0; run < runs_.count(); ++run) {
      if (!runs_[run].meets(box, margin) || !runs_[run].may_reach(plane, params_.epsilon)) continue;
      for (std::size_t i = run * RunBoxes::kRun; i < RunBoxes::end(run, remaining_); ++i)
        if (agrees(plane, i) && box.contains(remaining_.position(i), connectivity))
          members.push_back(static_cast<std::uint32_t>(i));
    }
    return members;
  }

  // Returns the connected component of the consensus set that shares most points with `like`, or the largest when
  // `like` is empty.
  std::vector<std::uint32_t> part_of(const Plane& plane, const std::vector<std::uint32_t>& members,
                                     const std::vector<std::uint32_t>& like) const {
    const Clusters clusters = euclidean_clusters(remaining_.points(), members, connectivity_of(plane));
    std::vector<std::uint32_t> votes(clusters.count, 0);
    std::size_t at = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      while (at < like.size() && like[at] < members[i]) ++at;
      votes[clusters.id[i]] += like.empty() || (at < like.size() && like[at] == members[i]);
    }
    if (votes.empty()) return {};
    const auto chosen = static_cast<std::uint32_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
    std::vector<std::uint32_t> part;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (clusters.id[i] == chosen) part.push_back(members[i]);
    return part;
  }

  PointExtent extent_of(const std::vector<std::uint32_t>& members) const {
    PointExtent extent;
    for (const std::uint32_t i : members) extent.add(remaining_.position(i));
    return extent;
  }

  // Along an edge normals are mixtures. So a strip of points there agrees on a plane of its own although it is on the
  // surface beside it. Its points do not belong to that surface because their normals disagree. Points whose normals
  // agree are another part of the same plane.
  bool is_edge_strip(const std::vector<std::uint32_t>& members, const PointExtent& extent) const {
    for (std::size_t p = 0; p < result_.planes.size(); ++p) {
      if (!extent.meets(extents_[p], static_cast<double>(params_.connectivity))) continue;
      const Plane& plane = result_.planes[p];
      std::size_t near = 0;
      for (const std::uint32_t i : members)
        near += std::abs(signed_distance(plane, remaining_.position(i))) <= params_.epsilon &&
                std::abs(dot(plane.n, remaining_.normal(i))) < params_.min_cos;
      if (static_cast<double>(near) > kExplained * static_cast<double>(members.size())) return true;
    }
    return false;
  }

  void take(std::size_t candidate) {
    const PlaneHypothesis h = pool_.planes[candidate];
    Plane plane{{h[0], h[1], h[2]}, h[3]};
    const std::vector<std::uint32_t> seed = part_of(plane, consensus(plane), {});
    std::vector<std::uint32_t> members = seed;
    for (int round = 0; round < kRefinements && members.size() >= params_.min_points; ++round) {
      const PlaneFit fit = fit_plane(moments_of(remaining_.points(), members));
      if (!fit.unique || !allowed(fit.plane.n)) break;
      std::vector<std::uint32_t> next = consensus_around(fit.plane, extent_of(members));
      if (next.size() < params_.min_points) break;
      plane = fit.plane;
      const bool converged = next == members;
      members = std::move(next);
      if (converged) break;
    }
    if (members.size() >= params_.min_points) members = part_of(plane, members, seed);
    if (members.size() < params_.min_points) {
      pool_.drop(candidate);
      return;
    }
    const PointExtent extent = extent_of(members);
    if (!is_edge_strip(members, extent)) {
      result_.planes.push_back(plane);
      extents_.push_back(extent);
      for (const std::uint32_t i : members)
        result_.label[remaining_.index[i]] = static_cast<std::uint32_t>(result_.planes.size());
    }
    take_out(members);  // the candidate stays, because other parts of the same plane may remain
  }

  RansacParams params_;
  RemainingPoints remaining_;
  RunBoxes runs_;  // of the remaining points
  Rng rng_;
  RansacPlanes result_;
  std::vector<PointExtent> extents_;  // of the points of each plane
  RemainingPoints sample_;            // the points on which candidates are counted, where not all that remain are
  std::size_t stride_ = 0;
  Pool pool_;
  double needed_hits_ = 0;
  double expected_hits_per_point_ = 0;  // sum over draws of the chance to hit a plane, per point of that plane
  std::uint64_t draw_count_ = 0;
};

}  // namespace

RansacPlanes ransac_planes(const OrientedPoints& points, const RansacParams& params) {
  return Search(points, params).run();
}

}  // namespace ilot
