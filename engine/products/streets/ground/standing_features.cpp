// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/standing_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace ilot {
namespace {

constexpr std::uint32_t kFirstBin = 2;              // bins from 1 m on show what stands
constexpr std::uint32_t kHighBin = 3;               // from 1.5 m on
const double kThinShare = kThin / std::sqrt(12.0);  // of the side, as standing_form.cpp has it

// Values of all cells of the images with their halo.
using Plane = std::vector<double>;

// What is summed over boxes.
enum Summed : std::uint8_t {
  kTall,
  kUpright,
  kFlat,
  kSteep,
  kVolume,
  kBins,
  kShare,
  kMostBins,
  kLowest,
  kGround,
  kTop,
  kNormal
};
constexpr std::size_t kSummed = 12;
constexpr std::array<const char*, kSummed> kSummedNames{"tall",  "upright",   "flat",   "steep",  "volume", "bins",
                                                        "share", "most bins", "lowest", "ground", "top",    "normal"};

// The features of the cell itself, of each box, and of the lines in boxes larger than the first.
constexpr std::array<const char*, 14> kOwn{"top",
                                           "smallest deviation",
                                           "middle deviation",
                                           "largest deviation",
                                           "normal",
                                           "upright",
                                           "most bins",
                                           "pixels",
                                           "bins",
                                           "share",
                                           "lowest",
                                           "ground",
                                           "low bins",
                                           "cell"};
constexpr std::size_t kOfBox = kSummed + 2;  // and the highest top, and how much higher than the own top
constexpr std::size_t kOfLine = 4;           // of upright cells, and of tall ones: length, width, cells, distance
constexpr std::array<const char*, kOfLine> kLineNames{"length", "width", "cells", "distance"};
constexpr std::size_t kFeatures =
    kOwn.size() + kStandingReaches.size() * kOfBox + 2 * (kStandingReaches.size() - 1) * kOfLine;

class Measured {
 public:
  Measured(const CellMeasures& around, const RasterScale& scale, std::uint32_t factor)
      : around_(around), unit_(scale.unit), side_(scale.pixel), pixels_(factor * factor) {}

  std::size_t width() const { return around_[0].width; }
  std::size_t height() const { return around_[0].height; }
  Height raw(CellMeasure m, std::size_t i) const { return around_[static_cast<std::size_t>(m)].values[i]; }
  double top(std::size_t i) const {
    const Height t = raw(CellMeasure::top, i);
    return t == kNoHeight ? -1 : static_cast<double>(t) * unit_;
  }
  HeightBins bins(std::size_t i) const {
    const Height b = raw(CellMeasure::bins, i);
    return raw(CellMeasure::top, i) == kNoHeight ? 0 : static_cast<HeightBins>(b);
  }
  double deviation(std::size_t i, std::size_t which) const {
    return static_cast<double>((static_cast<std::uint32_t>(known(CellMeasure::deviations, i)) >> (10 * which)) & 1023) /
           kDeviationSteps;
  }
  double normal(std::size_t i) const { return static_cast<double>(known(CellMeasure::normal, i)) / 1000; }
  double share_of_pixels(CellMeasure m, std::size_t i) const { return static_cast<double>(known(m, i)) / pixels_; }
  double most_bins(std::size_t i) const { return static_cast<double>(known(CellMeasure::most_bins, i)); }
  double high_bins(std::size_t i) const { return std::popcount(bins(i) >> kFirstBin); }
  double share(std::size_t i) const {
    return high_bins(i) / std::max(1, static_cast<int>(std::bit_width(bins(i) >> kFirstBin)));
  }
  double lowest(std::size_t i) const {
    const HeightBins b = bins(i) >> kHighBin;
    return b == 0 ? -1 : std::countr_zero(b);
  }
  double ground(std::size_t i) const { return bins(i) & 1; }
  double side() const { return side_; }

