// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_bands.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

#include "engine/products/streets/objects/moment_rectangle.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

// Choice: wheels, bonnets, window sills, the heads of those who sit, cars and pedestrians, vans, what is higher.
constexpr std::array<double, kHeightBands - 1> kBandEnds = {0.3, 0.6, 1.0, 1.4, 1.8, 2.4};  // metres

// Choice: people and cars have no such gap between their foot and their top, unless they were hardly seen, and crowns
// and awnings are farther above them.
constexpr double kClearAbove = 1;  // metres

// The pixels of a candidate with a point in one band, from its first pixel. Sums of whole numbers are exact.
struct Band {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  void add(double px, double py) { ++n, x += px, y += py, xx += px * px, xy += px * py, yy += py * py; }
  MomentRectangle rectangle(double pixel) const {
    if (n == 0) return {};
    const double mx = x / n, my = y / n;
    return moment_rectangle(xx / n - mx * mx, xy / n - mx * my, yy / n - my * my, pixel);
  }
};

// Between the middles, in pixels; 0 if one has no pixels.
double distance(const Band& a, const Band& b) {
  if (a.n == 0 || b.n == 0) return 0;
  const double x = a.x / a.n - b.x / b.n, y = a.y / a.n - b.y / b.n;
  return std::sqrt(x * x + y * y);
}

struct Bands {
  double x0 = 0, y0 = 0;
  Band all;
  Occupancy any = 0;
  std::array<Band, kHeightBands> bands;
  double pairs = 0, level = 0, stepped = 0;  // of pixels side by side
};

std::array<Occupancy, kHeightBands> masks_of(const RasterScale& scale) {
  std::array<Occupancy, kHeightBands> masks{};
  for (std::uint32_t bin = 0; bin < kOccupancyBins; ++bin) {
    const double middle = (bin + 0.5) * scale.bin();
    const auto end = std::upper_bound(kBandEnds.begin(), kBandEnds.end(), middle);
    masks[static_cast<std::size_t>(end - kBandEnds.begin())] |= Occupancy{1} << bin;
  }
  return masks;
}

// The upper side of the bins from the lowest one with a point to the one above which kClearAbove is empty; what lies
// above all bins is at `highest`.
double own_top(Occupancy any, const RasterScale& scale, double highest) {
  const auto gap = static_cast<std::uint32_t>(std::ceil(kClearAbove / scale.bin()));
  const auto lowest = static_cast<std::uint32_t>(std::countr_zero(any));
  for (std::uint32_t bin = lowest, last = lowest; bin < kOccupancyBins; ++bin) {
    if ((any >> bin & 1) != 0) last = bin;
    if (bin - last >= gap) return std::min(highest, (last + 1) * scale.bin());
  }
  return highest;
}

void write(const Bands& of, const RasterScale& scale, ObjectCandidate& c) {
  const auto set = [&](CandidateFeature first, std::size_t band, double v) {
    c.features[static_cast<std::size_t>(first) + band] = v;
  };
  for (std::size_t b = 0; b < kHeightBands; ++b) {
    const MomentRectangle r = of.bands[b].rectangle(scale.pixel);
    set(CandidateFeature::band_share, b, of.all.n > 0 ? of.bands[b].n / of.all.n : 0);
    set(CandidateFeature::band_length, b, r.length);
    set(CandidateFeature::band_width, b, r.width);
    set(CandidateFeature::band_offset, b, scale.pixel * distance(of.bands[b], of.all));
  }
  c.own_top = own_top(of.any, scale, c.features[static_cast<std::size_t>(ComponentFeature::max_height)]);
  set(CandidateFeature::level_share, 0, of.pairs > 0 ? of.level / of.pairs : 0);
  set(CandidateFeature::step_share, 0, of.pairs > 0 ? of.stepped / of.pairs : 0);
}

}  // namespace

void set_band_features(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                       std::span<ObjectCandidate> candidates) {
  const std::array<Occupancy, kHeightBands> masks = masks_of(scale);
  const std::size_t w = labels.width;
  const double pixel = scale.pixel / scale.unit;  // in units of height
  std::vector<Bands> all(candidates.size());
  for (std::size_t i = 0; i < labels.of.size(); ++i) {
    if (labels.of[i] == 0) continue;
    Bands& of = all[labels.of[i] - 1];
    const double x = static_cast<double>(i % w), y = static_cast<double>(i / w);
    if (of.all.n == 0) of.x0 = x, of.y0 = y;
    of.all.add(x - of.x0, y - of.y0);
    const auto occupancy = static_cast<Occupancy>(images.patch.occupancy.values[i]);
    of.any |= occupancy;
    for (std::size_t b = 0; b < kHeightBands; ++b)
      if ((occupancy & masks[b]) != 0) of.bands[b].add(x - of.x0, y - of.y0);
    for (const std::size_t next : {i + 1, i + w}) {  // a pixel with a label is never on the edge of the image
      if (labels.of[next] != labels.of[i]) continue;
      const double step = std::abs(static_cast<double>(images.own.values[next]) - images.own.values[i]);
      ++of.pairs;
      if (step < pixel / 2) ++of.level;
      if (step > 2 * pixel) ++of.stepped;
    }
  }
  for (std::size_t c = 0; c < all.size(); ++c) write(all[c], scale, candidates[c]);
}

}  // namespace ilot
