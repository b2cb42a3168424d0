// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/colour_classes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "kernels/core/radix_sort.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Returns the n-th root of v in (0, 1] by Newton's iteration from above.
double root_of(double v, int n) {
  double x = 1;
  for (int i = 0; i < 60; ++i) {
    double power = 1;
    for (int k = 1; k < n; ++k) power *= x;
    x -= (x * power - v) / (n * power);
  }
  return x;
}

// x^2.4 = (x x^(1/5))^2.
double linear_light(int code) {
  const double v = code / 255.0;
  if (v <= 0.04045) return v / 12.92;
  const double x = (v + 0.055) / 1.055;
  const double y = x * root_of(x, 5);
  return y * y;
}

// The function f of CIELAB.
double compressed(double t) {
  // Derived: the definition of CIE L*.
  constexpr double kLinearBelow = 216.0 / 24389;
  return t > kLinearBelow ? root_of(t, 3) : (24389.0 / 27 * t + 16) / 116;
}

struct LabTables {
  static constexpr int kSteps = 4096;
  std::array<double, 256> linear;
  std::array<double, kSteps + 2> compress;  // f at i / kSteps, straight between

  LabTables() {
    for (int i = 0; i < 256; ++i) linear[static_cast<std::size_t>(i)] = linear_light(i);
    for (int i = 0; i < kSteps + 2; ++i)
      compress[static_cast<std::size_t>(i)] = compressed(static_cast<double>(i) / kSteps);
  }
  double f(double t) const {
    // Near black the curve bends too much for linear pieces.
    if (t < 0.02) return compressed(t);
    const double at = t * kSteps;
    const auto i = static_cast<std::size_t>(at);
    const double part = at - static_cast<double>(i);
    return compress[i] + part * (compress[i + 1] - compress[i]);
  }
};

const LabTables& tables() {
  static const LabTables t;
  return t;
}

using Feature = std::array<std::int32_t, 4>;

// The colours that occur, ascending, their counts, and the colour of each point.
struct Histogram {
  std::vector<Feature> feature;
  std::vector<std::uint64_t> count;
  std::vector<std::uint32_t> of_point;
  std::uint64_t hash = 0;
};

Feature feature_of(std::uint64_t key, ColourSpace space) {
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(key >> shift); };
  if (space == ColourSpace::kRgb) return {part(16), part(8), part(0), 0};
  const Lab lab = lab_of(part(16), part(8), part(0));
  // The whole range of intensity has the same weight as that of lightness.
  const auto intensity = static_cast<std::int32_t>((key >> 24) * 10000 / 65535);
  return {lab[0], lab[1], lab[2], space == ColourSpace::kLabIntensity ? intensity : 0};
}

Histogram histogram_of(const PointColours& c, ColourSpace space) {
  const std::size_t n = c.r.size();
  std::vector<std::uint64_t> keys(n);
  for (std::size_t i = 0; i < n; ++i) {
    keys[i] = std::uint64_t{c.r[i]} << 16 | std::uint64_t{c.g[i]} << 8 | c.b[i];
    if (space == ColourSpace::kLabIntensity) keys[i] |= std::uint64_t{c.intensity[i]} << 24;
  }
  Histogram h;
  h.of_point.resize(n);
  std::uint64_t last = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint32_t i : sorted_order(keys)) {
    if (keys[i] != last) {
      last = keys[i];
      h.feature.push_back(feature_of(last, space));
      h.count.push_back(0);
    }
    ++h.count.back();
    h.of_point[i] = static_cast<std::uint32_t>(h.feature.size() - 1);
  }
  for (std::size_t i = 0; i < h.feature.size(); ++i) {
    h.hash = mix64(h.hash ^ h.count[i]);
    for (const std::int32_t v : h.feature[i]) h.hash = mix64(h.hash ^ static_cast<std::uint64_t>(v + (1 << 20)));
  }
  return h;
}

using Centre = std::array<double, 4>;

double squared(const Feature& f, const Centre& c) {
  double sum = 0;
  for (std::size_t d = 0; d < 4; ++d) {
    const double diff = f[d] - c[d];
    sum += diff * diff;
  }
  return sum;
}

Centre centre_at(const Feature& f) {
  return {static_cast<double>(f[0]), static_cast<double>(f[1]), static_cast<double>(f[2]), static_cast<double>(f[3])};
}

// k-means++: each next centre is a colour drawn with the weight of its squared distance from the nearest centre so far,
// times its number of points.
std::vector<Centre> first_centres(const Histogram& h, std::uint32_t k, Rng& rng) {
  const std::size_t n = h.feature.size();
  std::vector<double> weight(n);
  for (std::size_t i = 0; i < n; ++i) weight[i] = static_cast<double>(h.count[i]);
  std::vector<double> nearest(n, std::numeric_limits<double>::infinity());
  std::vector<Centre> centres;
  while (centres.size() < k) {
    double target = rng.uniform() * std::accumulate(weight.begin(), weight.end(), 0.0);
    std::size_t pick = n;
    for (std::size_t i = 0; i < n && (pick == n || target >= 0); ++i) {
      if (weight[i] == 0) continue;
      pick = i;
      target -= weight[i];
    }
    if (pick == n) break;  // fewer colours than centres
    centres.push_back(centre_at(h.feature[pick]));
    for (std::size_t i = 0; i < n; ++i) {
      nearest[i] = std::min(nearest[i], squared(h.feature[i], centres.back()));
      weight[i] = nearest[i] * static_cast<double>(h.count[i]);
    }
  }
  return centres;
}

