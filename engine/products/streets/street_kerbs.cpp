// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_kerbs.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "engine/products/streets/kerbs/kerb_lines.h"
#include "engine/products/streets/kerbs/step_fit.h"
#include "engine/products/streets/street_labels.h"
#include "engine/store/stretches.h"
#include "engine/tiles/lattice_cells.h"
#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Choice: places of a step are about so far apart; a kerb of two metres has ten.
constexpr double kLeastStepCell = 0.2;  // metres
constexpr std::uint64_t kBytesOfGround = 2u << 20;
constexpr double kPi = 3.14159265358979323846;

// Sums over the ground points of a pixel, from the corner of the window.
struct GroundPixel {
  std::int64_t x = 0, y = 0, z = 0;  // lattice units
  std::uint32_t points = 0;
};

class KerbFinder {
 public:
  KerbFinder(const Store& store, const StreetTiles& tiles, const PointDensity& density, const PassContext& context,
             const StreetKerbsParams& params)
      : store_(store), raster_(tiles.raster()), context_(context) {
    const double pixel = raster_.scale.pixel;
    while (factor_ * pixel < kLeastStepCell - 1e-9 && raster_.grid.side % (2 * factor_) == 0) factor_ *= 2;
    fit_.radius = std::max({params.least_radius, 2 * factor_ * pixel,
                            std::sqrt(params.points_of_window / (kPi * std::max(1e-3, density.median)))});
    reach_ = static_cast<std::uint32_t>(std::ceil(fit_.radius / pixel)) + 1;
    halo_ = 2 * reach_;
    for (std::uint32_t v = 0; v <= 2 * reach_; ++v) chords_.push_back(chord(v, pixel));
    places_.resize(raster_.grid.count());
  }

  std::vector<StreetKerb> find() {
    const std::uint64_t side = raster_.grid.side + 2 * halo_;
    run_tasks(raster_.grid,
              std::vector<std::uint64_t>(
                  places_.size(), side * side * (sizeof(GroundPixel) + sizeof(GroundPoint) + 4) + kBytesOfGround),
              [&](std::size_t tile) { find_places(tile); });
    std::size_t count = 0;
    for (const auto& list : places_) count += list.size();
    need_bytes(raster_.grid, count * 4 * sizeof(StepPoint));
    std::vector<StepPoint> all;
    all.reserve(count);
    for (const auto& list : places_) all.insert(all.end(), list.begin(), list.end());
    KerbLineParams params;
    params.spacing = factor_ * raster_.scale.pixel;
    params.radius = fit_.radius;
    // Derived: places within a window share their points, so five windows are needed for a line that is no chance.
    params.least_length = std::max(params.least_length, 5 * fit_.radius);
    std::vector<StreetKerb> kerbs;
    for (const KerbLine& line : link_kerbs(all, params)) kerbs.push_back(kerb_of(line));
    for (std::size_t i = 0; i < kerbs.size(); ++i) kerbs[i].id = static_cast<std::uint32_t>(i + 1);
    return kerbs;
  }

 private:
  // The mean ground points of the pixels of a tile and around it, row by row: most pixels have none.
  struct Window {
    std::uint32_t side = 0;            // pixels
    std::vector<std::uint32_t> first;  // by pixel: the number of means before it; then the number of all
    std::vector<GroundPoint> mean;     // metres from the corner of the window
  };

  Window read(std::size_t tile) const {
    const std::uint32_t side = raster_.grid.side + 2 * halo_;
    std::vector<GroundPixel> pixels(std::size_t{side} * side);
    const Index3 corner = raster_.corner(tile);
    const std::int64_t halo_units = halo_ * raster_.pixel;
    const LatticeCells pixel_of(raster_.pixel);
    const IndexBox box = raster_.box(tile, halo_);
    for_each_stretch(store_, plan_view(store_, box, {}).slices, [&](const Stretch& s) {
      const std::vector<StreetLabel> labels = s.read(store_, columns::kStreet);
      for (std::size_t i = 0; i < s.codes.size(); ++i) {
        if (labels[i].label != PointLabel::ground) continue;
        const Index3 p = s.position(i);
        if (!box.contains(p)) continue;
        const std::int64_t x = p.x - corner.x + halo_units, y = p.y - corner.y + halo_units;
        GroundPixel& pixel = pixels[std::size_t{pixel_of(y)} * side + pixel_of(x)];
        pixel.x += x, pixel.y += y, pixel.z += height_of(p.z);
        ++pixel.points;
      }
    });
    return window_of(pixels, side);
  }

  Window window_of(const std::vector<GroundPixel>& pixels, std::uint32_t side) const {
    Window window{side, {}, {}};
    const auto seen = static_cast<std::size_t>(
        std::count_if(pixels.begin(), pixels.end(), [](const GroundPixel& p) { return p.points != 0; }));
    window.first.reserve(pixels.size() + 1);
    window.mean.reserve(seen);
    for (const GroundPixel& p : pixels) {
      window.first.push_back(static_cast<std::uint32_t>(window.mean.size()));
      if (p.points == 0) continue;
      const double per = raster_.scale.unit / p.points;
      window.mean.push_back(
          {static_cast<double>(p.x) * per, static_cast<double>(p.y) * per, static_cast<double>(p.z) * per});
    }
    window.first.push_back(static_cast<std::uint32_t>(window.mean.size()));
    return window;
  }

