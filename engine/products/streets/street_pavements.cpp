// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_pavements.h"

#include <algorithm>
#include <cmath>

#include "engine/products/streets/pavements/kerb_transects.h"
#include "engine/products/streets/pavements/pavement_width.h"
#include "kernels/core/integers.h"
#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

// Choice: what hangs higher is in nobody's way; signs over pavements hang at 2.2 m or more.
constexpr double kHeadroom = 2.2;  // metres above the ground
constexpr double kWaist = 1;       // Choice: metres above the ground; crowns of trees begin higher
// Measured: nine in ten widths to walls of wild streets are as near, on seeds that were not met too
// (bench/wild/history/streets.md).
constexpr double kPixelsOfError = 2;
constexpr double kNearestStep = 0.5;          // Choice: metres; another kerb that is nearer is the same one
constexpr std::uint64_t kBytesOfWindow = 40;  // the six layers of a window, and what they say

// A part of the raster with what is known of its pixels.
struct PavementImage {
  std::int64_t x = 0, y = 0;  // pixels
  std::uint32_t width = 0, height = 0;
  std::vector<PavementPixel> pixels;
  Image level;
};

struct PlacedTransect {
  std::size_t kerb = 0;
  Transect place;
};

class PavementFinder {
 public:
  PavementFinder(const StreetTiles& tiles, std::span<const StreetKerb> kerbs, std::span<const PavementPixel> standing,
                 const StreetPavementsParams& params)
      : tiles_(tiles), raster_(tiles.raster()), kerbs_(kerbs), standing_(standing), params_(params) {
    low_bins_ = bins_up_to(kHeadroom), waist_bins_ = bins_up_to(kWaist);
    for (const StreetKerb& kerb : kerbs) {
      lines_.emplace_back();
      for (const Vec3& p : kerb.line) lines_.back().push_back(on_raster(p));
    }
  }

  std::vector<PavementWidth> find() {
    const KerbLookup kerbs_around(lines_);
    std::vector<PlacedTransect> places;
    std::vector<std::vector<std::size_t>> of_tile(raster_.grid.count());
    for (std::size_t k = 0; k < kerbs_.size(); ++k)
      for (const Transect& t : transects_along(lines_[k], params_.spacing)) {
        const std::int64_t side = raster_.grid.side;
        const std::size_t tile =
            raster_.grid.tile_at(floor_divided(pixel_of(t.at.y), side), floor_divided(pixel_of(t.at.x), side));
        if (tile == kNoTile) continue;
        of_tile[tile].push_back(places.size());
        places.push_back({k, t});
      }
    std::vector<PavementWidth> widths(places.size());
    const std::uint64_t side = raster_.grid.side + 2 * reach_pixels();
    std::vector<std::uint64_t> bytes;
    for (const auto& list : of_tile) bytes.push_back(list.empty() ? 0 : side * side * kBytesOfWindow);
    run_tasks(raster_.grid, bytes, [&](std::size_t tile) {
      if (of_tile[tile].empty()) return;
      const PavementImage image = image_around(places, of_tile[tile]);
      for (const std::size_t i : of_tile[tile]) widths[i] = measure(places[i], image, kerbs_around);
    });
    return widths;
  }

 private:
  std::int64_t pixel_of(double metres) const {
    return static_cast<std::int64_t>(std::floor(metres / raster_.scale.pixel));
  }
  std::uint32_t reach_pixels() const { return raster_.scale.pixels(params_.reach + margin()) + 2; }

  double margin() const { return params_.spacing + params_.around; }  // metres

  // Metres from the corner of the raster. Gaps without points that the raster leaves out are left out here too.
  Vec3 on_raster(Vec3 p) const {
    const auto folded = [&](double v, const auto& to_pixel) {
      const double lattice = v / raster_.unit;
      const auto cell = static_cast<std::int64_t>(std::floor(lattice));
      const double within = lattice - static_cast<double>(floor_divided(cell, raster_.pixel) * raster_.pixel);
      return (static_cast<double>(to_pixel(cell)) + within / static_cast<double>(raster_.pixel)) * raster_.scale.pixel;
    };
    return {folded(p.x, [&](std::int64_t c) { return raster_.column(c); }),
            folded(p.y, [&](std::int64_t r) { return raster_.row(r); }), p.z / raster_.unit * raster_.scale.unit};
  }

