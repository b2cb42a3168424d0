// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/hough_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <span>

#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr int kMaxRounds = 50;

// A pixel above 0, and its place along the two axes of the walk.
struct Voter {
  std::uint32_t slow, fast, weight;
};

// Voters row by row, and column by column. A direction is processed along the axis on which rho changes faster, so that
// consecutive voters seldom vote for the same cell.
struct Voters {
  std::vector<Voter> by_row, by_column;
};

Voters voters_of(const Image& weights) {
  Voters voters;
  for (std::uint32_t y = 0; y < weights.height; ++y)
    for (std::uint32_t x = 0; x < weights.width; ++x)
      if (const Height v = weights.values[std::size_t{y} * weights.width + x]; v > 0)
        voters.by_row.push_back({y, x, static_cast<std::uint32_t>(v)});
  std::vector<std::size_t> at(std::size_t{weights.width} + 1, 0);
  for (const Voter& v : voters.by_row) ++at[v.fast + 1];
  for (std::size_t x = 0; x < weights.width; ++x) at[x + 1] += at[x];
  voters.by_column.resize(voters.by_row.size());
  for (const Voter& v : voters.by_row) voters.by_column[at[v.fast]++] = {v.fast, v.slow, v.weight};
  return voters;
}

struct Direction {
  double cosine, sine;
};

Direction direction(std::uint32_t k, std::uint32_t directions) {
  const double degrees = 180.0 * k / directions;
  return {cos_degrees(degrees), cos_degrees(degrees - 90)};
}

// Cells of rho from -width to width + height.
struct RhoAxis {
  double offset;
  std::size_t cells;
};

RhoAxis rho_axis(const Image& image) {
  return {image.width + 1.5, std::size_t{2} * image.width + image.height + 4};
}

struct Peak {
  std::int64_t votes = 0;
  std::uint32_t direction = 0;
  std::size_t cell = 0;
};

void vote(std::span<const Voter> voters, double per_slow, double per_fast, double offset, std::int64_t* cells) {
  for (const Voter& v : voters) {
    const double rho = (v.slow * per_slow + offset) + v.fast * per_fast;
    cells[static_cast<std::size_t>(static_cast<std::int64_t>(rho))] += v.weight;
  }
}

Peak peak_of_direction(const Voters& voters, const RhoAxis& axis, std::uint32_t k, std::uint32_t directions) {
  std::vector<std::int64_t> cells(axis.cells, 0);
  const Direction n = direction(k, directions);
  if (std::abs(n.cosine) >= std::abs(n.sine)) {
    vote(voters.by_row, n.sine, n.cosine, axis.offset, cells.data());
  } else {
    vote(voters.by_column, n.cosine, n.sine, axis.offset, cells.data());
  }
  const auto best = std::max_element(cells.begin(), cells.end());
  return {*best, k, static_cast<std::size_t>(best - cells.begin())};
}

Peak highest_peak(const Image& weights, std::uint32_t directions) {
  const Voters voters = voters_of(weights);
  const RhoAxis axis = rho_axis(weights);
  std::vector<Peak> peaks(directions);
  parallel_for(directions, [&](std::size_t k) {
    peaks[k] = peak_of_direction(voters, axis, static_cast<std::uint32_t>(k), directions);
  });
  return *std::max_element(peaks.begin(), peaks.end(), [](const Peak& a, const Peak& b) { return a.votes < b.votes; });
}

ImageLine oriented(double nx, double ny, double d) {
  const bool turn = ny < 0 || (ny == 0 && nx < 0);
  return turn ? ImageLine{-nx, -ny, -d} : ImageLine{nx, ny, d};
}

ImageLine line_of(const Peak& peak, const Image& weights, std::uint32_t directions) {
  const Direction n = direction(peak.direction, directions);
  const double rho = static_cast<double>(peak.cell) + 0.5 - rho_axis(weights).offset;
  return oriented(n.cosine, n.sine, -rho);
}

