// SPDX-License-Identifier: Apache-2.0
#include "training/feature_selection.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "training/f_distribution.h"

namespace ilot {
namespace {

constexpr double kTolerance = 1e-9;

// A symmetric matrix, row by row.
struct Matrix {
  std::size_t size;
  std::vector<double> v = std::vector<double>(size * size, 0);
  double& at(std::size_t i, std::size_t j) { return v[i * size + j]; }
  double at(std::size_t i, std::size_t j) const { return v[i * size + j]; }
};

// Adds the squares and products about the means of the rows for which `belongs` is true.
template <typename Belongs>
void add_scatter(std::span<const double> samples, Matrix& m, const Belongs& belongs) {
  const std::size_t k = m.size, rows = samples.size() / k;
  std::vector<double> mean(k, 0), d(k);
  double n = 0;
  for (std::size_t r = 0; r < rows; ++r) {
    if (!belongs(r)) continue;
    ++n;
    for (std::size_t i = 0; i < k; ++i) mean[i] += samples[r * k + i];
  }
  for (double& v : mean) v /= n;
  for (std::size_t r = 0; r < rows; ++r) {
    if (!belongs(r)) continue;
    for (std::size_t i = 0; i < k; ++i) d[i] = samples[r * k + i] - mean[i];
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = 0; j < k; ++j) m.at(i, j) += d[i] * d[j];
  }
}

// Removes from the other features the part that feature p explains.
void remove(Matrix& m, std::size_t p) {
  std::vector<double> row(m.size);
  for (std::size_t j = 0; j < m.size; ++j) row[j] = m.at(p, j);
  if (!(row[p] > 0)) return;
  for (std::size_t i = 0; i < m.size; ++i)
    for (std::size_t j = 0; j < m.size; ++j) m.at(i, j) -= row[i] * row[j] / row[p];
}

// The feature that makes lambda least, and the factor. Its index is the size when no feature can be taken.
struct Candidate {
  std::size_t feature;
  double factor;
};

Candidate best_candidate(const Matrix& within, const Matrix& total, const std::vector<double>& variance,
                         const std::vector<std::uint8_t>& taken) {
  Candidate best{total.size, 2};
  for (std::size_t j = 0; j < total.size; ++j) {
    if (taken[j] != 0 || !(total.at(j, j) > kTolerance * variance[j])) continue;
    const double factor = std::max(0.0, within.at(j, j)) / total.at(j, j);
    if (factor < best.factor) best = {j, factor};
  }
  return best;
}

}  // namespace

std::vector<SelectedFeature> select_features(std::span<const double> samples, std::span<const std::uint32_t> classes,
                                             std::size_t features, double max_p) {
  assert(samples.size() == classes.size() * features);
  const std::size_t n = classes.size();
  std::vector<std::uint32_t> names(classes.begin(), classes.end());
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  const std::size_t g = names.size();
  if (g < 2 || n <= g) return {};

  Matrix total{features}, within{features};
  add_scatter(samples, total, [](std::size_t) { return true; });
  for (const std::uint32_t name : names)
    add_scatter(samples, within, [&](std::size_t r) { return classes[r] == name; });
  std::vector<double> variance;
  for (std::size_t j = 0; j < features; ++j) variance.push_back(total.at(j, j));

  std::vector<SelectedFeature> selected;
  std::vector<std::uint8_t> taken(features, 0);
  double lambda = 1;
  while (selected.size() + g < n) {
    const Candidate best = best_candidate(within, total, variance, taken);
    if (best.feature == features) break;
    const auto d1 = static_cast<std::uint32_t>(g - 1), d2 = static_cast<std::uint32_t>(n - g - selected.size());
    const double f = static_cast<double>(d2) / d1 * (1 / std::max(best.factor, 1e-300) - 1);
    const double p = f_upper_tail(f, d1, d2);
    if (!(p < max_p)) break;
    lambda *= best.factor;
    selected.push_back({best.feature, lambda, f, p});
    taken[best.feature] = 1;
    remove(total, best.feature);
    remove(within, best.feature);
  }
  return selected;
}

}  // namespace ilot
