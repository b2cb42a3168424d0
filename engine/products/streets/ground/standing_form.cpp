// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/standing_form.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "kernels/core/eigen3.h"

namespace ilot {
namespace {

constexpr std::int64_t kLeastPoints = 5;  // of a plane, with two more than fix it
// Choice: a column of windows is half glass, the piers between windows are not.
constexpr std::uint32_t kLeastBins = 2;  // of an upright pixel; a wall that is cut at 2 m has two above 1 m
constexpr std::uint32_t kTallBins = 4;   // an upright pixel may end below a crown or a roof if it has so many
constexpr std::uint32_t kFilledOf3 = 2;  // thirds of the bins of an upright pixel that hold a point

}  // namespace

StandingPoints::Spread StandingPoints::spread() const {
  if (n_ < kLeastPoints) return {};
  const auto n = static_cast<double>(n_);
  const auto mean = [&](std::size_t a) { return static_cast<double>(sum_[a]) / n; };
  const auto moment = [&](std::size_t k, std::size_t a, std::size_t b) {
    return (static_cast<double>(squares_[k]) - n * mean(a) * mean(b)) / (n - 3);  // three parameters of a plane
  };
  const Eigen3 e = eigen_symmetric(
      {moment(0, 0, 0), moment(1, 0, 1), moment(2, 0, 2), moment(3, 1, 1), moment(4, 1, 2), moment(5, 2, 2)});
  const auto deviation = [&](std::size_t i) { return std::sqrt(std::max(0.0, e.values[i])); };
  return {{deviation(0), deviation(1), deviation(2)}, std::abs(e.vectors[0].z)};
}

StandingForm StandingPoints::shape(const Spread& spread, double side) const {
  if (n_ < kLeastPoints) return StandingForm::none;
  const double thin = kThin * side / std::sqrt(12.0);
  if (spread.deviations[0] > thin) return StandingForm::volume;
  if (spread.normal_z >= kMostUprightNormal) return StandingForm::inclined;
  return spread.deviations[1] <= thin ? StandingForm::pole : StandingForm::upright;
}

bool is_upright(HeightBins bins, BinRange range) {
  const HeightBins above = bins >> range.first;
  const auto filled = static_cast<std::uint32_t>(std::popcount(above)),
             own = static_cast<std::uint32_t>(std::bit_width(above));
  const std::uint32_t last = std::min(range.last, kHeightBins - 1),
                      all = last < range.first ? 0 : last - range.first + 1;
  return filled >= kLeastBins && 3 * filled >= kFilledOf3 * (filled >= kTallBins ? own : std::max(own, all));
}

}  // namespace ilot
