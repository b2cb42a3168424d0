// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/input_lattice.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace ilot {
namespace {

constexpr double kCoarsest = 1e-3;  // CRS units; coordinates in such or coarser steps do not change
constexpr double kRounding = 1e-9;  // relative, of a product of scales
constexpr std::uint64_t kStretches = 32, kRows = 32;
constexpr std::uint64_t kMostRows = 1 << 17;  // rows that are searched for places that differ

double finest_scale(const std::vector<std::unique_ptr<PointReader>>& inputs) {
  double finest = 0;
  for (const auto& input : inputs)
    for (const double scale : input->info().layout.scale) finest = finest == 0 ? scale : std::min(finest, scale);
  return finest;
}

// Returns the greatest common divisor of all coordinates of some rows, in steps of the finest scale. It is 0 when all
// are at one place, which shows nothing: rays without an echo are like this.
std::int64_t divisor_of(PointReader& reader, const LatticeMap& map, std::uint64_t first) {
  const RecordLayout& layout = reader.info().layout;
  std::vector<std::byte> rows(kRows * layout.record_length);
  std::vector<std::uint8_t> valid(kRows);
  const std::size_t got = reader.read(first, rows, valid);
  std::int64_t divisor = 0;
  std::optional<Index3> place;
  bool others = false;
  for (std::size_t i = 0; i < got; ++i) {
    const PointFields f =
        decode_fields(std::span(rows).subspan(i * layout.record_length, layout.record_length), layout.point_format);
    Index3 at;
    if (valid[i] == 0 || !map.map(f.x, f.y, f.z, at)) continue;
    divisor = std::gcd(divisor, std::gcd(at.x, std::gcd(at.y, at.z)));
    others = others || (place && !(at == *place));
    place = at;
  }
  return others ? divisor : 0;
}

// Returns the largest number of which nine in ten stretches are multiples.
std::int64_t common_divisor(std::vector<std::int64_t> divisors) {
  std::sort(divisors.begin(), divisors.end());
  for (auto d = divisors.rbegin(); d != divisors.rend(); ++d) {
    const auto multiples = std::count_if(divisors.begin(), divisors.end(), [&](std::int64_t v) { return v % *d == 0; });
    if (10 * static_cast<std::size_t>(multiples) >= 9 * divisors.size()) return *d;
  }
  return 1;
}

// 0: no two places were seen. 1: the coordinates need all steps.
std::int64_t likely_divisor(PointReader& reader, double finest) {
  const LatticeMap map(reader.info().layout, finest);
  if (!map.exact()) return 1;
  const std::uint64_t points = reader.info().points;
  std::vector<std::int64_t> divisors;
  const auto ask = [&](std::uint64_t first) {
    if (const std::int64_t divisor = divisor_of(reader, map, first); divisor != 0) divisors.push_back(divisor);
  };
  if (reader.random_access()) {
    const std::vector<std::uint64_t> bounds = reader.boundaries();
    const std::uint64_t step = std::max<std::uint64_t>(1, bounds.size() / kStretches);
    for (std::size_t i = 0; i + 1 < bounds.size(); i += step) ask(bounds[i]);
  }
  // Searches from the front when there are few places to begin at.
  for (std::uint64_t first = 0; divisors.size() < kStretches && first < std::min(points, kMostRows); first += kRows)
    ask(first);
  return divisors.empty() ? 0 : common_divisor(std::move(divisors));
}

// Returns the largest divisor whose steps are not too coarse; `least` when they are finer than that.
InputLattice coarsened(double finest, std::int64_t divisor, double least) {
  const auto most = static_cast<std::int64_t>(std::min(kCoarsest * (1 + kRounding) / finest, 0x1p20));
  std::int64_t multiple = 1;
  for (std::int64_t d = 2; d <= most; ++d)
    if (divisor % d == 0) multiple = d;
  const double unit = finest * static_cast<double>(multiple);
  if (unit < least * (1 - kRounding)) return {least};
  if (multiple == 1) return {finest};
  const double per_one = std::round(1 / unit);  // exact for 0.001, while 100 times 1e-5 may not be
  return {std::abs(per_one * unit - 1) < kRounding ? 1 / per_one : unit, multiple};
}

}  // namespace

InputLattice common_lattice(const std::vector<std::unique_ptr<PointReader>>& inputs, double metres_per_unit,
                            double finest_step) {
  const double finest = finest_scale(inputs), least = finest_step / metres_per_unit;
  if (finest >= kCoarsest * (1 - kRounding)) return {std::max(finest, least)};
  std::int64_t divisor = 0;
  for (const auto& input : inputs) {
    divisor = std::gcd(divisor, likely_divisor(*input, finest));
    if (divisor == 1) break;
  }
  return coarsened(finest, std::max<std::int64_t>(1, divisor), least);
}

InputLattice checked_lattice(const InputLattice& lattice, const std::vector<std::unique_ptr<PointReader>>& inputs,
                             std::span<const std::vector<Index3>> off_lattice, const Strays& strays,
                             double metres_per_unit, double finest_step) {
  std::int64_t divisor = lattice.multiple;
  const auto on_lattice = [&](std::int64_t v) {
    return static_cast<std::int64_t>(std::nearbyint(static_cast<double>(v) / static_cast<double>(lattice.multiple)));
  };
  for (const std::vector<Index3>& places : off_lattice) {
    const bool all_known = places.size() < kMostOffLattice;
    for (const Index3& p : places) {
      if (all_known && strays.contains({on_lattice(p.x), on_lattice(p.y), on_lattice(p.z)})) continue;
      divisor = std::gcd(divisor, std::gcd(p.x, std::gcd(p.y, p.z)));
    }
  }
  return divisor == lattice.multiple ? lattice
                                     : coarsened(finest_scale(inputs), divisor, finest_step / metres_per_unit);
}

}  // namespace ilot
