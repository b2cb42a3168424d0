// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/hough_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "kernels/core/portable_math.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/shapes/shape_score.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

// Derived: 180 / pi.
constexpr double kDegreesPerRadian = 57.29577951308232;
// Derived: a bound of memory.
constexpr double kMaxBins = 4096;
constexpr int kRounds = 30;  // a peak is only near the middle of a plane, and each round reaches farther

// For a normal, the directions that may agree with it, as lists by cell of the upper faces of a cube.
class DirectionLists {
 public:
  DirectionLists(const std::vector<Vec3>& directions, double min_cos) : lists_(min_cos > 0 ? 3 * kSide * kSide : 1) {
    for (std::size_t cell = 0; cell < lists_.size(); ++cell) {
      // Half the diagonal of a cell is at most root 2 / kSide on the face of the cube, so it is less as an angle.
      const Vec3 centre = min_cos > 0 ? centre_of(cell) : Vec3{};
      const double least = min_cos > 0 ? min_cos * kInCell.cosine - std::sqrt(1 - min_cos * min_cos) * kInCell.sine : 0;
      for (std::uint32_t d = 0; d < directions.size(); ++d)
        if (std::abs(dot(directions[d], centre)) >= least) lists_[cell].push_back(d);
    }
  }
  const Indices& of(Vec3 n) const { return lists_.size() == 1 ? lists_[0] : lists_[cell_of(n)]; }

 private:
  static constexpr int kSide = 32;
  struct Angle {
    double sine, cosine;
  };
  static constexpr Angle kInCell{0.0445, 0.99901};  // sine above root 2 / kSide, cosine below what goes with it

  static std::size_t cell_of(Vec3 n) {
    const double v[3]{n.x, n.y, n.z};
    const int axis = std::abs(n.x) >= std::abs(n.y) && std::abs(n.x) >= std::abs(n.z) ? 0
                     : std::abs(n.y) >= std::abs(n.z)                                 ? 1
                                                                                      : 2;
    const auto part = [&](int a) {
      const double t = v[a % 3] / v[axis];  // within [-1, 1]; the same for n and -n
      return std::clamp(static_cast<int>((t + 1) / 2 * kSide), 0, kSide - 1);
    };
    return static_cast<std::size_t>((axis * kSide + part(axis + 1)) * kSide + part(axis + 2));
  }
  static Vec3 centre_of(std::size_t cell) {
    const auto at = [](std::size_t i) { return (2 * static_cast<double>(i) + 1) / kSide - 1; };
    const std::size_t axis = cell / (kSide * kSide);
    std::array<double, 3> v{};
    v[axis] = 1;
    v[(axis + 1) % 3] = at(cell / kSide % kSide);
    v[(axis + 2) % 3] = at(cell % kSide);
    const Vec3 c{v[0], v[1], v[2]};
    return (1 / norm(c)) * c;
  }
  std::vector<Indices> lists_;
};

class Transform {
 public:
  Transform(const OrientedPoints& points, const HoughPlanesParams& params)
      : points_(points),
        params_(params),
        directions_(equal_angle_directions(params.degrees)),
        lists_(directions_, params.min_vote_cos) {
    Indices all(points.points.size);
    std::iota(all.begin(), all.end(), 0u);
    left_ = build_shape_index(points, all);
    reach_ = left_.reach + 1;
    step_ = std::max({1.0, params.distance_step, 2 * reach_ / kMaxBins});
    bins_ = static_cast<std::size_t>(2 * reach_ / step_) + 1;
    votes_.assign(directions_.size() * bins_, 0);
    top_.resize(directions_.size());
    stale_.assign(directions_.size(), 1);
    result_.label.assign(points.points.size, 0);
    Indices everything(left_.size);
    std::iota(everything.begin(), everything.end(), 0u);
    vote(everything, 1);
  }

  PlaneSegments run() {
    const std::uint32_t least = std::max(3u, params_.min_points / 4);
    for (;;) {
      const std::size_t cell = peak();
      if (votes_[cell] < least) break;
      const Indices members = plane_at(cell);
      if (members.empty()) {
        dead_.push_back(cell);
        discard_cell(cell);
        continue;
      }
      for (const std::uint32_t i : members)
        result_.label[left_.index[i]] = static_cast<std::uint32_t>(result_.planes.size());
      vote(members, static_cast<std::uint32_t>(-1));
      for (const std::size_t d : dead_) discard_cell(d);
      take_out(left_, members);
    }
    return std::move(result_);
  }

 private:
  std::size_t bin(const Vec3& direction, Vec3 p) const {
    return static_cast<std::size_t>((dot(direction, p - left_.centre) + reach_) / step_);
  }
  bool votes_for(const Vec3& normal, const Vec3& direction) const {
    return params_.min_vote_cos <= 0 || std::abs(dot(direction, normal)) >= params_.min_vote_cos;
  }

  // Adds to the cells of all planes through the points (positions). -1 subtracts.
  void vote(const Indices& voters, std::uint32_t by) {
    for (const std::uint32_t i : voters) {
      const Vec3 p = left_.position(i), n = left_.normal(i);
      for (const std::uint32_t d : lists_.of(n)) {
        if (!votes_for(n, directions_[d])) continue;
        votes_[d * bins_ + bin(directions_[d], p)] += by;
        stale_[d] = 1;
      }
    }
  }