  // The most pixels on each side of a place that are within the radius in row v, of those from reach_ rows above it on.
  // A pixel n rows away has at least n - 1 pixels between it and the place.
  std::ptrdiff_t chord(std::uint32_t v, double pixel) const {
    const double rows = v < reach_ ? reach_ - v : v - reach_, apart = std::max(0.0, rows - 1) * pixel;
    const double half = std::sqrt(std::max(0.0, fit_.radius * fit_.radius - apart * apart));
    return std::min(std::ptrdiff_t{reach_}, static_cast<std::ptrdiff_t>(std::ceil(half / pixel)) + 1);
  }

  // The mean points of the pixels within the radius of a place (metres from the corner of the window), relative to it.
  // The window reaches so far beyond the tile that all of them are in it, also where the place has moved by a cell.
  // `room` is memory for them. Their heights are counted from that of the first one, which `base` gets.
  std::span<const GroundPoint> collect(const Window& window, double x, double y, std::vector<GroundPoint>& room,
                                       double& base) const {
    const double pixel = raster_.scale.pixel;
    const auto column = static_cast<std::size_t>(x / pixel), row = static_cast<std::size_t>(y / pixel);
    assert(row >= reach_ && row + reach_ < window.side && column >= reach_ && column + reach_ < window.side);
    const std::uint32_t* of_row = window.first.data() + (row - reach_) * window.side + column;
    std::size_t count = 0;
    for (const std::ptrdiff_t chord : chords_) {
      const std::uint32_t first = of_row[-chord], end = of_row[chord + 1];
      of_row += window.side;
      if (room.size() < count + (end - first)) room.resize(2 * (count + (end - first)));
      for (std::uint32_t i = first; i < end; ++i) {  // without branches, which would be mispredicted
        const GroundPoint& mean = window.mean[i];
        const GroundPoint at{mean.x - x, mean.y - y, mean.z};
        room[count] = at;
        count += at.x * at.x + at.y * at.y <= fit_.radius * fit_.radius;
      }
    }
    base = count == 0 ? 0 : room.front().z;  // small numbers lose no digits in sums of squares
    for (std::size_t i = 0; i < count; ++i) room[i].z -= base;
    return std::span(room).first(count);
  }

  void find_places(std::size_t tile) {
    const Window window = read(tile);
    if (window.mean.empty()) return;
    const double pixel = raster_.scale.pixel, cell = factor_ * pixel, halo = halo_ * pixel;
    const TileFrame frame = tile_frame(raster_.grid, tile);
    std::vector<GroundPoint> room;
    for (std::uint32_t row = 0; row < raster_.grid.side / factor_; ++row)
      for (std::uint32_t column = 0; column < raster_.grid.side / factor_; ++column) {
        double x = halo + (column + 0.5) * cell, y = halo + (row + 0.5) * cell;
        std::optional<StepFit> fit;
        for (int round = 0; round < 2; ++round) {  // the second window has the edge in its middle
          double base = 0;
          fit = fit_step(collect(window, x, y, room, base), fit_);
          if (!fit || norm(FlatPoint{fit->x, fit->y}) > cell) break;
          x += fit->x, y += fit->y;
          fit->z += base;
        }
        if (!fit || norm(FlatPoint{fit->x, fit->y}) > cell) continue;
        const double u = x - halo, v = y - halo;  // metres in the tile
        if (std::floor(u / cell) != column || std::floor(v / cell) != row) continue;
        add({frame.x * pixel + u, frame.y * pixel + v, fit->z, fit->up_x, fit->up_y, fit->height}, tile);
      }
  }

  void add(const StepPoint& place, std::size_t tile) {
    if (context_.wanted) {
      const double unit = store_.unit();
      const Vec3 p = position({place.x, place.y, place.z, place.height});
      if (!context_.wanted({std::llround(p.x / unit), std::llround(p.y / unit), 0})) return;
    }
    places_[tile].push_back(place);
  }

  Vec3 position(const KerbVertex& v) const {
    const double pixel = raster_.scale.pixel;
    return {raster_.crs_x(v.x / pixel), raster_.crs_y(v.y / pixel), v.z / raster_.scale.unit * raster_.unit};
  }

  StreetKerb kerb_of(const KerbLine& line) const {
    StreetKerb kerb;
    kerb.seen = line.seen;
    for (const KerbVertex& v : line.vertices) {
      kerb.line.push_back(position(v));
      kerb.heights_m.push_back(v.height);
      if (kerb.line.size() > 1) {
        const KerbVertex& before = line.vertices[kerb.line.size() - 2];
        kerb.length_m += norm(FlatPoint{v.x - before.x, v.y - before.y});
      }
    }
    std::vector<double> sorted = kerb.heights_m;
    std::sort(sorted.begin(), sorted.end());
    kerb.height_m = (sorted[(sorted.size() - 1) / 2] + sorted[sorted.size() / 2]) / 2;
    return kerb;
  }

  const Store& store_;
  const TileRaster& raster_;
  const PassContext& context_;
  StepFitParams fit_;
  std::uint32_t factor_ = 1, reach_ = 1, halo_ = 1;  // pixels
  std::vector<std::ptrdiff_t> chords_;               // pixels, by row of a window
  std::vector<std::vector<StepPoint>> places_;       // by tile
};

}  // namespace

std::vector<StreetKerb> find_street_kerbs(const Store& store, const StreetTiles& tiles, const PointDensity& density,
                                          const PassContext& context, const StreetKerbsParams& params) {
  return KerbFinder(store, tiles, density, context, params).find();
}

}  // namespace ilot