  Vec3 in_crs(double x, double y, double z) const {
    const double pixel = raster_.scale.pixel;
    return {raster_.crs_x(x / pixel), raster_.crs_y(y / pixel), z / raster_.scale.unit * raster_.unit};
  }

  Occupancy bins_up_to(double metres) const {
    const double bin = std::max(1, raster_.scale.units(raster_.scale.bin())) * raster_.scale.unit;
    const auto bins = static_cast<std::uint32_t>(std::clamp(std::ceil(metres / bin), 1.0, double{kOccupancyBins}));
    return static_cast<Occupancy>((std::uint64_t{1} << bins) - 1);
  }

  // The pixels that the strips of some places need.
  PavementImage image_around(const std::vector<PlacedTransect>& places, const std::vector<std::size_t>& of) const {
    double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
    for (const std::size_t i : of) {
      const Transect& t = places[i].place;
      for (const double far : {0.0, params_.reach}) {
        low_x = std::min(low_x, t.at.x + far * t.across_x), high_x = std::max(high_x, t.at.x + far * t.across_x);
        low_y = std::min(low_y, t.at.y + far * t.across_y), high_y = std::max(high_y, t.at.y + far * t.across_y);
      }
    }
    PavementImage image;
    image.x = pixel_of(low_x - margin()), image.y = pixel_of(low_y - margin());
    image.width = static_cast<std::uint32_t>(pixel_of(high_x + margin()) - image.x + 1);
    image.height = static_cast<std::uint32_t>(pixel_of(high_y + margin()) - image.y + 1);
    fill(image);
    return image;
  }

  void fill(PavementImage& image) const {
    const auto window = [&](const char* layer) {
      return layer_window(tiles_.layers(), layer, image.x, image.y, image.width, image.height);
    };
    const Image mask = window("mask"), points = window("accumulation"), above = window("above");
    const Image occupancy = window("occupancy"), candidates = window("candidates");
    image.level = window("level");
    image.pixels.assign(mask.size(), PavementPixel::unseen);
    for (std::size_t i = 0; i < mask.size(); ++i) {
      if (mask.values[i] == kNoHeight || image.level.values[i] == kNoHeight) continue;
      const Occupancy bins = static_cast<Occupancy>(occupancy.values[i]) & low_bins_;
      const bool low = bins != 0, upright = (bins & (bins - 1)) != 0;  // points in one bin, in two
      const auto number = static_cast<std::size_t>(std::max(0, candidates.values[i]));
      PavementPixel& pixel = image.pixels[i];
      if (mask.values[i] != 1) {
        if (upright) pixel = PavementPixel::wall;
      } else if (upright || (low && number != 0)) {
        // Crowns of trees that reach below 2.2 m are in nobody's way. Hedges are taken for crowns too, but reach lower.
        const bool leaves = number == 0 && (static_cast<Occupancy>(occupancy.values[i]) & waist_bins_) == 0;
        const PavementPixel below = points.values[i] > above.values[i] ? PavementPixel::ground : PavementPixel::unseen;
        pixel = leaves ? below : number < standing_.size() ? standing_[number] : PavementPixel::loose;
      } else if (points.values[i] > above.values[i]) {
        pixel = PavementPixel::ground;
      }
    }
  }

