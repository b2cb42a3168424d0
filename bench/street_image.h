// SPDX-License-Identifier: Apache-2.0
// The image on which raster kernels are timed: a street from above at 20 pixels per metre, with heights in millimetres.
// It has facades on both sides, a pavement, noise of 2 cm, a slope of 2 %, cars, posts and walkers every few metres
// with their laser shadows, and one pixel in ten that no pulse met. It is made from a counter, so it is the same
// everywhere.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

#include "bench/compare.h"
#include "kernels/core/rng.h"
#include "kernels/rasters/image.h"

namespace ilot::bench {

constexpr std::uint32_t kStreetWidth = 800;  // pixels across: 40 m

struct Box {
  std::uint32_t x, y, width, height;
};

inline void put_box(Image& image, const Box& box, Height height) {
  for (std::uint32_t y = box.y; y < std::min(box.y + box.height, image.height); ++y)
    for (std::uint32_t x = box.x; x < std::min(box.x + box.width, image.width); ++x)
      image.values[std::size_t{y} * image.width + x] = height;
}

// Returns the height of ground and facades without noise. x runs along the street.
inline Height bare_height(std::uint32_t x, std::uint32_t y) {
  const auto slope = static_cast<Height>(x);  // 1 mm per pixel of 5 cm
  if (y < 160 || y >= 640) return slope + 12000 + static_cast<Height>(x / 300 % 5) * 1500;
  return slope + (y < 240 || y >= 560 ? 150 : 0);
}

// Puts an object of `height` and the laser shadow behind it into the image.
inline void put_object(Image& image, Box box, Height height) {
  const Height ground = bare_height(box.x, box.y);
  put_box(image, box, ground + height);
  put_box(image, {box.x, box.y + box.height, box.width, 30}, kNoHeight);
}

// The image has as many whole columns as give about `pixels`.
inline Image make_street_image(std::size_t pixels) {
  Image image = filled_image(static_cast<std::uint32_t>(pixels / kStreetWidth), kStreetWidth, 0);
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x) image.values[std::size_t{y} * image.width + x] = bare_height(x, y);
  for (std::uint32_t x = 20; x + 100 < image.width; x += 130) {
    put_object(image, {x, 260, 84, 36}, 1500);
    put_object(image, {x + 40, 200, 10, 10}, 1750);
    if (x % 500 < 130) put_object(image, {x + 90, 590, 4, 4}, 6000);
  }
  Rng rng(1);
  for (Height& v : image.values) {
    if (rng.below(10) == 0) v = kNoHeight;
    if (v != kNoHeight) v += static_cast<Height>(rng.below(41) + rng.below(41)) - 40;
  }
  return image;
}

inline std::string in_megapixels(double n) {
  const std::string points = in_millions(n);
  return points.substr(0, points.find(" points")) + " pixels";
}

}  // namespace ilot::bench
