// SPDX-License-Identifier: Apache-2.0
// Hough normals, compared with a direct implementation of the same method as its paper describes it (Boulch and Marlet
// 2012), with nanoflann and Eigen. In each of five rotations, up to 700 random triplets vote into bins of polar angles
// until the leading bin is significantly ahead. The mean of the best bin of all rotations wins. Both implementations
// are random, so equal bits are not required. Instead, both must be near the truth of a ridge of 45 degrees, away from
// its edge and also at it, where principal components fail.
#include "kernels/neighbours/hough_normals.h"

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "bench/compare.h"
#include "bench/eigen_normals.h"
#include "kernels/core/quantile.h"
#include "kernels/neighbours/knn.h"

namespace {

using namespace ilot;

constexpr std::size_t kNeighbours = 30;
constexpr double kPi = 3.141592653589793;

// ---- the direct implementation

class DirectHough {
 public:
  DirectHough() {
    std::mt19937 random(1);
    for (auto& r : rotations_)
      r = Eigen::AngleAxisd(std::uniform_real_distribution<>(0, 2 * kPi)(random),
                            Eigen::Vector3d::Random().normalized());
  }

  Eigen::Vector3d operator()(const bench::PeerTree& peer, std::uint32_t query, std::mt19937& random) const {
    std::uint32_t index[kNeighbours];
    double d2[kNeighbours];
    const Points& p = peer.adaptor.p;
    const float at[3]{p.x[query], p.y[query], p.z[query]};
    peer.tree.knnSearch(at, kNeighbours, index, d2);
    Eigen::Matrix<double, 3, kNeighbours> points;
    for (std::size_t i = 0; i < kNeighbours; ++i)
      points.col(static_cast<int>(i)) << p.x[index[i]] - at[0], p.y[index[i]] - at[1], p.z[index[i]] - at[2];
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    int most = 0;
    for (const Eigen::Matrix3d& rotation : rotations_) {
      int votes = 0;
      const Eigen::Vector3d n = rotation.transpose() * leading_mean(rotation * points, random, votes);
      if (votes <= most) continue;
      most = votes;
      best = n;
    }
    return best.normalized();
  }

 private:
  static constexpr int kPhi = 15, kTheta = 2 * kPhi, kTriplets = 700;

  static Eigen::Vector3d leading_mean(const Eigen::Matrix<double, 3, kNeighbours>& points, std::mt19937& random,
                                      int& votes) {
    std::array<int, kPhi * kTheta> counts{};
    std::array<Eigen::Vector3d, kPhi * kTheta> sums;
    sums.fill(Eigen::Vector3d::Zero());
    std::uniform_int_distribution<int> any(0, kNeighbours - 1);
    int first = 0, second = 0;
    for (int drawn = 1; drawn <= kTriplets; ++drawn) {
      const int i = any(random), j = any(random), k = any(random);
      Eigen::Vector3d n = (points.col(j) - points.col(i)).cross(points.col(k) - points.col(i));
      const double length = n.norm();
      if (!(length > 0)) continue;
      n /= length;
      if (n.z() < 0) n = -n;
      const int phi = std::min(static_cast<int>(std::acos(n.z()) * (2 * kPhi / kPi) / 2), kPhi - 1);
      const int theta = static_cast<int>((std::atan2(n.y(), n.x()) + kPi) * (kTheta / (2 * kPi))) % kTheta;
      const int bin = phi * kTheta + theta;
      const auto at = static_cast<std::size_t>(bin);
      sums[at] += n;
      ++counts[at];
      if (bin == first) continue;
      if (counts[at] > counts[static_cast<std::size_t>(first)]) {
        second = first;
        first = bin;
      } else if (second == first || counts[at] > counts[static_cast<std::size_t>(second)]) {
        second = bin;
      }
      const double lead = counts[static_cast<std::size_t>(first)] - counts[static_cast<std::size_t>(second)];
      if (drawn > 30 && second != first && lead / drawn >= 2 / std::sqrt(drawn)) break;
    }
    votes = counts[static_cast<std::size_t>(first)];
    return sums[static_cast<std::size_t>(first)];
  }

  std::array<Eigen::Matrix3d, 5> rotations_;
};

// ---- a ridge of 45 degrees, 12 points per square metre, 2 cm of noise

struct Ridge {
  bench::Surface surface;
  double middle = 15000;
};

Ridge make_ridge() {
  Ridge ridge;
  Rng rng(3);
  std::vector<std::uint64_t> codes(10800);
  for (auto& code : codes) {
    const double x = rng.uniform() * 30000, y = rng.uniform() * 30000;
    double noise = -6;
    for (int i = 0; i < 12; ++i) noise += rng.uniform();
    const double z = 20000 - std::abs(x - ridge.middle) + 20 * noise;
    code = morton_code({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)});
  }
  ridge.surface = bench::surface_of(std::move(codes));
  return ridge;
}

