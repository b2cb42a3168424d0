// SPDX-License-Identifier: Apache-2.0
// Finds the sides of openings from the contour of the wall's points. Compares lines by a 2D Hough transform [Lorraine
// thesis, 4.1], lines by 2D RANSAC and orthogonal least squares [Marchand 2018, II.5.1], and the edges of our plans,
// which use rays and side faces. Prints the distance of each side from the truth at its middle. Usage:
// study_contour_lines OUT TRUTH. OUT is the folder of ilot run --products facades.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/compare/evaluate.h"
#include "engine/compare/facades/truth_facades.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/proof/point_stream.h"
#include "kernels/core/rng.h"
#include "kernels/rasters/hough_lines.h"

namespace {

using namespace ilot;

constexpr double kOnWall = 0.015;    // metres
constexpr double kAround = 0.2;      // metres around an opening in which its contour may be
constexpr double kPixel = 0.01;      // metres
constexpr double kNear = 0.02;       // metres; points within it belong to a line, for both methods
constexpr std::size_t kLines = 12;   // lines sought in the contour of one opening
constexpr double kLeastShare = 0.1;  // share of the points of the strongest line
constexpr int kDraws = 500;
constexpr double kFiveDegrees =
    0.0872;  // sine of the angle by which a side may differ from level or upright [Marchand 2018, II.5.1]

enum Side : std::size_t { kBottom, kRight, kTop, kLeft };
constexpr std::array kSideNames{"bottom", "right", "top", "left"};

struct Rectangle {
  double u0, u1, v0, v1;
  double at(std::size_t side) const { return side == kBottom ? v0 : side == kTop ? v1 : side == kLeft ? u0 : u1; }
};
using Sides = std::array<std::optional<double>, 4>;

// The line nx u + ny v = d. Lines are sorted with the strongest first.
struct ContourLine {
  double nx, ny, d;
};

Rectangle box_of(const std::vector<Vec3>& ring, const Facade& f) {
  Rectangle box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const Vec3& p : ring) {
    const double u = dot(p - f.origin, f.right), v = dot(p - f.origin, f.up);
    box = {std::min(box.u0, u), std::max(box.u1, u), std::min(box.v0, v), std::max(box.v1, v)};
  }
  return box;
}

// Returns for each side of the opening the strongest line that belongs to it, if there is one.
Sides sides_of(const std::vector<ContourLine>& lines, const Rectangle& about) {
  const double u = (about.u0 + about.u1) / 2, v = (about.v0 + about.v1) / 2;
  Sides sides;
  for (const ContourLine& line : lines) {
    std::size_t side = kBottom;
    double at = 0;
    if (std::abs(line.ny) < kFiveDegrees)
      at = (line.d - line.ny * v) / line.nx, side = at > u ? kRight : kLeft;
    else if (std::abs(line.nx) < kFiveDegrees)
      at = (line.d - line.nx * u) / line.ny, side = at > v ? kTop : kBottom;
    else
      continue;
    if (std::abs(at - about.at(side)) <= kAround && !sides[side]) sides[side] = at;
  }
  return sides;
}

std::vector<ContourLine> hough(const std::vector<FlatPoint>& chain, const Rectangle& box) {
  const auto pixels = [](double metres) { return static_cast<std::uint32_t>(metres / kPixel) + 1; };
  Image image = filled_image(pixels(box.u1 - box.u0), pixels(box.v1 - box.v0), 0);
  for (const FlatPoint& p : chain) {
    const auto column = static_cast<std::size_t>((p.x - box.u0) / kPixel);
    ++image.values[static_cast<std::size_t>((p.y - box.v0) / kPixel) * image.width + column];
  }
  HoughLinesParams params;
  params.max_distance = kNear / kPixel;
  params.max_lines = kLines;
  params.least_share = kLeastShare;
  std::vector<ContourLine> lines;
  for (const HoughLine& h : hough_lines(image, params)) {
    // In the Hough transform, the centres of pixels are integers.
    const double shift = (box.u0 / kPixel + 0.5) * h.line.nx + (box.v0 / kPixel + 0.5) * h.line.ny;
    lines.push_back({h.line.nx, h.line.ny, (shift - h.line.d) * kPixel});
  }
  return lines;
}

bool is_near(const ContourLine& line, FlatPoint p) {
  return std::abs(line.nx * p.x + line.ny * p.y - line.d) <= kNear;
}

// Fits a line to the points near it by orthogonal least squares.
ContourLine refined(const ContourLine& line, const std::vector<FlatPoint>& chain) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (const FlatPoint& p : chain)
    if (is_near(line, p)) n += 1, x += p.x, y += p.y;
  x /= n, y /= n;
  for (const FlatPoint& p : chain)
    if (is_near(line, p)) xx += (p.x - x) * (p.x - x), xy += (p.x - x) * (p.y - y), yy += (p.y - y) * (p.y - y);
  const double half = (xx - yy) / 2, root = std::sqrt(half * half + xy * xy);
  double nx = xy, ny = -half - root;  // of the smaller eigenvalue
  if (half < 0) nx = half - root, ny = xy;
  const double length = std::sqrt(nx * nx + ny * ny);
  if (!(length > 0)) return line;
  nx /= length, ny /= length;
  return {nx, ny, nx * x + ny * y};
}

