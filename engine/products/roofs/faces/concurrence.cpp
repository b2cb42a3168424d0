// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/concurrence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace ilot {
namespace {

// Derived: gaps of a decimetre shrink to a tenth of a millimetre.
constexpr double kPenalty = 1000;  // weight of an agreement, in points of the largest face
// Choice: slopes are regular (regular_planes.h), so faces rather move up or down; 100 gives no more level ridges.
constexpr double kTilt = 10;  // what a squared change by tilting costs, in squared changes of height
// Derived: a face with few points keeps its slope as if one more point lay a metre away on each side.
constexpr double kPrior = 1;  // points
constexpr int kReleases = 3;  // times that faces which would move too far are released
// Derived: the rounding of sums of thousands of doubles.
constexpr double kConverged = 1e-18;  // share of the squared residual

using Three = std::array<double, 3>;    // change of a plane: slope along x and y, height at the face's centre
using Matrix3 = std::array<double, 6>;  // symmetric: xx xy xz yy yz zz
struct Face {
  double x = 0, y = 0, points = 0;  // the mean of its points, metres
  Matrix3 normal{};                 // of the squared changes at its points
  Matrix3 cost{};                   // the same with the weight of a tilt
};
struct Member {
  std::uint32_t face;
  Three at;  // (x, y, 1) from the face's centre
  double height;
};
using Corner = std::vector<Member>;  // faces that are meant to meet

Three times(const Matrix3& m, const Three& v) {
  return {m[0] * v[0] + m[1] * v[1] + m[2] * v[2], m[1] * v[0] + m[3] * v[1] + m[4] * v[2],
          m[2] * v[0] + m[4] * v[1] + m[5] * v[2]};
}

double product(const Three& a, const Three& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void add_square(const Three& v, double weight, Matrix3& m) {
  const double square[6] = {v[0] * v[0], v[0] * v[1], v[0] * v[2], v[1] * v[1], v[1] * v[2], v[2] * v[2]};
  for (std::size_t i = 0; i < 6; ++i) m[i] += weight * square[i];
}

Matrix3 inverse(const Matrix3& m) {
  const double a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5], c = m[1] * m[4] - m[2] * m[3];
  const double det = m[0] * a + m[1] * b + m[2] * c;
  return {a / det,
          b / det,
          c / det,
          (m[0] * m[5] - m[2] * m[2]) / det,
          (m[1] * m[2] - m[0] * m[4]) / det,
          (m[0] * m[3] - m[1] * m[1]) / det};
}

class Adjustment {
 public:
  Adjustment(const Partition& p, std::span<const Vec3> points, std::span<const std::uint32_t> of_point,
             double tolerance, std::span<const RoofPlane> planes)
      : tolerance_(tolerance), faces_(planes.size()), fixed_(planes.size(), 0) {
    measure(points, of_point);
    find_corners(p, planes);
  }

  // The change of each plane.
  std::vector<Three> solve() {
    std::vector<Three> change;
    for (int round = 0; round <= kReleases; ++round) {
      change = solved();
      if (!release(change)) return change;
    }
    return std::vector<Three>(faces_.size(), Three{});
  }

  const Face& face(std::size_t f) const { return faces_[f]; }

