// SPDX-License-Identifier: Apache-2.0
// Body of step_gains. Strips of all directions are found at once, a direction a lane, and the four sums of a strip are
// added together. Points come in rows, so that one after the other is in the same strip and waits for its sums; those
// of other directions do not. Gains are computed a strip a lane.

namespace {

constexpr std::size_t kSums = 4;
// The sums of a strip: a vector of the compiler's, in two registers where four doubles do not fit into one.
typedef double Sums __attribute__((vector_size(kSums * sizeof(double)), aligned(alignof(double)), may_alias));

// Derived: far above the rounding of sums over hundreds of points. Less is left of n only where the points beyond the
// line lie so that a tilt of the plane does the same as a step.
constexpr double kLeastLeft = 1e-9;

inline void add_to_strips(const StepGainsArgs& a) {
  const double last = kStrips - 1;
  for (std::size_t i = 0; i < a.points; ++i) {
    const double x = a.x[i], y = a.y[i];
    const Sums own = {1, x, y, a.residual[i]};
    std::int32_t strip[kDirections];
    for (std::size_t k = 0; k < kDirections; ++k) {
      double at = (x * a.ux[k] + y * a.uy[k] + a.radius) * a.per_metre;
      at = at < 0 ? 0 : at;
      at = at > last ? last : at;
      strip[k] = static_cast<std::int32_t>(at);
    }
    for (std::size_t k = 0; k < a.directions; ++k) {
      double* sums = a.strips + (k * kStrips + static_cast<std::size_t>(strip[k])) * kSums;
      *reinterpret_cast<Sums*>(sums) += own;
    }
  }
}

// Sums over a strip and those beyond it, for all strips of a direction.
struct Beyond {
  double n[kStrips], x[kStrips], y[kStrips], residual[kStrips], own[kStrips];
};

inline void sum_up(const double* strips, Beyond& out) {
  double n = 0, x = 0, y = 0, residual = 0;
  for (std::size_t b = kStrips; b-- > 0;) {
    const double* s = strips + b * kSums;
    n += s[0], x += s[1], y += s[2], residual += s[3];
    out.n[b] = n, out.x[b] = x, out.y[b] = y, out.residual[b] = residual, out.own[b] = s[0];
  }
}

inline void gains_of(const StepGainsArgs& a, const Beyond& sums, double* gain) {
  const D m0 = splat_d(a.inverse[0]), m1 = splat_d(a.inverse[1]), m2 = splat_d(a.inverse[2]),
          m3 = splat_d(a.inverse[3]), m4 = splat_d(a.inverse[4]), m5 = splat_d(a.inverse[5]);
  const D all = splat_d(static_cast<double>(a.points)), least = splat_d(a.least_points), none = splat_d(0);
  for (std::size_t b = 0; b < kStrips; b += kDoubles) {
    const D n = load_d(sums.n + b), x = load_d(sums.x + b), y = load_d(sums.y + b), r = load_d(sums.residual + b);
    const D form = n * (m0 * n + m1 * x + m2 * y) + x * (m1 * n + m3 * x + m4 * y) + y * (m2 * n + m4 * x + m5 * y);
    const D left = n - form;
    const DMask few = (n < least) | (all - n < least) | (load_d(sums.own + b) == none);
    const D value = select(splat_d(kLeastLeft) < left, r * r / left, none);
    store_d(gain + b, select(few, none, value));
  }
}

}  // namespace

void step_gains(const StepGainsArgs& a) {
  add_to_strips(a);
  for (std::size_t k = 0; k < a.directions; ++k) {
    Beyond sums;
    sum_up(a.strips + k * kStrips * kSums, sums);
    gains_of(a, sums, a.gain + k * kStrips);
    for (std::size_t b = 0; b < kStrips; ++b) a.beyond[k * kStrips + b] = sums.residual[b];
  }
}

// The last line exports the bodies compiled here under one name.
extern const StepGainsBody kStepGains;
const StepGainsBody kStepGains{step_gains};