 private:
  Height known(CellMeasure m, std::size_t i) const {
    const Height v = raw(m, i);
    return v == kNoHeight ? 0 : v;
  }
  const CellMeasures& around_;
  double unit_, side_, pixels_;
};

void add_own(const Measured& m, std::size_t i, std::vector<double>& row) {
  for (const double v : {m.top(i), m.deviation(i, 0), m.deviation(i, 1), m.deviation(i, 2), m.normal(i),
                         m.share_of_pixels(CellMeasure::upright, i), m.most_bins(i),
                         m.share_of_pixels(CellMeasure::pixels, i), m.high_bins(i), m.share(i), m.lowest(i),
                         m.ground(i), static_cast<double>(std::popcount(m.bins(i) & 0x1eu)), m.side()})
    row.push_back(v);
}

std::array<double, kSummed> summed_of(const Measured& m, std::size_t i, bool tall) {
  std::array<double, kSummed> v{};
  v[kGround] = m.ground(i);
  if (!tall) return v;
  const bool thin = m.deviation(i, 0)<kThinShare, any = m.raw(CellMeasure::deviations, i)> 0;
  v[kTall] = 1;
  v[kUpright] = m.raw(CellMeasure::upright, i) > 0;
  v[kFlat] = any && thin && m.normal(i) >= kMostUprightNormal;
  v[kSteep] = any && thin && m.normal(i) < kMostUprightNormal;
  v[kVolume] = any && !thin;
  v[kBins] = m.high_bins(i), v[kShare] = m.share(i), v[kMostBins] = m.most_bins(i), v[kLowest] = m.lowest(i);
  v[kTop] = m.top(i), v[kNormal] = m.normal(i);
  return v;
}

// A table of sums over all cells above and to the left, for sums over boxes in four reads. Values are multiples of
// 2^-20, so that sums are exact in any order.
class SumTable {
 public:
  SumTable(std::size_t w, std::size_t h) : w_(w + 1), sums_((w + 1) * (h + 1), 0) {}
  void set(std::size_t x, std::size_t y, std::int64_t v) { sums_[(y + 1) * w_ + x + 1] = v; }
  void finish() {
    for (std::size_t i = w_; i < sums_.size(); ++i)
      if (i % w_ != 0) sums_[i] += sums_[i - 1] + sums_[i - w_] - sums_[i - w_ - 1];
  }
  std::int64_t box(std::size_t x0, std::size_t y0, std::size_t x1, std::size_t y1) const {
    return sums_[(y1 + 1) * w_ + x1 + 1] - sums_[y0 * w_ + x1 + 1] - sums_[(y1 + 1) * w_ + x0] + sums_[y0 * w_ + x0];
  }

 private:
  std::size_t w_;
  std::vector<std::int64_t> sums_;
};

constexpr double kUnit = 1 << 20;

// The principal axes of cells around a cell, and the distance of that cell from the longer one.
struct CellLine {
  double length = 0, width = 0, cells = 0, distance = 0;
};

// `s`: whole sums of 1, x, y, x^2, x y, y^2 over the cells; (x, y): the cell. All that is rounded is counted from the
// cell, so that the place of the image does not matter.
CellLine line_of(const std::array<std::int64_t, 6>& s, std::int64_t x, std::int64_t y) {
  CellLine line;
  line.cells = static_cast<double>(s[0]);
  if (s[0] < 1) return line;
  const double n = line.cells;
  const double mx = static_cast<double>(s[1] - x * s[0]) / n, my = static_cast<double>(s[2] - y * s[0]) / n;
  const double xx = static_cast<double>(s[3] - 2 * x * s[1] + x * x * s[0]) / n - mx * mx;
  const double xy = static_cast<double>(s[4] - x * s[2] - y * s[1] + x * y * s[0]) / n - mx * my;
  const double yy = static_cast<double>(s[5] - 2 * y * s[2] + y * y * s[0]) / n - my * my;
  const double half = (xx + yy) / 2, root = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
  line.length = std::sqrt(std::max(half + root, 0.0));
  line.width = std::sqrt(std::max(half - root, 0.0));
  if (root <= 0) return line;
  const double across = ((half + root - xx) * mx * mx - 2 * xy * mx * my + (half + root - yy) * my * my) / (2 * root);
  line.distance = std::sqrt(std::max(across, 0.0));
  return line;
}

// The highest value of each box of 2 reach + 1, by rows and then columns; cells nearer than `reach` to the end get -1.
Plane box_maxima(const Plane& own, std::size_t w, std::size_t h, std::size_t reach) {
  Plane rows(own.size(), -1), out(own.size(), -1);
  for (std::size_t y = 0; y < h; ++y)
    for (std::size_t x = reach; x + reach < w; ++x)
      rows[y * w + x] = *std::max_element(own.begin() + static_cast<std::ptrdiff_t>(y * w + x - reach),
                                          own.begin() + static_cast<std::ptrdiff_t>(y * w + x + reach + 1));
  for (std::size_t y = reach; y + reach < h; ++y)
    for (std::size_t v = y - reach; v <= y + reach; ++v)
      for (std::size_t x = 0; x < w; ++x) out[y * w + x] = std::max(out[y * w + x], rows[v * w + x]);
  return out;
}

// Sums over boxes and lines around cells.
class Surroundings {
 public:
  Surroundings(const Measured& m, const std::vector<std::uint8_t>& tall) : m_(m), w_(m.width()) {
    const std::size_t h = m.height();
    sums_.assign(kSummed, SumTable(w_, h));
    lines_.assign(12, SumTable(w_, h));
    Plane tops(w_ * h);
    for (std::size_t i = 0; i < tops.size(); ++i) {
      const std::size_t x = i % w_, y = i / w_;
      const std::array<double, kSummed> own = summed_of(m, i, tall[i] != 0);
      for (std::size_t k = 0; k < kSummed; ++k) sums_[k].set(x, y, std::llround(own[k] * kUnit));
      const auto u = static_cast<std::int64_t>(x), v = static_cast<std::int64_t>(y);
      const std::array<std::int64_t, 6> moments{1, u, v, u * u, u * v, v * v};
      for (std::size_t k = 0; k < 6; ++k) {
        lines_[k].set(x, y, own[kUpright] > 0 ? moments[k] : 0);
        lines_[6 + k].set(x, y, own[kTall] > 0 ? moments[k] : 0);
      }
      tops[i] = m.top(i);
    }
    for (SumTable& t : sums_) t.finish();
    for (SumTable& t : lines_) t.finish();
    for (const std::uint32_t reach : kStandingReaches) maxima_.push_back(box_maxima(tops, w_, h, reach));
  }