// Calls take(x, y, weight, distance) for the pixels above 0 within reach of the line, row by row.
template <typename Take>
void for_pixels_near(const Image& weights, const ImageLine& line, double reach, const Take& take) {
  for (std::uint32_t y = 0; y < weights.height; ++y) {
    const double at_row = line.ny * y + line.d;
    double from = 0, to = weights.width - 1.0;
    if (std::abs(line.nx) > 1e-9) {  // slightly wider than the strip; the distance decides
      const double a = (-reach - at_row) / line.nx, b = (reach - at_row) / line.nx;
      from = std::max(from, std::floor(std::min(a, b)) - 1);
      to = std::min(to, std::ceil(std::max(a, b)) + 1);
    } else if (std::abs(at_row) > reach + 1) {
      continue;
    }
    for (double x = from; x <= to; ++x) {
      const Height v = weights.values[std::size_t{y} * weights.width + static_cast<std::size_t>(x)];
      const double distance = line.nx * x + at_row;
      if (v > 0 && std::abs(distance) <= reach) take(x, static_cast<double>(y), static_cast<double>(v), distance);
    }
  }
}

// Weighted orthogonal least squares of the pixels near `line`. Coordinates are relative to the point of the line
// nearest to (0, 0), so that squares stay small.
ImageLine fitted(const Image& weights, const ImageLine& line, double reach) {
  const double x0 = -line.d * line.nx, y0 = -line.d * line.ny;
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0, wyy = 0;
  for_pixels_near(weights, line, reach, [&](double px, double py, double v, double) {
    const double x = px - x0, y = py - y0;
    w += v;
    wx += v * x;
    wy += v * y;
    wxx += v * x * x;
    wxy += v * x * y;
    wyy += v * y * y;
  });
  if (w == 0) return line;
  const double cx = wx / w, cy = wy / w;
  const double half = 0.5 * ((wxx - wx * cx) - (wyy - wy * cy)), mixed = wxy - wx * cy;
  const double radius = std::sqrt(half * half + mixed * mixed);
  // The direction of the greatest spread, from the half of the formula that has no cancellation.
  const double dx = half >= 0 ? half + radius : mixed, dy = half >= 0 ? mixed : radius - half;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return line;  // one pixel, or equal spread in all directions
  const double nx = -dy / length, ny = dx / length;
  return oriented(nx, ny, -(nx * (cx + x0) + ny * (cy + y0)));
}

ImageLine refined(const Image& weights, ImageLine line, double reach) {
  for (int round = 0; round < kMaxRounds; ++round) {
    const ImageLine next = fitted(weights, line, reach);
    if (next.nx == line.nx && next.ny == line.ny && next.d == line.d) break;
    line = next;
  }
  return line;
}

HoughLine described(const Image& weights, const ImageLine& line, double reach) {
  HoughLine out{line, 0, 0, 0};
  double squares = 0;
  for_pixels_near(weights, line, reach, [&](double x, double y, double v, double distance) {
    if (out.weight == 0) out.first = static_cast<std::uint32_t>(y * weights.width + x);
    out.weight += v;
    squares += v * distance * distance;
  });
  if (out.weight > 0) out.rms = std::sqrt(squares / out.weight);
  return out;
}

}  // namespace

std::vector<HoughLine> hough_lines(const Image& weights, const HoughLinesParams& params) {
  assert(params.directions >= 1);
  std::vector<HoughLine> lines;
  Image rest = weights;
  double least = 0;
  while (lines.size() < params.max_lines && rest.size() > 0) {
    const Peak peak = highest_peak(rest, params.directions);
    if (peak.votes == 0 || static_cast<double>(peak.votes) < least) break;
    if (lines.empty()) least = params.least_share * static_cast<double>(peak.votes);
    const ImageLine coarse = line_of(peak, rest, params.directions);
    lines.push_back(described(rest, refined(rest, coarse, params.max_distance), params.max_distance));
    // The pixels of the cell itself are removed too, because the refined line may have left them and the search must
    // end.
    for (const ImageLine& line : {lines.back().line, coarse})
      for_pixels_near(weights, line, params.max_distance, [&](double x, double y, double, double) {
        rest.values[static_cast<std::size_t>(y) * rest.width + static_cast<std::size_t>(x)] = 0;
      });
  }
  return lines;
}

}  // namespace ilot
