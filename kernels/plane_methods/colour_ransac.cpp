// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/colour_ransac.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "kernels/core/rng.h"
#include "kernels/planes/oriented_pool.h"
#include "kernels/planes/ransac_iterations.h"
#include "kernels/planes/refine.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

constexpr std::size_t kMostTogether = 8;  // hypotheses counted in one sweep

// The points without a plane, compact, and by colour class.
struct Pool : OrientedPool {
  Indices colour;
  std::vector<Indices> of_class;

  Vec3 position(std::uint32_t i) const { return {x[i], y[i], z[i]}; }
};

Pool pool_of(const OrientedPoints& p, std::span<const std::uint32_t> colour, const Indices& label) {
  Pool pool{unlabelled(p, label), {}, {}};
  if (colour.empty()) return pool;
  for (std::uint32_t at = 0; at < pool.index.size(); ++at) {
    const std::uint32_t c = colour[pool.index[at]];
    pool.colour.push_back(c);
    if (c >= pool.of_class.size()) pool.of_class.resize(c + 1);
    pool.of_class[c].push_back(at);
  }
  return pool;
}

// Draws from all points or inside one class. The sampler in use has its own count of draws.
class PlaneSearch {
 public:
  PlaneSearch(const Pool& pool, const ColourRansacParams& params, Rng& rng) : pool_(pool), params_(params), rng_(rng) {}

  struct Outcome {
    Plane plane;
    std::uint32_t support = 0;
    std::uint64_t draws = 0;
    std::vector<DrawProgress> progress;
  };

  Outcome run() {
    while (out_.draws < params_.max_draws && sampled() < plan_.draws) batch();
    return std::move(out_);
  }

 private:
  std::uint64_t sampled() const { return plan_.from == SamplingPlan::From::kClass ? from_class_ : from_all_; }

  std::optional<PlaneHypothesis> draw() {
    const bool guided = plan_.from == SamplingPlan::From::kClass;
    const Indices* members = guided ? &pool_.of_class[majority_] : nullptr;
    const std::size_t n = guided ? members->size() : pool_.index.size();
    std::array<Vec3, 3> v;
    for (Vec3& q : v) {
      const auto at = static_cast<std::uint32_t>(rng_.below(n));
      q = pool_.position(guided ? (*members)[at] : at);
    }
    const Vec3 normal = cross(v[1] - v[0], v[2] - v[0]);
    const double length = norm(normal);
    if (!(length > 0)) return std::nullopt;
    const Vec3 unit = (1 / length) * normal;
    return PlaneHypothesis{static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z),
                           static_cast<float>(-dot(unit, v[0]))};
  }

  void batch() {
    std::vector<PlaneHypothesis> hypotheses;
    std::vector<std::uint64_t> made_at;
    together_ = static_cast<std::size_t>(std::min<std::uint64_t>(together_, params_.max_draws - out_.draws));
    for (std::size_t i = 1; i <= together_; ++i) {
      const auto h = draw();
      if (!h) continue;
      hypotheses.push_back(*h);
      made_at.push_back(out_.draws + i);
    }
    (plan_.from == SamplingPlan::From::kClass ? from_class_ : from_all_) += together_;
    out_.draws += together_;
    Indices counts(hypotheses.size());
    count_inliers(pool_.oriented(), hypotheses,
                  {static_cast<float>(params_.epsilon), static_cast<float>(params_.min_cos)}, counts);
    bool better = false;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      if (counts[i] <= out_.support) continue;
      better = true;
      out_.support = counts[i];
      out_.plane = {{hypotheses[i][0], hypotheses[i][1], hypotheses[i][2]}, hypotheses[i][3]};
      out_.progress.push_back({made_at[i], counts[i]});
    }
    // A better set changes the sampler, so it must not wait. Without one, sweeps of more draws are cheaper.
    together_ = better ? 1 : std::min(2 * together_, kMostTogether);
    if (better) plan();
  }

  void plan() {
    ColourShares shares{out_.support, pool_.index.size(), 0, 0};
    if (!pool_.colour.empty()) {
      Indices all(pool_.index.size()), votes(pool_.of_class.size(), 0);
      std::iota(all.begin(), all.end(), 0u);
      for (const std::uint32_t i : consensus_set(pool_.oriented(), all, out_.plane, {params_.epsilon, params_.min_cos}))
        ++votes[pool_.colour[i]];
      const auto top = static_cast<std::uint32_t>(std::max_element(votes.begin(), votes.end()) - votes.begin());
      shares.class_consensus = votes[top];
      shares.class_points = pool_.of_class[top].size();
      if (top != majority_) from_class_ = 0;
      majority_ = top;
    }
    plan_ = plan_sampling(shares, params_.probability);
  }

  const Pool& pool_;
  const ColourRansacParams& params_;
  Rng& rng_;
  Outcome out_;
  SamplingPlan plan_;
  std::size_t together_ = 1;
  std::uint32_t majority_ = 0xffffffffu;
  std::uint64_t from_all_ = 0, from_class_ = 0;
};

}  // namespace

ColourRansacPlanes colour_ransac(const OrientedPoints& points, std::span<const std::uint32_t> colour_class,
                                 const ColourRansacParams& params) {
  assert(colour_class.empty() || colour_class.size() == points.points.size);
  ColourRansacPlanes r;
  r.segments.label.assign(points.points.size, 0);
  Rng rng(params.key);
  while (r.segments.planes.size() < params.max_planes) {
    const Pool pool = pool_of(points, colour_class, r.segments.label);
    if (pool.index.size() < std::max(3u, params.min_points)) break;
    PlaneSearch::Outcome found = PlaneSearch(pool, params, rng).run();
    if (found.support < params.min_points) break;
    const RefinedPlane refined =
        refine_plane(points, pool.index, found.plane, {params.epsilon, params.min_cos, params.min_points});
    if (refined.members.size() < params.min_points) break;
    r.segments.planes.push_back(refined.plane);
    r.draws.push_back(found.draws);
    r.progress.push_back(std::move(found.progress));
    for (const std::uint32_t i : refined.members)
      r.segments.label[i] = static_cast<std::uint32_t>(r.segments.planes.size());
  }
  return r;
}

}  // namespace ilot
