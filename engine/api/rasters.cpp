// SPDX-License-Identifier: Apache-2.0
#include "ilot/rasters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "engine/error.h"
#include "kernels/morphology/fill.h"
#include "kernels/morphology/reconstruct.h"
#include "kernels/morphology/watershed.h"

namespace ilot {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kMostPixels = 0x1p31, kMostHeight = 0x1p30;

void check_raster(bool good, const char* sentence) {
  if (!good) throw Error(std::string("raster: ") + sentence, ExitCode::usage);
}

void check_size(const Raster& raster) {
  check_raster(raster.values.size() == std::size_t{raster.width} * raster.height, "values are not width x height");
  check_raster(static_cast<double>(raster.values.size()) < kMostPixels, "2^31 pixels or more");
}

// `missing` stands where there is no value.
Image to_image(const Raster& raster, double resolution, Height missing) {
  check_size(raster);
  check_raster(resolution > 0, "resolution must be above 0");
  Image image{raster.width, raster.height, std::vector<Height>(raster.values.size())};
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    const double v = raster.values[i];
    if (std::isnan(v)) {
      image.values[i] = missing;
      continue;
    }
    const double whole = std::round(v / resolution);
    check_raster(std::abs(whole) < kMostHeight, "a value is beyond 2^30 resolutions");
    image.values[i] = static_cast<Height>(whole);
  }
  return image;
}

Raster to_raster(const Image& image, const Raster& like, double resolution) {
  Raster raster{like.x0, like.y0, like.pixel, image.width, image.height, std::vector<double>(image.size())};
  for (std::size_t i = 0; i < image.size(); ++i) {
    const Height v = image.values[i];
    raster.values[i] = v == kNoHeight || v == kAboveAll ? kNone : v * resolution;
  }
  return raster;
}

void check_same_size(const Raster& a, const Raster& b) {
  check_raster(a.width == b.width && a.height == b.height, "the two have different sizes");
}

}  // namespace

Raster raster_of_points(const PointArrays& points, double pixel, PixelValue value) {
  static_cast<void>(lattice_step(points));  // sizes and coordinates
  check_raster(pixel > 0, "pixel must be above 0");
  const auto [x_min, x_max] = std::minmax_element(points.x.begin(), points.x.end());
  const auto [y_min, y_max] = std::minmax_element(points.y.begin(), points.y.end());
  const double column0 = std::floor(*x_min / pixel), row0 = std::floor(*y_min / pixel);
  const double columns = std::floor(*x_max / pixel) - column0 + 1, rows = std::floor(*y_max / pixel) - row0 + 1;
  check_raster(columns * rows < kMostPixels, "2^31 pixels or more");
  Raster raster{
      column0 * pixel, row0 * pixel, pixel, static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows), {}};
  const bool counts = value == PixelValue::count;
  raster.values.assign(std::size_t{raster.width} * raster.height, counts ? 0 : kNone);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const auto column = static_cast<std::size_t>(std::floor(points.x[i] / pixel) - column0);
    const auto row = static_cast<std::size_t>(std::floor(points.y[i] / pixel) - row0);
    double& v = raster.values[row * raster.width + column];
    const double z = points.z[i];
    if (counts) {
      ++v;
    } else if (std::isnan(v) || (value == PixelValue::highest ? z > v : z < v)) {
      v = z;
    }
  }
  return raster;
}

Raster fill_short_gaps(const Raster& raster, std::uint32_t longest, double step, double resolution) {
  const Image image = to_image(raster, resolution, kNoHeight);
  const double most = std::round(step / resolution);
  check_raster(most >= 0 && most < kMostHeight, "step is out of range");
  return to_raster(fill_short_gaps(image, {longest, static_cast<Height>(most)}), raster, resolution);
}

Raster reconstruct_by_erosion(const Raster& marker, const Raster& mask, Adjacency adjacency, double resolution) {
  check_same_size(marker, mask);
  return to_raster(
      reconstruct_by_erosion(to_image(marker, resolution, kAboveAll), to_image(mask, resolution, kNoHeight), adjacency),
      mask, resolution);
}

Raster reconstruct_by_dilation(const Raster& marker, const Raster& mask, Adjacency adjacency, double resolution) {
  check_same_size(marker, mask);
  return to_raster(reconstruct_by_dilation(to_image(marker, resolution, kNoHeight),
                                           to_image(mask, resolution, kNoHeight), adjacency),
                   mask, resolution);
}

std::vector<std::uint32_t> watershed(const Raster& relief, std::span<const std::uint32_t> markers, Adjacency adjacency,
                                     double resolution) {
  const Image image = to_image(relief, resolution, kNoHeight);
  check_raster(markers.size() == image.size(), "as many markers as pixels are needed");
  PixelLabels labels{relief.width, relief.height, 0, {markers.begin(), markers.end()}};
  for (const std::uint32_t label : markers) labels.count = std::max(labels.count, label);
  return watershed(image, labels, adjacency).of;
}

}  // namespace ilot