 private:
  void measure(std::span<const Vec3> points, std::span<const std::uint32_t> of_point) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (of_point[i] == 0) continue;
      Face& f = faces_[of_point[i] - 1];
      f.x += points[i].x;
      f.y += points[i].y;
      f.points += 1;
    }
    for (Face& f : faces_) {
      f.x /= std::max(f.points, 1.0);
      f.y /= std::max(f.points, 1.0);
      most_ = std::max(most_, f.points);
      f.normal = {kPrior, 0, 0, kPrior, 0, kPrior};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (of_point[i] == 0) continue;
      Face& f = faces_[of_point[i] - 1];
      add_square({points[i].x - f.x, points[i].y - f.y, 1}, 1, f.normal);
    }
    for (Face& f : faces_) {
      f.cost = f.normal;
      for (double* tilt : {&f.cost[0], &f.cost[1], &f.cost[3]}) *tilt *= kTilt;
    }
  }

  void find_corners(const Partition& p, std::span<const RoofPlane> planes) {
    std::vector<std::vector<std::uint32_t>> around(p.vertices.size());
    for (const PartitionEdge& e : p.edges)
      for (const std::uint32_t v : {e.from, e.to})
        for (const std::uint32_t r : {e.left, e.right})
          if (r != kOutside) around[v].push_back(r - 1);
    for (std::size_t v = 0; v < around.size(); ++v) {
      std::sort(around[v].begin(), around[v].end());
      around[v].erase(std::unique(around[v].begin(), around[v].end()), around[v].end());
      const double x = p.vertices[v].x / 1000.0, y = p.vertices[v].y / 1000.0;
      std::vector<Member> members;
      for (const std::uint32_t f : around[v])
        members.push_back({f, {x - faces_[f].x, y - faces_[f].y, 1}, planes[f].at(x, y)});
      std::stable_sort(members.begin(), members.end(),
                       [](const Member& a, const Member& b) { return a.height < b.height; });
      for (std::size_t first = 0; first < members.size();) {
        std::size_t last = first + 1;
        while (last < members.size() && members[last].height - members[last - 1].height <= tolerance_) ++last;
        if (last - first > 1)
          corners_.emplace_back(members.begin() + static_cast<std::ptrdiff_t>(first),
                                members.begin() + static_cast<std::ptrdiff_t>(last));
        first = last;
      }
    }
  }

  // Adds for each corner the penalty times what `value` of each member differs from their mean, times its place.
  template <class Value>
  void add_corners(const Value& value, std::vector<Three>& to) const {
    for (const Corner& corner : corners_) {
      double mean = 0, members = 0;
      for (const Member& m : corner)
        if (fixed_[m.face] == 0) mean += value(m), members += 1;
      if (members < 2) continue;
      mean /= members;
      for (const Member& m : corner) {
        if (fixed_[m.face] != 0) continue;
        const double weight = kPenalty * most_ * (value(m) - mean);
        for (std::size_t k = 0; k < 3; ++k) to[m.face][k] += weight * m.at[k];
      }
    }
  }

  std::vector<Three> applied(const std::vector<Three>& change) const {
    std::vector<Three> out(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) out[f] = times(faces_[f].cost, change[f]);
    add_corners([&](const Member& m) { return product(m.at, change[m.face]); }, out);
    return out;
  }

  std::vector<Matrix3> preconditioners() const {
    std::vector<Matrix3> blocks;
    for (const Face& f : faces_) blocks.push_back(f.cost);
    for (const Corner& corner : corners_)
      for (const Member& m : corner)
        if (fixed_[m.face] == 0) add_square(m.at, kPenalty * most_ / 2, blocks[m.face]);
    for (Matrix3& m : blocks) m = inverse(m);
    return blocks;
  }

  std::vector<Three> solved() const {
    const std::size_t n = faces_.size();
    const std::vector<Matrix3> blocks = preconditioners();
    std::vector<Three> change(n, Three{}), rest(n, Three{}), scaled(n), direction;
    add_corners([](const Member& m) { return -m.height; }, rest);
    const auto sum = [&](const std::vector<Three>& a, const std::vector<Three>& b) {
      double s = 0;
      for (std::size_t f = 0; f < n; ++f) s += product(a[f], b[f]);
      return s;
    };
    const auto scale = [&] {
      for (std::size_t f = 0; f < n; ++f) scaled[f] = times(blocks[f], rest[f]);
      return sum(rest, scaled);
    };
    double size = scale();
    const double first = size;
    direction = scaled;
    for (std::size_t round = 0; round < 6 * n + 50 && size > kConverged * first && size > 0; ++round) {
      const std::vector<Three> image = applied(direction);
      const double step = size / sum(direction, image);
      for (std::size_t f = 0; f < n; ++f)
        for (std::size_t k = 0; k < 3; ++k) {
          change[f][k] += step * direction[f][k];
          rest[f][k] -= step * image[f][k];
        }
      const double before = size;
      size = scale();
      for (std::size_t f = 0; f < n; ++f)
        for (std::size_t k = 0; k < 3; ++k) direction[f][k] = scaled[f][k] + size / before * direction[f][k];
    }
    return change;
  }

  // Releases the faces that would move too far from their points. Returns false when there are none.
  bool release(const std::vector<Three>& change) {
    bool any = false;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const double moved2 = product(change[f], times(faces_[f].normal, change[f])) / (faces_[f].points + kPrior);
      if (fixed_[f] != 0 || moved2 <= tolerance_ * tolerance_ / 4) continue;
      fixed_[f] = 1;
      any = true;
    }
    for (const Corner& corner : corners_)
      for (const Member& m : corner) {
        if (fixed_[m.face] != 0 || std::abs(product(m.at, change[m.face])) <= tolerance_) continue;
        fixed_[m.face] = 1;
        any = true;
      }
    return any;
  }

  double tolerance_, most_ = 1;
  std::vector<Face> faces_;
  std::vector<std::uint8_t> fixed_;
  std::vector<Corner> corners_;
};

}  // namespace

void adjust_to_concur(const Partition& faces, std::span<const Vec3> points, std::span<const std::uint32_t> of_point,
                      double tolerance, std::vector<RoofPlane>& planes) {
  if (planes.size() < 2 || !(tolerance > 0)) return;
  Adjustment adjustment(faces, points, of_point, tolerance, planes);
  const std::vector<Three> change = adjustment.solve();
  for (std::size_t f = 0; f < planes.size(); ++f) {
    planes[f].gx += change[f][0];
    planes[f].gy += change[f][1];
    planes[f].c += change[f][2] - change[f][0] * adjustment.face(f).x - change[f][1] * adjustment.face(f).y;
  }
}

}  // namespace ilot
