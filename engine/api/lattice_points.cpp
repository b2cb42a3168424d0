// SPDX-License-Identifier: Apache-2.0
#include "engine/api/lattice_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "engine/error.h"
#include "kernels/core/parallel.h"
#include "kernels/neighbours/morton.h"

namespace ilot {
namespace {

constexpr std::size_t kPadding = 16;

struct Extent {
  Vec3 min, max;
  double longest() const { return std::max({max.x - min.x, max.y - min.y, max.z - min.z}); }
};

Extent extent_of(const PointArrays& p) {
  if (p.x.size() != p.y.size() || p.x.size() != p.z.size())
    throw Error("points: x, y and z have different lengths", ExitCode::usage);
  if (p.x.empty()) throw Error("points: there are none", ExitCode::usage);
  if (p.x.size() > 0xfffffff0u) throw Error("points: 4 billion at most", ExitCode::usage);
  const auto range = [](std::span<const double> values, double& min, double& max) {
    min = max = values[0];
    for (const double v : values) {
      if (!(std::abs(v) <= 1e15)) throw Error("points: a coordinate is not finite, or beyond 1e15", ExitCode::usage);
      min = std::min(min, v);
      max = std::max(max, v);
    }
  };
  Extent e;
  range(p.x, e.min.x, e.max.x);
  range(p.y, e.min.y, e.max.y);
  range(p.z, e.min.z, e.max.z);
  return e;
}

// The smallest 1, 2 or 5 times a power of ten of which kLatticeSteps cover the length.
double round_step(double length) {
  const double least = length / kLatticeSteps;
  if (!(least > 1e-12)) return 1e-12;
  const int power = static_cast<int>(std::floor(std::log10(least))) - 1;
  for (int p = power;; ++p)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step = p < 0 ? digit / std::pow(10.0, -p) : digit * std::pow(10.0, p);
      if (step >= least) return step;
    }
}

// Offsets from a whole number of steps near the middle, so that multiples of the step stay what they are.
std::vector<float> offsets(std::span<const double> values, double middle, double step, double& origin) {
  const double first = std::round(middle / step);
  origin = first * step;
  std::vector<float> out(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) out[i] = static_cast<float>(std::round(values[i] / step - first));
  return out;
}

std::uint64_t code_of(float x, float y, float z) {
  const auto cell = [](float v) {  // a cell is four steps wide
    return static_cast<std::uint32_t>((static_cast<std::int64_t>(v) + (std::int64_t{1} << 22)) >> 2);
  };
  return morton_code({cell(x), cell(y), cell(z)});
}

}  // namespace

double lattice_step(const PointArrays& points) {
  return round_step(extent_of(points).longest());
}

LatticePoints lattice_points(const PointArrays& points, double step) {
  const Extent e = extent_of(points);
  LatticePoints out;
  out.step = step == 0 ? round_step(e.longest()) : step;
  if (!(out.step > 0) || e.longest() > out.step * (kLatticeSteps * (1 + 1e-9)))
    throw Error(
        "step " + std::to_string(step) + ": at least 1/4,194,304 of the longest side of the points' box is needed",
        ExitCode::usage);
  const Vec3 middle = 0.5 * (e.min + e.max);
  const std::vector<float> x = offsets(points.x, middle.x, out.step, out.origin.x);
  const std::vector<float> y = offsets(points.y, middle.y, out.step, out.origin.y);
  const std::vector<float> z = offsets(points.z, middle.z, out.step, out.origin.z);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(x.size());
  for (std::uint32_t i = 0; i < x.size(); ++i) order[i] = {code_of(x[i], y[i], z[i]), i};
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    const std::uint32_t i = a.second, j = b.second;
    return std::tie(a.first, x[i], y[i], z[i], i) < std::tie(b.first, x[j], y[j], z[j], j);
  });
  const auto gather = [&](const std::vector<float>& from, std::vector<float>& to) {
    to.reserve(from.size() + kPadding);
    for (const auto& [code, i] : order) to.push_back(from[i]);
    to.resize(from.size() + kPadding, 0.0f);
  };
  gather(x, out.x);
  gather(y, out.y);
  gather(z, out.z);
  out.given.reserve(order.size());
  for (const auto& [code, i] : order) out.given.push_back(i);
  return out;
}

double in_steps(double length, double step, const char* what) {
  if (!(length > 0) || !std::isfinite(length)) throw Error(std::string(what) + ": must be above 0", ExitCode::usage);
  return length / step;
}

void on_threads(int threads, const std::function<void()>& body) {
  if (threads < 0 || threads > 1024) throw Error("threads: 0 to 1024", ExitCode::usage);
  with_threads(threads > 0 ? threads : hardware_threads(), body);
}

std::vector<PackedNormal> normals_of_all(const NeighbourIndex& index, const NormalsParams& params) {
  const std::size_t size = index.points.size;
  std::vector<PackedNormal> out(size);
  parallel_for((size + kBatch - 1) / kBatch, [&](std::size_t batch) {
    const std::size_t first = batch * kBatch, count = std::min(kBatch, size - first);
    std::vector<std::uint32_t> queries(count);
    std::vector<std::int64_t> reach2(count);
    std::iota(queries.begin(), queries.end(), static_cast<std::uint32_t>(first));
    normals(index, queries, params, std::span(out).subspan(first, count), reach2);
  });
  return out;
}

}  // namespace ilot