  // Discards a cell that gave no plane. Votes that are subtracted later would make it wrap around, so it is discarded
  // again after each.
  void discard_cell(std::size_t cell) {
    votes_[cell] = 0;
    stale_[cell / bins_] = 1;
  }

  // Returns the cell with most votes, the first of equal ones. Only rows that changed are searched again.
  std::size_t peak() {
    std::size_t best = 0;
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      if (stale_[d] != 0) {
        const auto row = votes_.begin() + static_cast<std::ptrdiff_t>(d * bins_);
        top_[d] =
            static_cast<std::size_t>(std::max_element(row, row + static_cast<std::ptrdiff_t>(bins_)) - votes_.begin());
        stale_[d] = 0;
      }
      if (d == 0 || votes_[top_[d]] > votes_[best]) best = top_[d];
    }
    return best;
  }

  Points positions() const { return {left_.x.data(), left_.y.data(), left_.z.data(), left_.size}; }

  Indices largest_part(const Indices& members) const {
    const Clusters clusters = euclidean_clusters(positions(), members, params_.connectivity);
    Indices size(clusters.count, 0);
    for (const std::uint32_t c : clusters.id) ++size[c];
    if (size.empty()) return {};
    const auto chosen = static_cast<std::uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
    Indices part;
    for (std::size_t i = 0; i < members.size(); ++i)
      if (clusters.id[i] == chosen) part.push_back(members[i]);
    return part;
  }

  Indices voters_of(std::size_t cell) const {
    const Vec3 direction = directions_[cell / bins_];
    const double rho = (static_cast<double>(cell % bins_) + 0.5) * step_ - reach_;
    const Shape slab{ShapeKind::kPlane, left_.centre + rho * direction, direction};
    Indices voters;
    for (const std::uint32_t i : points_on_shape(left_, slab, {0.51 * step_, std::max(0.0, params_.min_vote_cos)}))
      if (bin(direction, left_.position(i)) == cell % bins_) voters.push_back(i);
    return voters;
  }

  // Finds the plane that the voters of a cell start. Returns the positions of its points, empty when there are too few.
  Indices plane_at(std::size_t cell) {
    PlaneFit fit = fit_plane(moments_of(positions(), largest_part(voters_of(cell))));
    Indices members;
    Plane plane;
    for (int round = 0; round < kRounds && fit.unique; ++round) {
      plane = fit.plane;
      Indices next = largest_part(points_on_shape(left_, shape_of(plane), {params_.epsilon, params_.min_cos}));
      const bool converged = next == members;
      members = std::move(next);
      if (converged || members.size() < 3) break;
      fit = fit_plane(moments_of(positions(), members));
    }
    if (members.size() < params_.min_points) return {};
    result_.planes.push_back(plane);
    return members;
  }

  OrientedPoints points_;
  HoughPlanesParams params_;
  std::vector<Vec3> directions_;
  DirectionLists lists_;
  ShapeIndex left_;  // points without a plane
  double reach_ = 0, step_ = 1;
  std::size_t bins_ = 0;
  Indices votes_;                    // directions x bins
  std::vector<std::size_t> top_;     // per direction: its best cell
  std::vector<std::uint8_t> stale_;  // per direction: 1 when its best cell must be searched again
  std::vector<std::size_t> dead_;    // cells that gave no plane
  PlaneSegments result_;
};

}  // namespace

std::vector<Vec3> equal_angle_directions(double degrees) {
  const double edge = degrees / kDegreesPerRadian;
  const auto bands = static_cast<std::size_t>(std::ceil(90 / degrees));
  std::vector<std::size_t> cells(bands);
  std::size_t total = 0;
  for (std::size_t b = 0; b < bands; ++b) {
    const double middle = 90 * (static_cast<double>(b) + 0.5) / static_cast<double>(bands);
    // Derived: 2 pi.
    constexpr double kTurn = 6.283185307179586;
    cells[b] = std::max<std::size_t>(1, static_cast<std::size_t>(std::nearbyint(kTurn * cos_degrees(middle) / edge)));
    total += cells[b];
  }
  std::vector<Vec3> directions;
  std::size_t below = 0;
  for (std::size_t b = 0; b < bands; ++b) {
    // The share of a band in the height is its share of the area (Archimedes).
    const double z = (static_cast<double>(below) + 0.5 * static_cast<double>(cells[b])) / static_cast<double>(total);
    const double across = std::sqrt(1 - z * z);
    for (std::size_t j = 0; j < cells[b]; ++j) {
      const double theta = 360 * (static_cast<double>(j) + 0.5) / static_cast<double>(cells[b]);
      directions.push_back({across * cos_degrees(theta), across * cos_degrees(theta - 90), z});
    }
    below += cells[b];
  }
  return directions;
}

PlaneSegments hough_planes(const OrientedPoints& points, const HoughPlanesParams& params) {
  if (points.points.size == 0) return {};
  return Transform(points, params).run();
}

}  // namespace ilot