  PavementStrip strip_of(const Transect& t, const PavementImage& image) const {
    PavementStrip strip;
    strip.step = raster_.scale.pixel;
    const auto own = static_cast<std::uint32_t>(std::max(1.0, std::round(params_.spacing / strip.step)));
    const auto around = static_cast<std::uint32_t>(std::ceil(params_.around / strip.step));
    strip.rows = own + 2 * around, strip.first = around, strip.last = around + own;
    strip.columns = static_cast<std::uint32_t>(std::round(params_.reach / strip.step));
    strip.pixels.assign(std::size_t{strip.rows} * strip.columns, PavementPixel::unseen);
    strip.heights.assign(strip.pixels.size(), 0);
    for (std::uint32_t r = 0; r < strip.rows; ++r) {
      const double along = (r + 0.5) * strip.step - 0.5 * strip.rows * strip.step;
      for (std::uint32_t c = 0; c < strip.columns; ++c) {
        const double out = (c + 0.5) * strip.step;
        const std::int64_t u = pixel_of(t.at.x + out * t.across_x + along * t.across_y) - image.x;
        const std::int64_t v = pixel_of(t.at.y + out * t.across_y - along * t.across_x) - image.y;
        if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
        const std::size_t i = static_cast<std::size_t>(v) * image.width + static_cast<std::size_t>(u);
        strip.pixels[strip.at(r, c)] = image.pixels[i];
        strip.heights[strip.at(r, c)] = image.level.values[i] * raster_.scale.unit;
      }
    }
    return strip;
  }

  PavementWidth measure(const PlacedTransect& placed, const PavementImage& image, const KerbLookup& around) const {
    const Transect& t = placed.place;
    const StreetKerb& kerb = kerbs_[placed.kerb];
    const PavementStrip strip = strip_of(t, image);
    PavementWidthParams params;
    params.next_kerb = around.next(t.at.x, t.at.y, t.across_x, t.across_y, kNearestStep, params_.reach).distance;
    const StripWidth found = pavement_width(strip, params);
    const KerbAhead road = around.next(t.at.x, t.at.y, -t.across_x, -t.across_y, kNearestStep, params_.widest_road);
    PavementWidth width;
    width.kerb = kerb.id, width.number = t.number, width.kerb_seen = kerb.seen;
    width.from = in_crs(t.at.x, t.at.y, t.at.z);
    width.to = in_crs(t.at.x + found.width * t.across_x, t.at.y + found.width * t.across_y,
                      height_at(strip, found.width, t.at.z));
    width.end = found.end, width.width_m = found.width;
    if (found.end == PavementEnd::wall) width.error_m = kPixelsOfError * raster_.scale.pixel;
    width.passable_m = found.passable, width.passable_from_m = found.passable_from;
    width.unseen_share = found.unseen_share;
    width.road_m = road.faces ? road.distance : 0;
    return width;
  }

  // The mean height of the last ground before the end; that of the kerb where none was seen.
  static double height_at(const PavementStrip& strip, double width, double kerb) {
    const auto last = std::min<std::int64_t>(strip.columns, std::llround(width / strip.step)) - 1;
    for (std::int64_t c = last; c >= 0; --c) {
      double sum = 0, count = 0;
      for (std::uint32_t r = strip.first; r < strip.last; ++r)
        if (const std::size_t i = strip.at(r, static_cast<std::uint32_t>(c)); strip.pixels[i] == PavementPixel::ground)
          sum += strip.heights[i], count += 1;
      if (count > 0) return sum / count;
    }
    return kerb;
  }

  const StreetTiles& tiles_;
  const TileRaster& raster_;
  std::span<const StreetKerb> kerbs_;
  std::span<const PavementPixel> standing_;
  StreetPavementsParams params_;
  Occupancy low_bins_ = 0, waist_bins_ = 0;
  std::vector<std::vector<Vec3>> lines_;  // metres on the raster
};

}  // namespace

std::vector<PavementWidth> find_pavement_widths(const StreetTiles& tiles, std::span<const StreetKerb> kerbs,
                                                std::span<const PavementPixel> standing,
                                                const StreetPavementsParams& params) {
  return PavementFinder(tiles, kerbs, standing, params).find();
}

}  // namespace ilot
