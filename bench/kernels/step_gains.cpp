// SPDX-License-Identifier: Apache-2.0
// Gains of lines that part the points of a window with a step, beside the loop that one writes first: for each
// direction sums of its strips, then each line. The gains must be the same bits before any timing.
#include "kernels/planes/step_gains.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/compare.h"
#include "kernels/core/rng.h"

namespace {

using namespace ilot;

constexpr double kLeast = 6;  // points of a side

struct Window {
  std::vector<double> x, y, residual;
  PlaneInverse inverse;

  StepWindow view() const { return {x, y, residual, 1, inverse, kLeast}; }
};

// Points at random in a circle, whose residuals have a step. Any inverse that is near the true one does for the time.
Window make_window(std::uint64_t seed) {
  Window w;
  Rng rng(seed, 9);
  while (w.x.size() < 120) {
    const double x = 2 * rng.uniform() - 1, y = 2 * rng.uniform() - 1;
    if (x * x + y * y > 1) continue;
    w.x.push_back(x), w.y.push_back(y), w.residual.push_back((x > 0.1 ? 0.05 : -0.05) + 0.02 * rng.uniform());
  }
  const auto n = static_cast<double>(w.x.size());
  w.inverse = {1 / n, 0, 0, 4 / n, 0, 4 / n};
  return w;
}

void plain_loop(const StepWindow& w, std::span<const StepDirection> directions, StepGains& out) {
  const double per = kStepStrips / (2 * w.radius), all = static_cast<double>(w.x.size());
  const PlaneInverse& m = w.inverse;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    struct Sums {
      double n = 0, x = 0, y = 0, residual = 0;
    };
    std::array<Sums, kStepStrips> strips{};
    for (std::size_t i = 0; i < w.x.size(); ++i) {
      const double t = w.x[i] * directions[k].x + w.y[i] * directions[k].y;
      const int strip = std::clamp(static_cast<int>((t + w.radius) * per), 0, static_cast<int>(kStepStrips) - 1);
      Sums& s = strips[static_cast<std::size_t>(strip)];
      s.n += 1, s.x += w.x[i], s.y += w.y[i], s.residual += w.residual[i];
    }
    Sums up;
    for (std::size_t b = kStepStrips; b-- > 0;) {
      const Sums& s = strips[b];
      up.n += s.n, up.x += s.x, up.y += s.y, up.residual += s.residual;
      const double form = up.n * (m.a * up.n + m.b * up.x + m.c * up.y) +
                          up.x * (m.b * up.n + m.d * up.x + m.e * up.y) + up.y * (m.c * up.n + m.e * up.x + m.f * up.y);
      const double left = up.n - form;
      const bool few = s.n == 0 || up.n < w.least_points || all - up.n < w.least_points;
      out.gain[k * kStepStrips + b] = few || left <= 1e-9 ? 0 : up.residual * up.residual / left;
      out.residual[k * kStepStrips + b] = up.residual;
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<StepDirection> directions;
  for (std::size_t k = 0; k < kStepDirections; ++k) {
    const double turn = 3.14159265358979 * static_cast<double>(k) / kStepDirections;
    directions.push_back({std::cos(turn), std::sin(turn)});
  }
  for (const double millions : bench::numbers(argc, argv, {0.01})) {
    std::vector<Window> windows;
    for (std::size_t i = 0; i < static_cast<std::size_t>(millions * 1e6); ++i) windows.push_back(make_window(i));
    StepGains ours, theirs;
    for (const Window& w : windows) {
      step_gains(w.view(), directions, ours);
      plain_loop(w.view(), directions, theirs);
      bench::require(ours.gain == theirs.gain && ours.residual == theirs.residual, "step_gains: gains differ");
    }
    double sink = 0;
    const auto of_all = [&](const auto& gains_of, StepGains& out) {
      for (const Window& w : windows) gains_of(w.view(), directions, out), sink += out.gain[10];
    };
    bench::compare(
        {"step_gains", "16 directions, 120 points a window", 1, millions * 1e6 * 120 * kStepDirections / 1e6,
         "M point-directions"},
        {{"ilot", [&] { of_all(step_gains, ours); }}, {"loop over directions", [&] { of_all(plain_loop, theirs); }}});
    bench::require(sink > 0, "step_gains: nothing was computed");
  }
}
