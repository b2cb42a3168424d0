// SPDX-License-Identifier: Apache-2.0
// Weighted Hough lines of the range image of a street at 5 pixels per metre. They are compared with a simple loop,
// pixel by pixel over all directions. The same cell must win before any timing.
#include "kernels/rasters/hough_lines.h"

#include <cmath>
#include <numbers>

#include "bench/compare.h"
#include "bench/street_image.h"

namespace {

using namespace ilot;

struct Cell {
  std::int64_t votes = 0;
  double theta = 0, rho = 0;
};

Cell plain(const Image& image, int directions) {
  const auto reach = static_cast<std::size_t>(image.width) + image.height + 2;
  std::vector<double> cosines, sines;
  for (int k = 0; k < directions; ++k) {
    cosines.push_back(std::cos(k * std::numbers::pi / directions));
    sines.push_back(std::sin(k * std::numbers::pi / directions));
  }
  std::vector<std::int64_t> cells(static_cast<std::size_t>(directions) * 2 * reach, 0);
  for (std::uint32_t y = 0; y < image.height; ++y)
    for (std::uint32_t x = 0; x < image.width; ++x)
      if (const Height v = image.values[std::size_t{y} * image.width + x]; v > 0)
        for (std::size_t k = 0; k < cosines.size(); ++k) {
          const long rho = std::lround(x * cosines[k] + y * sines[k]);
          cells[k * 2 * reach + reach + static_cast<std::size_t>(rho)] += v;
        }
  Cell best;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i] > best.votes)
      best = {cells[i], static_cast<double>(i / (2 * reach)) * std::numbers::pi / directions,
              static_cast<double>(i % (2 * reach)) - static_cast<double>(reach)};
  return best;
}

// Takes every fourth pixel in each direction: 5 per metre from 20 per metre.
Image coarse_street(double millions) {
  const Image fine = bench::make_street_image(static_cast<std::size_t>(16e6 * millions));
  Image out = filled_image(fine.width / 4, fine.height / 4, 0);
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x)
      out.values[std::size_t{y} * out.width + x] = fine.values[std::size_t{4 * y} * fine.width + 4 * x];
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {0.25})) {
    const Image street = coarse_street(millions);
    const Cell want = plain(street, 360);
    const auto got = hough_lines(street, {.max_distance = 1});
    const ImageLine line = got.at(0).line;
    bench::require(std::abs(std::cos(want.theta) * line.nx + std::sin(want.theta) * line.ny) > 0.9999 &&
                       std::abs(std::abs(want.rho) - std::abs(line.d)) < 3,
                   "hough_lines: another line than the plain loop's");
    double votes = 0;
    for (const Height v : street.values) votes += v > 0 ? 360 : 0;
    bench::compare(
        {"hough_lines", "360 directions, street, " + bench::in_megapixels(millions), 1, votes / 1e6, "M votes"},
        {{"ilot, with refinement", [&] { hough_lines(street, {.max_distance = 1}); }},
         {"pixel by pixel", [&] { plain(street, 360); }}});
    bench::scaling({.kernel = "hough_lines", .variant = bench::in_megapixels(millions)},
                   [&] { hough_lines(street, {.max_distance = 1}); });
  }
}
