// SPDX-License-Identifier: Apache-2.0
#include "training/pair_sigmoid.h"

#include <algorithm>
#include <cmath>

#include "engine/products/streets/classes/object_model_functions.h"

namespace ilot {
namespace {

double log1p_exp(double v) {  // log(1 + exp(v))
  return v > 0 ? v + natural_log(1 + natural_exp(-v)) : natural_log(1 + natural_exp(std::max(v, -700.0)));
}

}  // namespace

Sigmoid fit_sigmoid(const std::vector<double>& f, const std::vector<std::uint8_t>& first) {
  const auto positives = static_cast<double>(std::count(first.begin(), first.end(), 1));
  const double negatives = static_cast<double>(first.size()) - positives;
  const double high = (positives + 1) / (positives + 2), low = 1 / (negatives + 2);
  Sigmoid s{0, natural_log((negatives + 1) / (positives + 1))};
  const auto cost_of = [&](double a, double b) {
    double sum = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double v = a * f[i] + b, t = first[i] ? high : low;
      sum += v >= 0 ? t * v + log1p_exp(-v) : (t - 1) * v + log1p_exp(v);
    }
    return sum;
  };
  double value = cost_of(s.a, s.b);
  for (int round = 0; round < 100; ++round) {
    double h11 = 1e-12, h22 = 1e-12, h21 = 0, g1 = 0, g2 = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double p = sigmoid(s.a * f[i] + s.b), d = p * (1 - p), t = first[i] ? high : low;
      h11 += f[i] * f[i] * d, h22 += d, h21 += f[i] * d;
      g1 += f[i] * (t - p), g2 += t - p;
    }
    if (std::abs(g1) < 1e-5 && std::abs(g2) < 1e-5) break;
    const double det = h11 * h22 - h21 * h21;
    const double da = -(h22 * g1 - h21 * g2) / det, db = -(-h21 * g1 + h11 * g2) / det, slope = g1 * da + g2 * db;
    double step = 1;
    for (; step >= 1e-10; step /= 2) {
      const double next = cost_of(s.a + step * da, s.b + step * db);
      if (next >= value + 0.0001 * step * slope) continue;
      s = {s.a + step * da, s.b + step * db};
      value = next;
      break;
    }
    if (step < 1e-10) break;
  }
  return s;
}

}  // namespace ilot