  void add(std::size_t i, std::vector<double>& row) const {
    const std::size_t x = i % w_, y = i / w_;
    for (std::size_t r = 0; r < kStandingReaches.size(); ++r) {
      const std::size_t reach = kStandingReaches[r];
      const auto box = [&](const SumTable& t) { return t.box(x - reach, y - reach, x + reach, y + reach); };
      const auto area = static_cast<double>((2 * reach + 1) * (2 * reach + 1));
      const double tall = std::max(1.0, static_cast<double>(box(sums_[kTall])) / kUnit);
      for (std::size_t k = 0; k < kSummed; ++k)
        row.push_back(static_cast<double>(box(sums_[k])) / kUnit / (k == kTall || k == kGround ? area : tall));
      row.push_back(maxima_[r][i]);
      row.push_back(maxima_[r][i] - m_.top(i));
      if (r == 0) continue;
      for (std::size_t of = 0; of < 2; ++of) {
        std::array<std::int64_t, 6> s{};
        for (std::size_t k = 0; k < 6; ++k) s[k] = box(lines_[6 * of + k]);
        const CellLine line = line_of(s, static_cast<std::int64_t>(x), static_cast<std::int64_t>(y));
        for (const double v : {line.length, line.width, line.cells, line.distance}) row.push_back(v);
      }
    }
  }

 private:
  const Measured& m_;
  std::size_t w_;
  std::vector<SumTable> sums_, lines_;
  std::vector<Plane> maxima_;
};

std::vector<std::string> names() {
  std::vector<std::string> out(kOwn.begin(), kOwn.end());
  for (std::size_t r = 0; r < kStandingReaches.size(); ++r) {
    for (const char* name : kSummedNames) out.push_back(fmt::format("{} within {}", name, kStandingReaches[r]));
    out.push_back(fmt::format("highest within {}", kStandingReaches[r]));
    out.push_back(fmt::format("higher within {}", kStandingReaches[r]));
    if (r == 0) continue;
    for (const char* of : {"upright", "tall"})
      for (const char* name : kLineNames)
        out.push_back(fmt::format("{} line {} within {}", of, name, kStandingReaches[r]));
  }
  return out;
}

}  // namespace

const char* cell_measure_layer(CellMeasure m) {
  static constexpr std::array<const char*, kCellMeasures> kNames{"top",     "bins",      "deviations", "normal",
                                                                 "upright", "most bins", "pixels"};
  return kNames[static_cast<std::size_t>(m)];
}

CellMeasures cell_measures_around(const Cells& cells, std::size_t tile) {
  CellMeasures around;
  for (std::size_t m = 0; m < kCellMeasures; ++m)
    around[m] = layer_around(cells.layers, cell_measure_layer(static_cast<CellMeasure>(m)), tile, kStandingHalo);
  return around;
}

std::size_t cell_of_tile(const CellMeasures& around, std::uint32_t cell) {
  const std::size_t w = around[0].width;
  return (cell / w - kStandingHalo) * (w - 2 * std::size_t{kStandingHalo}) + cell % w - kStandingHalo;
}

std::size_t standing_features() {
  return kFeatures;
}

std::string standing_feature_name(std::size_t feature) {
  static const std::vector<std::string> kNames = names();
  return kNames[feature];
}

StandingRows standing_rows(const CellMeasures& around, const RasterScale& scale, std::uint32_t factor, Height least) {
  StandingRows out;
  const Measured m(around, scale, factor);
  const std::size_t w = m.width(), h = m.height();
  std::vector<std::uint8_t> tall(w * h, 0);
  bool any = false;
  for (std::size_t i = 0; i < tall.size(); ++i) {
    tall[i] = m.raw(CellMeasure::top, i) != kNoHeight && m.raw(CellMeasure::top, i) >= least;
    any = any || tall[i] != 0;
  }
  if (!any) return out;
  const Surroundings surroundings(m, tall);
  std::size_t inside = 0;
  for (std::size_t y = kStandingHalo; y + kStandingHalo < h; ++y)
    inside += static_cast<std::size_t>(
        std::count(tall.begin() + static_cast<std::ptrdiff_t>(y * w + kStandingHalo),
                   tall.begin() + static_cast<std::ptrdiff_t>((y + 1) * w - kStandingHalo), 1));
  out.cells.reserve(inside);
  out.rows.reserve(inside * kFeatures);
  for (std::size_t y = kStandingHalo; y + kStandingHalo < h; ++y)
    for (std::size_t x = kStandingHalo; x + kStandingHalo < w; ++x) {
      const std::size_t i = y * w + x;
      if (tall[i] == 0) continue;
      out.cells.push_back(static_cast<std::uint32_t>(i));
      add_own(m, i, out.rows);
      surroundings.add(i, out.rows);
    }
  return out;
}

}  // namespace ilot
