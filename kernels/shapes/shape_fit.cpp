// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_fit.h"

#include <algorithm>
#include <array>
#include <vector>

#include "kernels/planes/plane_fit.h"

namespace ilot {
namespace {

constexpr std::size_t kMost = 6;  // parameters of a cone
constexpr int kMaxSteps = 30;
// Derived: far below the noise, far above the rounding of doubles.
constexpr double kConverged = 1e-9;  // relative gain of a step that ends the fit

using Row = std::array<double, kMost>;

// Directions in which the parameters move. The origin moves along three axes (cylinder: two perpendicular to its axis).
// The axis has two tilts.
struct Frame {
  Vec3 e1, e2;
};

Frame frame_across(Vec3 u) {
  const Vec3 a = std::abs(u.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  Vec3 e1 = cross(u, a);
  e1 = (1 / norm(e1)) * e1;
  return {e1, cross(u, e1)};
}

std::size_t parameters_of(ShapeKind kind) {
  return kind == ShapeKind::kSphere ? 4 : kind == ShapeKind::kCylinder ? 5 : 6;
}

struct Residual {
  double value = 0;
  Row slope{};
};

Residual residual_of(const Shape& s, const Frame& f, Vec3 p) {
  const Vec3 v = p - s.origin;
  const double h = s.kind == ShapeKind::kSphere ? 0 : dot(v, s.axis);
  const Vec3 q = v - h * s.axis;
  const double across = norm(q);
  const Vec3 out = across > 0 ? (1 / across) * q : Vec3{};
  if (s.kind == ShapeKind::kSphere) return {across - s.radius, {-out.x, -out.y, -out.z, -1}};
  const double g1 = dot(out, f.e1), g2 = dot(out, f.e2);
  if (s.kind == ShapeKind::kCylinder) return {across - s.radius, {-g1, -g2, -h * g1, -h * g2, -1}};
  const Vec3 o = s.sine * s.axis - s.cosine * out;
  const double lever = -(h * s.cosine + across * s.sine);
  return {across * s.cosine - h * s.sine, {o.x, o.y, o.z, lever * g1, lever * g2, lever}};
}

Shape moved(const Shape& s, const Frame& f, const Row& d) {
  Shape r = s;
  const auto tilt = [&](double a, double b) {
    r.axis = s.axis + a * f.e1 + b * f.e2;
    r.axis = (1 / norm(r.axis)) * r.axis;
  };
  if (s.kind == ShapeKind::kSphere) {
    r.origin = s.origin + Vec3{d[0], d[1], d[2]};
    r.radius = s.radius + d[3];
  } else if (s.kind == ShapeKind::kCylinder) {
    r.origin = s.origin + d[0] * f.e1 + d[1] * f.e2;
    tilt(d[2], d[3]);
    r.radius = s.radius + d[4];
  } else {
    r.origin = s.origin + Vec3{d[0], d[1], d[2]};
    tilt(d[3], d[4]);
    const double sine = s.sine + d[5] * s.cosine, cosine = s.cosine - d[5] * s.sine;
    const double length = std::sqrt(sine * sine + cosine * cosine);
    r.sine = sine / length;
    r.cosine = cosine / length;
  }
  return r;
}

bool sensible(const Shape& s) {
  if (s.kind == ShapeKind::kCone) return s.sine > 0 && s.cosine > 0;
  return s.radius > 0 && s.radius < 0x1p40;
}

struct Normal {
  std::array<Row, kMost> a{};  // lower triangle
  Row b{};
  double error = 0;
};

Normal normal_equations(const Shape& s, const Frame& f, std::span<const Vec3> points) {
  const std::size_t m = parameters_of(s.kind);
  Normal n;
  for (const Vec3& p : points) {
    const Residual r = residual_of(s, f, p);
    n.error += r.value * r.value;
    for (std::size_t i = 0; i < m; ++i) {
      n.b[i] -= r.slope[i] * r.value;
      for (std::size_t j = 0; j <= i; ++j) n.a[i][j] += r.slope[i] * r.slope[j];
    }
  }
  return n;
}

double error_of(const Shape& s, std::span<const Vec3> points) {
  double error = 0;
  for (const Vec3& p : points) {
    const double d = view_of(s, p).distance;
    error += d * d;
  }
  return error;
}

// Solves by Cholesky. Returns false where the matrix is not safely positive definite.
bool solve(Normal n, std::size_t m, double damping, Row& x) {
  for (std::size_t i = 0; i < m; ++i) n.a[i][i] *= 1 + damping;
  for (std::size_t i = 0; i < m; ++i) {
    const double diagonal = n.a[i][i];
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = n.a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= n.a[i][k] * n.a[j][k];
      if (i != j) {
        n.a[i][j] = sum / n.a[j][j];
      } else {
        if (!(sum > 1e-13 * diagonal)) return false;
        n.a[i][i] = std::sqrt(sum);
      }
    }
  }
  for (std::size_t i = 0; i < m; ++i) {
    double sum = n.b[i];
    for (std::size_t k = 0; k < i; ++k) sum -= n.a[i][k] * x[k];
    x[i] = sum / n.a[i][i];
  }
  for (std::size_t i = m; i-- > 0;) {
    for (std::size_t k = i + 1; k < m; ++k) x[i] -= n.a[k][i] * x[k];
    x[i] /= n.a[i][i];
  }
  return true;
}

ShapeFit fit_curved(std::span<const Vec3> points, const Shape& start) {
  const std::size_t m = parameters_of(start.kind);
  ShapeFit fit{start};
  if (points.size() < m) return fit;
  if (start.kind == ShapeKind::kCylinder) {  // rotations are well conditioned when the origin is amid the points
    Vec3 sum;
    for (const Vec3& p : points) sum = sum + p;
    const Vec3 centre = (1 / static_cast<double>(points.size())) * sum;
    fit.shape.origin = start.origin + dot(centre - start.origin, start.axis) * start.axis;
  }
  double damping = 1e-3;
  bool solved = false;
  Frame frame = frame_across(fit.shape.axis);
  Normal n = normal_equations(fit.shape, frame, points);
  for (int step = 0; step < kMaxSteps && damping < 1e6; ++step) {
    Row delta{};
    if (!solve(n, m, damping, delta)) {
      damping *= 10;
      continue;
    }
    solved = true;
    const Shape next = moved(fit.shape, frame, delta);
    const double error = sensible(next) ? error_of(next, points) : INFINITY;
    if (!(error <= n.error)) {
      damping *= 10;
      continue;
    }
    const bool converged = n.error - error <= kConverged * n.error;
    fit.shape = next;
    ++fit.iterations;
    damping = std::max(1e-9, damping / 10);
    frame = frame_across(next.axis);
    n = normal_equations(next, frame, points);
    if (converged) break;
  }
  fit.rms = std::sqrt(n.error / static_cast<double>(points.size()));
  fit.valid = solved && sensible(fit.shape);
  return fit;
}

}  // namespace

ShapeFit fit_shape(Points points, std::span<const std::uint32_t> indices, const Shape& start) {
  if (start.kind == ShapeKind::kPlane) {
    const PlaneFit fit = fit_plane(moments_of(points, indices));
    if (!fit.unique) return {start};
    return {shape_of(fit.plane), fit.rms, 1, true};
  }
  const std::size_t stride = std::max<std::size_t>(1, indices.size() / kFitPoints);
  std::vector<Vec3> used;
  used.reserve(indices.size() / stride + 1);
  for (std::size_t i = 0; i < indices.size(); i += stride) {
    const std::uint32_t k = indices[i];
    used.push_back({points.x[k], points.y[k], points.z[k]});
  }
  return fit_curved(used, start);
}

}  // namespace ilot
