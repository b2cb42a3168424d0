// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_bins.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "kernels/core/eigen3.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

// Derived: keeps the ratios of a single bin finite, at 0; a micrometre squared.
constexpr double kLeastSpread = 1e-12;  // square metres

// The occupied bins of one candidate: their number, the sum of the numbers of their occupied neighbours, and the sums
// of their positions, from the first of them, in metres.
struct Bins {
  std::uint64_t count = 0, neighbours = 0;
  std::uint32_t lowest = kOccupancyBins;
  double x0 = 0, y0 = 0;
  Vec3 sum;
  Symmetric3 squares;

  void add(const Vec3& p) {
    sum = sum + p;
    squares.xx += p.x * p.x, squares.xy += p.x * p.y, squares.xz += p.x * p.z;
    squares.yy += p.y * p.y, squares.yz += p.y * p.z, squares.zz += p.z * p.z;
  }

  Symmetric3 covariance() const {
    const double n = static_cast<double>(count);
    const Vec3 m = (1 / n) * sum;
    return {squares.xx / n - m.x * m.x, squares.xy / n - m.x * m.y, squares.xz / n - m.x * m.z,
            squares.yy / n - m.y * m.y, squares.yz / n - m.y * m.z, squares.zz / n - m.z * m.z};
  }
};

// How many pairs of an occupied bin of `own` and a bin of `beside` that touches it there are, bins above and below
// included.
std::uint64_t touching(Occupancy own, Occupancy beside) {
  return static_cast<std::uint64_t>(std::popcount(own & beside) + std::popcount(own & (beside << 1)) +
                                    std::popcount(own & (beside >> 1)));
}

class BinReader {
 public:
  BinReader(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale)
      : labels_(labels), occupancy_(images.patch.occupancy), scale_(scale) {}

  // A pixel with a label is never on the edge of the image.
  void add(std::size_t pixel, Bins& of) const {
    const Occupancy own = at(pixel);
    if (own == 0) return;
    const auto w = static_cast<std::ptrdiff_t>(labels_.width), i = static_cast<std::ptrdiff_t>(pixel);
    for (const std::ptrdiff_t q : {i - w - 1, i - w, i - w + 1, i - 1, i + 1, i + w - 1, i + w, i + w + 1}) {
      const auto beside = static_cast<std::size_t>(q);
      if (labels_.of[beside] == labels_.of[pixel]) of.neighbours += touching(own, at(beside));
    }
    of.neighbours += static_cast<std::uint64_t>(2 * std::popcount(own & (own << 1)));
    const double x = static_cast<double>(pixel % labels_.width), y = static_cast<double>(pixel / labels_.width);
    if (of.count == 0) of.x0 = x, of.y0 = y;
    of.lowest = std::min(of.lowest, static_cast<std::uint32_t>(std::countr_zero(own)));
    for (Occupancy left = own; left != 0; left &= left - 1, ++of.count)
      of.add({scale_.pixel * (x - of.x0), scale_.pixel * (y - of.y0), scale_.bin() * std::countr_zero(left)});
  }

 private:
  Occupancy at(std::size_t pixel) const { return static_cast<Occupancy>(occupancy_.values[pixel]); }

  const PixelLabels& labels_;
  const Image& occupancy_;
  const RasterScale& scale_;
};

void write(const Bins& bins, const RasterScale& scale, ObjectCandidate& c) {
  const auto set = [&](CandidateFeature which, double v) { c.features[static_cast<std::size_t>(which)] = v; };
  for (const CandidateFeature f : {CandidateFeature::neighbour_bins, CandidateFeature::linear, CandidateFeature::planar,
                                   CandidateFeature::upright_axis, CandidateFeature::level_normal,
                                   CandidateFeature::lowest_bin, CandidateFeature::thickness})
    set(f, 0);
  if (bins.count == 0) return;
  const Eigen3 spread = eigen_symmetric(bins.covariance());
  const std::array<double, 3>& v = spread.values;
  const double most = std::max(v[2], kLeastSpread);
  set(CandidateFeature::neighbour_bins, static_cast<double>(bins.neighbours) / static_cast<double>(bins.count));
  set(CandidateFeature::linear, std::max(0.0, v[2] - v[1]) / most);
  set(CandidateFeature::planar, std::max(0.0, v[1] - v[0]) / most);
  set(CandidateFeature::upright_axis, std::abs(spread.vectors[2].z));
  set(CandidateFeature::level_normal, std::abs(spread.vectors[0].z));
  set(CandidateFeature::lowest_bin, scale.bin() * bins.lowest);
  set(CandidateFeature::thickness, std::sqrt(std::max(0.0, v[0])));
}

}  // namespace

void set_bin_features(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                      std::span<ObjectCandidate> candidates) {
  std::vector<Bins> bins(candidates.size());
  const BinReader reader(labels, images, scale);
  for (std::size_t i = 0; i < labels.of.size(); ++i)
    if (labels.of[i] != 0) reader.add(i, bins[labels.of[i] - 1]);
  for (std::size_t c = 0; c < bins.size(); ++c) write(bins[c], scale, candidates[c]);
}

}  // namespace ilot