struct Errors {
  std::vector<double> edge, flat;  // degrees; within 0.29 m (one step) of the edge, and farther than four steps
};

template <class Normal>
Errors errors_of(const Ridge& ridge, const Normal& normal) {
  Errors errors;
  for (std::uint32_t i = 0; i < ridge.surface.size; ++i) {
    const double from = ridge.surface.x[i] - ridge.middle;
    const Eigen::Vector3d truth = Eigen::Vector3d(from > 0 ? 1 : -1, 0, 1).normalized();
    const double error = std::acos(std::min(1.0, std::abs(truth.dot(normal(i))))) * 180 / kPi;
    if (std::abs(from) < 288) errors.edge.push_back(error);
    if (std::abs(from) > 4 * 288) errors.flat.push_back(error);
  }
  return errors;
}

void report_edges(const bench::PeerTree& peer, const Ridge& ridge, const DirectHough& direct) {
  const NeighbourIndex index = build_neighbour_index(ridge.surface.view());
  const auto queries = bench::all_of(ridge.surface.size);
  std::vector<PackedNormal> hough(queries.size()), pca(queries.size());
  std::vector<std::int64_t> reach2(queries.size());
  hough_normals(index, queries, {.k = kNeighbours, .max_d2 = kMaxSquaredReach}, hough, reach2);
  normals(index, queries, {kNeighbours, kMaxSquaredReach}, pca, reach2);
  const auto unpacked = [](const PackedNormal& n) { return Eigen::Vector3d(n.x, n.y, n.z).normalized(); };
  const Errors ours = errors_of(ridge, [&](std::uint32_t i) { return unpacked(hough[i]); });
  const Errors rounded = errors_of(ridge, [&](std::uint32_t i) { return unpacked(pca[i]); });
  std::mt19937 random(2);
  const Errors theirs = errors_of(ridge, [&](std::uint32_t i) { return direct(peer, i, random); });
  bench::report({.kernel = "hough_normals", .variant = "error within 0.29 m of a 45 degree ridge, median degrees"},
                {{"ilot", upper_median(std::vector(ours.edge))},
                 {"direct, nanoflann + Eigen", upper_median(std::vector(theirs.edge))},
                 {"principal components", upper_median(std::vector(rounded.edge))}});
  bench::report({.kernel = "hough_normals", .variant = "error away from the ridge, median degrees"},
                {{"ilot", upper_median(std::vector(ours.flat))},
                 {"direct, nanoflann + Eigen", upper_median(std::vector(theirs.flat))},
                 {"principal components", upper_median(std::vector(rounded.flat))}});
  bench::require(upper_median(std::vector(ours.edge)) < 5 && upper_median(std::vector(theirs.edge)) < 10 &&
                     upper_median(std::vector(rounded.edge)) > 20,
                 "hough_normals: a method does not do what it is for");
}

}  // namespace

int main(int argc, char** argv) {
  const DirectHough direct;
  const Ridge ridge = make_ridge();
  report_edges(bench::PeerTree(ridge.surface.view()), ridge, direct);
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface surface = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const NeighbourIndex index = build_neighbour_index(surface.view());
    const bench::PeerTree peer(surface.view());
    std::vector<std::uint32_t> queries(std::min<std::size_t>(surface.size, 50000));
    std::iota(queries.begin(), queries.end(), static_cast<std::uint32_t>((surface.size - queries.size()) / 2));
    std::vector<PackedNormal> out(queries.size());
    std::vector<std::int64_t> reach2(queries.size());
    const auto ours = [&] {
      bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
        hough_normals(index, std::span(queries).subspan(begin, end - begin),
                      {.k = kNeighbours, .max_d2 = kMaxSquaredReach}, std::span(out).subspan(begin, end - begin),
                      std::span(reach2).subspan(begin, end - begin));
      });
    };
    const auto theirs = [&] {
      bench::in_grains(queries.size(), [&](std::size_t begin, std::size_t end) {
        std::mt19937 random(static_cast<unsigned>(begin));
        double sum = 0;
        for (std::size_t i = begin; i < end; ++i) sum += direct(peer, queries[i], random).z();
        bench::require(sum == sum, "hough_normals: the direct implementation gave no number");
      });
    };
    bench::compare({"hough_normals", "k=30, " + bench::in_millions(millions), 1,
                    static_cast<double>(queries.size()) / 1e6, "M points"},
                   {{"ilot", ours}, {"direct, nanoflann + Eigen", theirs}});
    bench::scaling({.kernel = "hough_normals", .variant = "k=30"}, ours);
  }
}
