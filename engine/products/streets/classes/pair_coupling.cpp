// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/pair_coupling.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/products/streets/classes/object_model_functions.h"

namespace ilot {
namespace {

// Derived: keeps the odds of two classes finite; far beyond what samples can show.
constexpr double kSurest = 1e-7;

// The rows of a system of equations. The last value of a row is its right side.
using Equations = std::vector<std::vector<double>>;

std::vector<double> solved(Equations e) {
  const std::size_t n = e.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(e[r][c]) > std::abs(e[pivot][c])) pivot = r;
    std::swap(e[c], e[pivot]);
    for (std::size_t r = c + 1; r < n; ++r) {
      const double times = e[r][c] / e[c][c];
      for (std::size_t j = c; j <= n; ++j) e[r][j] -= times * e[c][j];
    }
  }
  std::vector<double> x(n, 0);
  for (std::size_t r = n; r-- > 0;) {
    double sum = e[r][n];
    for (std::size_t j = r + 1; j < n; ++j) sum -= e[r][j] * x[j];
    x[r] = sum / e[r][r];
  }
  return x;
}

}  // namespace

std::vector<double> coupled_pairs(const std::vector<double>& first, std::size_t k) {
  Equations e(k + 1, std::vector<double>(k + 2, 0));  // the last unknown is the Lagrange multiplier of the sum
  for (std::size_t a = 0; a < k; ++a)
    for (std::size_t b = a + 1; b < k; ++b) {
      const double ab = std::clamp(first[pair_index(a, b, k)], kSurest, 1 - kSurest), ba = 1 - ab;
      e[a][a] += ba * ba;
      e[b][b] += ab * ab;
      e[a][b] = e[b][a] = -ab * ba;
    }
  for (std::size_t a = 0; a < k; ++a) e[a][k] = e[k][a] = 1;
  e[k][k + 1] = 1;
  std::vector<double> p = solved(std::move(e));
  p.resize(k);
  double sum = 0;
  for (double& v : p) sum += v = std::max(0.0, v);
  for (double& v : p) v /= sum;
  return p;
}

}  // namespace ilot
