// SPDX-License-Identifier: Apache-2.0
#include "training/role_weights.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kNever = -1e9;
constexpr std::size_t kWeights = 2 * kCandidateStates;  // powers, then biases
using Weights = std::array<double, kWeights>;
constexpr Weights kPlain{1, 1, 1, 1, 0, 0, 0, 0};
constexpr auto kObject = static_cast<std::size_t>(CandidateState::object),
               kRest = static_cast<std::size_t>(CandidateState::rest),
               kPart = static_cast<std::size_t>(CandidateState::part),
               kMerged = static_cast<std::size_t>(CandidateState::merged);

double exp_of(double v) {
  return v < -700 ? 0 : natural_exp(std::min(v, 700.0));
}
double log_sum(double a, double b) {
  const double most = std::max(a, b);
  return most + natural_log(1 + exp_of(std::min(a, b) - most));
}

using StateScores = std::array<double, kCandidateStates>;

// All cuts of all trees at once: the log sums over the cuts below each object candidate, and the probabilities of its
// states.
class Cuts {
 public:
  Cuts(std::span<const RoleSample> candidates, const Weights& w, bool only_allowed)
      : candidates_(candidates), scores_(candidates.size()), parts_(candidates.size()), all_(candidates.size()) {
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      for (std::size_t s = 0; s < kCandidateStates; ++s)
        scores_[i][s] =
            only_allowed && candidates[i].may[s] == 0 ? kNever : w[s] * candidates[i].log[s] + w[kCandidateStates + s];
      const auto [a, b] = std::pair{candidates[i].parts[0], candidates[i].parts[1]};
      const double below = a == 0 ? 0 : parts_[a - 1] + parts_[b - 1];
      parts_[i] = scores_[i][kPart] + below;
      all_[i] = whole(i) + below;
      if (a != 0) all_[i] = log_sum(all_[i], scores_[i][kMerged] + all_[a - 1] + all_[b - 1]);
    }
  }

  double log_of_all(std::size_t root) const { return all_[root]; }

  // Returns the probabilities of the states of each object candidate. Parts come before their joins.
  std::vector<StateScores> probabilities() const {
    std::vector<StateScores> out(candidates_.size(), StateScores{});
    std::vector<double> open(candidates_.size(), 1), inside(candidates_.size(), 0);
    for (std::size_t i = candidates_.size(); i-- > 0;) {
      const auto [a, b] = std::pair{candidates_[i].parts[0], candidates_[i].parts[1]};
      double merged = 0;
      if (a != 0) {
        merged = open[i] * exp_of(std::min(0.0, scores_[i][kMerged] + all_[a - 1] + all_[b - 1] - all_[i]));
        for (const std::uint32_t part : {a, b}) {
          open[part - 1] = merged;
          inside[part - 1] = inside[i] + open[i] - merged;
        }
      }
      const double object = exp_of(scores_[i][kObject] - whole(i));
      out[i][kObject] = (open[i] - merged) * object;
      out[i][kRest] = (open[i] - merged) * (1 - object);
      out[i][kPart] = inside[i];
      out[i][kMerged] = merged;
    }
    return out;
  }

 private:
  double whole(std::size_t i) const { return log_sum(scores_[i][kObject], scores_[i][kRest]); }

  std::span<const RoleSample> candidates_;
  std::vector<StateScores> scores_;
  std::vector<double> parts_, all_;  // of all below, itself included: split into parts; any cut
};

std::vector<std::size_t> roots_of(std::span<const RoleSample> candidates) {
  std::vector<std::size_t> root(candidates.size());
  for (std::size_t i = candidates.size(); i-- > 0;) {
    root[i] = std::max(root[i], i);  // parents come later
    for (const std::uint32_t part : candidates[i].parts)
      if (part != 0) root[part - 1] = root[i];
  }
  return root;
}

struct LikelihoodSlope {
  double value = 0;  // minus the log likelihood, plus the penalty for the distance of the weights from 1 and 0
  Weights gradient{};
};

LikelihoodSlope slope_at(std::span<const RoleSample> candidates, const std::vector<std::size_t>& roots,
                         const Weights& w) {
  const Cuts any(candidates, w, false), allowed(candidates, w, true);
  const auto of_any = any.probabilities(), of_allowed = allowed.probabilities();
  LikelihoodSlope out;
  for (std::size_t k = 0; k < kWeights; ++k) {
    out.gradient[k] = w[k] - kPlain[k];
    out.value += (w[k] - kPlain[k]) * (w[k] - kPlain[k]) / 2;
  }
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const double log_allowed = allowed.log_of_all(roots[i]);
    if (log_allowed < kNever / 10) continue;
    if (roots[i] == i) out.value += any.log_of_all(i) - log_allowed;
    for (std::size_t s = 0; s < kCandidateStates; ++s) {
      const double more = of_any[i][s] - of_allowed[i][s];
      out.gradient[s] += more * candidates[i].log[s];
      out.gradient[kCandidateStates + s] += more;
    }
  }
  return out;
}

double dot(const Weights& a, const Weights& b) {
  double sum = 0;
  for (std::size_t k = 0; k < kWeights; ++k) sum += a[k] * b[k];
  return sum;
}

// The estimate of the inverse Hessian by BFGS.
class InverseHessian {
 public:
  InverseHessian() {
    for (std::size_t k = 0; k < kWeights; ++k) rows_[k][k] = 1;
  }
  Weights times(const Weights& v) const {
    Weights out{};
    for (std::size_t k = 0; k < kWeights; ++k) out[k] = dot(rows_[k], v);
    return out;
  }
  void update(const Weights& step, const Weights& change) {
    const double along = dot(step, change);
    if (!(along > 1e-12)) return;
    const Weights turned = times(change);
    const double both = (along + dot(change, turned)) / (along * along);
    for (std::size_t i = 0; i < kWeights; ++i)
      for (std::size_t j = 0; j < kWeights; ++j)
        rows_[i][j] += both * step[i] * step[j] - (turned[i] * step[j] + step[i] * turned[j]) / along;
  }

 private:
  std::array<Weights, kWeights> rows_{};
};

}  // namespace

RoleWeights learn_role_weights(std::span<const RoleSample> candidates) {
  const std::vector<std::size_t> roots = roots_of(candidates);
  Weights w = kPlain;
  LikelihoodSlope at = slope_at(candidates, roots, w);
  InverseHessian inverse;
  double step = 1 / std::max(1.0, std::sqrt(dot(at.gradient, at.gradient)));  // the first step is at most 1 long
  for (int round = 0; round < 100; ++round) {
    Weights direction = inverse.times(at.gradient), next;
    LikelihoodSlope there;
    for (; step > 1e-9; step /= 2) {
      for (std::size_t k = 0; k < kWeights; ++k) next[k] = w[k] - step * direction[k];
      there = slope_at(candidates, roots, next);
      if (there.value <= at.value - 1e-4 * step * dot(direction, at.gradient)) break;
    }
    if (step <= 1e-9) break;
    const double gain = at.value - there.value;
    Weights moved, change;
    for (std::size_t k = 0; k < kWeights; ++k) {
      moved[k] = next[k] - w[k];
      change[k] = there.gradient[k] - at.gradient[k];
    }
    inverse.update(moved, change);
    w = next;
    at = there;
    step = 1;
    if (gain <= 1e-9 * std::abs(at.value)) break;
  }
  RoleWeights out;
  for (std::size_t s = 0; s < kCandidateStates; ++s) out.power[s] = w[s], out.bias[s] = w[kCandidateStates + s];
  return out;
}

}  // namespace ilot