struct Clustering {
  std::vector<Centre> centre;
  std::vector<std::uint32_t> of_colour;
  std::vector<std::uint64_t> size;
  double intra = 0;
};

bool assign(const Histogram& h, Clustering& c) {
  bool changed = false;
  for (std::size_t i = 0; i < h.feature.size(); ++i) {
    std::uint32_t best = 0;
    double least = squared(h.feature[i], c.centre[0]);
    for (std::uint32_t j = 1; j < c.centre.size(); ++j) {
      const double d = squared(h.feature[i], c.centre[j]);
      if (d >= least) continue;
      least = d;
      best = j;
    }
    changed |= c.of_colour[i] != best;
    c.of_colour[i] = best;
  }
  return changed;
}

// Sets the centres to the means. A class without points keeps its centre.
void update(const Histogram& h, Clustering& c) {
  std::vector<std::array<std::int64_t, 4>> sum(c.centre.size());
  c.size.assign(c.centre.size(), 0);
  for (std::size_t i = 0; i < h.feature.size(); ++i) {
    const std::uint32_t j = c.of_colour[i];
    c.size[j] += h.count[i];
    for (std::size_t d = 0; d < 4; ++d) sum[j][d] += static_cast<std::int64_t>(h.count[i]) * h.feature[i][d];
  }
  for (std::size_t j = 0; j < c.centre.size(); ++j)
    for (std::size_t d = 0; d < 4 && c.size[j] > 0; ++d)
      c.centre[j][d] = static_cast<double>(sum[j][d]) / static_cast<double>(c.size[j]);
}

Clustering cluster(const Histogram& h, const ColourClassParams& params, std::uint64_t start) {
  Rng rng(params.key ^ h.hash, start);
  Clustering c{first_centres(h, params.k, rng), std::vector<std::uint32_t>(h.feature.size(), 0xffffffffu), {}};
  for (int round = 0; round < params.max_rounds && assign(h, c); ++round) update(h, c);
  for (std::size_t i = 0; i < h.feature.size(); ++i)
    c.intra += static_cast<double>(h.count[i]) * squared(h.feature[i], c.centre[c.of_colour[i]]);
  return c;
}

double inertia_between(const Clustering& c) {
  Centre mean{};
  double n = 0;
  for (std::size_t j = 0; j < c.centre.size(); ++j) {
    n += static_cast<double>(c.size[j]);
    for (std::size_t d = 0; d < 4; ++d) mean[d] += static_cast<double>(c.size[j]) * c.centre[j][d];
  }
  double inter = 0;
  for (std::size_t j = 0; j < c.centre.size(); ++j)
    for (std::size_t d = 0; d < 4; ++d) {
      const double diff = c.centre[j][d] - mean[d] / n;
      inter += static_cast<double>(c.size[j]) * diff * diff;
    }
  return inter;
}

}  // namespace

Lab lab_of(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  const LabTables& t = tables();
  const double lr = t.linear[r], lg = t.linear[g], lb = t.linear[b];
  // XYZ over the white point, so that white is (1, 1, 1).
  const double x = t.f((0.4124564 * lr + 0.3575761 * lg + 0.1804375 * lb) / 0.9504700);
  const double y = t.f(0.2126729 * lr + 0.7151522 * lg + 0.0721750 * lb);
  const double z = t.f((0.0193339 * lr + 0.1191920 * lg + 0.9503041 * lb) / 1.0888300);
  const auto hundredths = [](double v) { return static_cast<std::int32_t>(std::nearbyint(100 * v)); };
  return {hundredths(116 * y - 16), hundredths(500 * (x - y)), hundredths(200 * (y - z))};
}

ColourClasses colour_classes(const PointColours& colours, const ColourClassParams& params) {
  assert(params.k >= 1 && colours.g.size() == colours.r.size() && colours.b.size() == colours.r.size());
  if (colours.r.empty()) return {};
  const Histogram h = histogram_of(colours, params.space);
  Clustering best = cluster(h, params, 0);
  for (int s = 1; s < params.starts; ++s) {
    Clustering other = cluster(h, params, static_cast<std::uint64_t>(s));
    if (other.intra < best.intra) best = std::move(other);
  }
  std::vector<std::uint32_t> order, number(best.centre.size(), 0);
  for (std::uint32_t j = 0; j < best.centre.size(); ++j)
    if (best.size[j] > 0) order.push_back(j);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return best.size[a] != best.size[b] ? best.size[a] > best.size[b] : best.centre[a] < best.centre[b];
  });
  ColourClasses r;
  for (const std::uint32_t j : order) {
    r.centre.push_back(best.centre[j]);
    r.size.push_back(best.size[j]);
    number[j] = static_cast<std::uint32_t>(r.centre.size());
  }
  r.label.resize(colours.r.size());
  for (std::size_t i = 0; i < r.label.size(); ++i) r.label[i] = number[best.of_colour[h.of_point[i]]];
  r.intra = best.intra;
  r.inter = inertia_between(best);
  return r;
}

}  // namespace ilot
