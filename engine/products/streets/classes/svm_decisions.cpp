// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/svm_decisions.h"

#include <algorithm>

#include "engine/products/streets/classes/object_model_functions.h"
#include "kernels/classifiers/radial_sums.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kDecisionsGrain = 256;  // candidates

// The support vectors of one class in one array. All pairs share the kernels: each kernel is computed once, and its
// weights against the other classes are applied to it.
struct ClassVectors {
  std::vector<double> vectors, weights;
};

std::vector<ClassVectors> vectors_by_class(const ObjectModel& model) {
  std::vector<ClassVectors> out(model.classes.size());
  for (std::size_t v = 0; v < model.vectors.size(); ++v) {
    ClassVectors& own = out[model.class_of_vector[v]];
    own.vectors.insert(own.vectors.end(), model.vectors[v].begin(), model.vectors[v].end());
    own.weights.insert(own.weights.end(), model.weights[v].begin(), model.weights[v].end());
  }
  return out;
}

// Computes the decisions for `candidates` into `of` and `nearest`.
void decide(const ObjectModel& model, const std::vector<ClassVectors>& classes,
            std::span<const CandidateFeatures> candidates, std::span<double> of, std::span<double> nearest) {
  const std::size_t k = classes.size(), pairs = model.rho.size(), n = candidates.size();
  std::vector<double> rows, sums(n * (k - 1)), near(n);
  for (const CandidateFeatures& f : candidates) {
    const std::vector<double> row = standardised(model, f);
    rows.insert(rows.end(), row.begin(), row.end());
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t p = 0; p < pairs; ++p) of[i * pairs + p] = -model.rho[p];
  for (std::size_t own = 0; own < k; ++own) {
    radial_sums({model.features.size(), k - 1, model.gamma, classes[own].vectors, classes[own].weights}, rows, sums,
                near);
    for (std::size_t i = 0; i < n; ++i) {
      nearest[i * k + own] = near[i];
      for (std::size_t other = 0; other < k; ++other)
        if (other != own)
          of[i * pairs + pair_index(std::min(own, other), std::max(own, other), k)] +=
              sums[i * (k - 1) + (other < own ? other : other - 1)];
    }
  }
}

}  // namespace

PairDecisions pair_decisions(const ObjectModel& model, std::span<const CandidateFeatures> candidates) {
  const std::vector<ClassVectors> classes = vectors_by_class(model);
  const std::size_t pairs = model.rho.size();
  PairDecisions out{pairs, std::vector<double>(candidates.size() * pairs),
                    std::vector<double>(candidates.size() * classes.size(), 0)};
  parallel_for((candidates.size() + kDecisionsGrain - 1) / kDecisionsGrain, [&](std::size_t part) {
    const std::size_t first = part * kDecisionsGrain, count = std::min(kDecisionsGrain, candidates.size() - first);
    decide(model, classes, candidates.subspan(first, count), std::span(out.of).subspan(first * pairs, count * pairs),
           std::span(out.nearest).subspan(first * classes.size(), count * classes.size()));
  });
  return out;
}

}  // namespace ilot