std::vector<ContourLine> ransac(std::vector<FlatPoint> chain) {
  Rng rng(1);
  std::vector<ContourLine> lines;
  std::ptrdiff_t first = 0;
  while (lines.size() < kLines && chain.size() >= 2) {
    ContourLine best{0, 1, 0};
    std::ptrdiff_t most = 0;
    for (int i = 0; i < kDraws; ++i) {
      const FlatPoint a = chain[rng.below(chain.size())];
      const FlatPoint b = chain[rng.below(chain.size())];
      const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
      if (!(length > 2 * kNear)) continue;
      const double nx = (b.y - a.y) / length, ny = (a.x - b.x) / length;
      const ContourLine line{nx, ny, nx * a.x + ny * a.y};
      const auto near = std::count_if(chain.begin(), chain.end(), [&](FlatPoint p) { return is_near(line, p); });
      if (near > most) best = line, most = near;
    }
    if (lines.empty()) first = most;
    if (most < 2 || static_cast<double>(most) < kLeastShare * static_cast<double>(first)) break;
    const ContourLine line = refined(best, chain);
    lines.push_back(line);
    std::erase_if(chain, [&](FlatPoint p) { return is_near(best, p); });
  }
  return lines;
}

double common_share(const Rectangle& a, const Rectangle& b) {
  const double w = std::min(a.u1, b.u1) - std::max(a.u0, b.u0), h = std::min(a.v1, b.v1) - std::max(a.v0, b.v0);
  const double common = w > 0 && h > 0 ? w * h : 0;
  const auto area = [](const Rectangle& r) { return (r.u1 - r.u0) * (r.v1 - r.v0); };
  return common / (area(a) + area(b) - common);
}

Sides ours(const std::vector<Facade>& found, const Facade& truth, const Rectangle& box) {
  Sides sides;
  for (const Facade& f : found) {
    if (dot(f.out, truth.out) < 0.99 || std::abs(dot(f.origin - truth.origin, truth.out)) > 0.2) continue;
    for (const FacadeElement& e : f.elements) {
      const Rectangle own = box_of(e.ring, truth);
      if (!e.opening || common_share(own, box) < 0.5) continue;
      for (std::size_t s = 0; s < 4; ++s)
        if (e.edges.size() != 4 || e.edges[s].status != DrawnStatus::occluded) sides[s] = own.at(s);
    }
  }
  return sides;
}

struct Errors {
  std::size_t sides = 0, found = 0;
  double sum = 0, signed_sum = 0, squares = 0;

  void add(const Sides& s, const Rectangle& truth, std::size_t side) {
    ++sides;
    if (!s[side]) return;
    const double outwards = (side == kRight || side == kTop ? 1 : -1) * (*s[side] - truth.at(side)) * 100;
    ++found;
    sum += std::abs(outwards), signed_sum += outwards, squares += outwards * outwards;
  }
  void print(const char* method, const char* side) const {
    const auto n = static_cast<double>(found), mean = found > 0 ? sum / n : 0;
    const double sd = found > 0 ? std::sqrt(std::max(0.0, squares / n - mean * mean)) : 0;
    fmt::print("{:10} {:7} {:4} of {:4} {:8.2f} {:8.2f} {:9.2f}\n", method, side, found, sides, mean, sd,
               found > 0 ? signed_sum / n : 0);
  }
};

std::vector<Vec3> contour_points(const ResultFiles& files) {
  std::vector<Vec3> points;
  for (const auto& cloud : files.clouds) {
    const auto reader = open_cloud(cloud);
    const auto boundary = find_integer_field(reader->info().layout, "boundary");
    if (!boundary) continue;
    for_each_record(*reader, [&](const std::byte* record) {
      if (integer_of(record, *boundary) != 0) points.push_back(position_of(record, reader->info().layout));
    });
  }
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print("study_contour_lines OUT TRUTH\n");
    return 2;
  }
  const ResultFiles files = find_results(argv[1]);
  const std::vector<Vec3> contour = contour_points(files);
  std::vector<Facade> found;
  for (const auto& file : files.facades) found.push_back(read_facade_json(file));
  std::array<std::array<Errors, 4>, 3> errors;
  for (const Facade& wall : true_facades(read_truth(argv[2])))
    for (const FacadeElement& e : wall.elements) {
      if (!e.opening || e.ring.size() != 4) continue;
      const Rectangle box = box_of(e.ring, wall);
      const Rectangle around{box.u0 - kAround, box.u1 + kAround, box.v0 - kAround, box.v1 + kAround};
      std::vector<FlatPoint> chain;
      for (const Vec3& p : contour) {
        const double u = dot(p - wall.origin, wall.right), v = dot(p - wall.origin, wall.up);
        if (std::abs(dot(p - wall.origin, wall.out)) <= kOnWall && u > around.u0 && u < around.u1 && v > around.v0 &&
            v < around.v1)
          chain.push_back({u, v});
      }
      const std::array<Sides, 3> sides{sides_of(hough(chain, around), box), sides_of(ransac(chain), box),
                                       ours(found, wall, box)};
      for (std::size_t m = 0; m < 3; ++m)
        for (std::size_t s = 0; s < 4; ++s) errors[m][s].add(sides[m], box, s);
    }
  fmt::print("method     side     found      mean, cm sd, cm outwards, cm\n");
  constexpr std::array kMethods{"Hough", "RANSAC", "plan"};
  for (std::size_t m = 0; m < 3; ++m)
    for (std::size_t s = 0; s < 4; ++s) errors[m][s].print(kMethods[m], kSideNames[s]);
  return 0;
}
