// SPDX-License-Identifier: Apache-2.0
#include "tools/render/canvas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ilot::render {
namespace {

constexpr float kEmpty = -std::numeric_limits<float>::infinity();
constexpr double kStrength = 0.06;  // strength of the shading, per pixel of mean depth difference
constexpr float kDeepest = 30;      // pixels: the darkest edge is that of a step of this height

}  // namespace

ViewAxes axes_of(const View& view) {
  const double azimuth = view.azimuth_deg * std::numbers::pi / 180,
               elevation = view.elevation_deg * std::numbers::pi / 180;
  const Vec3 ahead{std::sin(azimuth), std::cos(azimuth), 0}, above{0, 0, 1};
  const double s = std::sin(elevation), c = std::cos(elevation);
  return {{ahead.y, -ahead.x, 0}, s * ahead + c * above, s * above - c * ahead};
}

Canvas::Canvas(int width, int height)
    : width_(width),
      height_(height),
      depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kEmpty),
      colour_(depth_.size(), Rgb{255, 255, 255}) {}

void Canvas::draw(int column, int row, float depth, Rgb colour, int radius) {
  const int left = std::max(0, column - radius), right = std::min(width_ - 1, column + radius);
  const int top = std::max(0, row - radius), bottom = std::min(height_ - 1, row + radius);
  for (int y = top; y <= bottom; ++y) {
    for (int x = left; x <= right; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      if (depth <= depth_[i]) continue;
      depth_[i] = depth;
      colour_[i] = colour;
    }
  }
}

// Returns the mean of how much nearer the pixels around are. Farther or empty pixels count as level.
float Canvas::nearer_by(int column, int row, float limit) const {
  const auto at = [&](int x, int y) {
    x = std::clamp(x, 0, width_ - 1);
    y = std::clamp(y, 0, height_ - 1);
    return depth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
  };
  const float here = at(column, row);
  float sum = 0;
  for (int dy = -2; dy <= 2; dy += 2)
    for (int dx = -2; dx <= 2; dx += 2) sum += std::clamp(at(column + dx, row + dy) - here, 0.0f, limit);
  return sum / 8;
}

Image Canvas::shaded(double pixel) const {
  Image image{width_, height_, colour_};
  const auto limit = static_cast<float>(kDeepest * pixel);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
      if (depth_[i] == kEmpty) continue;
      const double light = std::exp(-kStrength * nearer_by(x, y, limit) / pixel);
      for (std::uint8_t& channel : image.pixels[i]) channel = static_cast<std::uint8_t>(channel * light);
    }
  }
  return image;
}

}  // namespace ilot::render
