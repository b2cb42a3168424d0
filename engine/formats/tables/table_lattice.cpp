// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/table_lattice.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr double kReach = 2147.483647;  // 2^31 - 1 steps of the finest scale
constexpr double kNear = 2e5;           // of the usual scale, 1e-4
constexpr double kFarthest = 1e12;      // beyond it the doubles themselves are coarser than the usual scale
constexpr double kRaster = 1000;        // of offsets
constexpr int kUsual = 4, kFinest = 6, kCoarsest = 2;  // decimals of scales
constexpr std::array<double, 5> kScales{1e-6, 1e-5, 1e-4, 1e-3, 1e-2};
constexpr int kDegreeDecimals = 5;                  // additional decimals for degrees: 1e-5 degrees are about a metre
constexpr std::uint64_t kOneIn = 100, kFewest = 3;  // isolated rows; fewest rows for it

bool is_usable(Vec3 p) {
  return std::abs(p.x) < kFarthest && std::abs(p.y) < kFarthest && std::abs(p.z) < kFarthest;
}

double median(const std::vector<Vec3>& points, double Vec3::*axis) {
  std::vector<double> values;
  for (const Vec3& p : points) values.push_back(p.*axis);
  return upper_median(values);
}

double reach_of(Vec3 p, const std::array<double, 3>& offset) {
  return std::max({std::abs(p.x - offset[0]), std::abs(p.y - offset[1]), std::abs(p.z - offset[2])});
}

std::array<double, 3> raster_below(Vec3 p) {
  return {std::floor(p.x / kRaster) * kRaster, std::floor(p.y / kRaster) * kRaster,
          std::floor(p.z / kRaster) * kRaster};
}

// Returns the band of a reach; its scale has 6, 5, 4 ... decimals.
int band_of(double reach, int bands) {
  int band = 0;
  for (double most = kReach; band + 1 < bands && reach > most; most *= 10) ++band;
  return band;
}

}  // namespace

void LatticeSurvey::add(Vec3 place, int decimals) {
  const Vec3 p{place.x * factor_, place.y * factor_, place.z};
  if (!is_usable(p)) return;
  decimals_ = std::max(decimals_, decimals);
  if (!first_) first_ = p;
  ++rows_;
  if (p.x == 0 && p.y == 0 && p.z == 0) {
    ++zeros_;
  } else if (has_offset_) {
    count(p);
  } else {
    sample_.push_back(p);
    if (sample_.size() == kSample) choose_offset();
  }
}

std::optional<std::size_t> LatticeSurvey::first_not_isolated() const {
  const Vec3 centre{median(sample_, &Vec3::x), median(sample_, &Vec3::y), median(sample_, &Vec3::z)};
  for (std::size_t i = 0; i < sample_.size(); ++i)
    if (reach_of(sample_[i], {centre.x, centre.y, centre.z}) < kNear) return i;
  return std::nullopt;
}

void LatticeSurvey::choose_offset() {
  has_offset_ = true;
  if (sample_.empty()) return;
  const auto first = first_not_isolated();
  const Vec3 begin = first ? sample_[*first] : sample_.front();
  offset_ = raster_below(begin);
  // A first row at the origin begins the cloud when the cloud is near the origin.
  const bool zero_first = first_->x == 0 && first_->y == 0 && first_->z == 0;
  if (zero_first && reach_of(*first_, {begin.x, begin.y, begin.z}) < kNear) offset_ = raster_below(*first_);
  for (const Vec3& p : sample_) count(p);
}

void LatticeSurvey::count(Vec3 place) {
  ++bands_[static_cast<std::size_t>(band_of(reach_of(place, offset_), kBands))];
}

TableLattice LatticeSurvey::choose() {
  if (!has_offset_) choose_offset();
  const int more = factor_ > 1 ? kDegreeDecimals : 0;
  const auto band_with = [](int decimals) { return kFinest - decimals; };
  const auto rows_beyond = [&](int band) {
    std::uint64_t count = 0;
    for (int b = band + 1; b < kBands; ++b) count += bands_[static_cast<std::size_t>(b)];
    return count;
  };
  const int wished = band_with(std::clamp(decimals_ - more, kUsual, kFinest)), coarsest = band_with(kCoarsest);
  const std::uint64_t alone = rows_ >= kFewest ? std::max<std::uint64_t>(1, rows_ / kOneIn) : 0;
  int band = wished;
  // Scales finer than the usual one are optional, so no row is left out for them.
  while (band < coarsest && rows_beyond(band) > (band < band_with(kUsual) ? 0 : alone)) ++band;
  TableLattice lattice;
  lattice.decimals = decimals_;
  lattice.kept = kFinest - band + more;
  lattice.beyond = rows_beyond(band);
  if (band_of(reach_of({0, 0, 0}, offset_), kBands) > band) lattice.zeros_beyond = zeros_;
  const double scale = kScales[static_cast<std::size_t>(band)];
  lattice.scale = {scale / factor_, scale / factor_, scale};
  lattice.offset = {offset_[0] / factor_, offset_[1] / factor_, offset_[2]};
  return lattice;
}

}  // namespace ilot
