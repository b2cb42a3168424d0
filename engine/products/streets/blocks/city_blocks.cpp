// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/blocks/city_blocks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/core/quantile.h"
#include "kernels/core/union_find.h"
#include "kernels/morphology/profile.h"
#include "kernels/rasters/hough_lines.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesSought = 12;  // bytes per pixel of a window in which lines are sought
constexpr std::uint32_t kLinesInWindow = 6;
// Choice: 1.5 degrees are 5 m over the 200 m of a window.
constexpr double kSameDirection = 0.99966;  // cosine of 1.5 degrees
constexpr Height kHeaviest = 1 << 20;       // greatest weight of the votes of one pixel

// A pixel of the coarse image that shows a facade.
struct FacadePixel {
  std::int32_t x, y;  // in coarse pixels of the whole image
  Height weight, height;
};

// Weighted sums over the pixels of a line, in coarse pixels about the middle of the whole image.
struct LineSums {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  void add(double px, double py, double w) {
    n += w, x += w * px, y += w * py, xx += w * px * px, xy += w * px * py, yy += w * py * py;
  }
  void add(const LineSums& o) { n += o.n, x += o.x, y += o.y, xx += o.xx, xy += o.xy, yy += o.yy; }
};

struct Line {
  double nx = 0, ny = 1, d = 0;
  double distance(double x, double y) const { return nx * x + ny * y + d; }
  double along(double x, double y) const { return ny * x - nx * y; }
};

// The orthogonal least squares line, with ny > 0, or ny = 0 < nx.
Line line_of(const LineSums& s) {
  const double mx = s.x / s.n, my = s.y / s.n;
  const double a = s.xx / s.n - mx * mx, b = s.xy / s.n - mx * my, c = s.yy / s.n - my * my;
  const double half = (a - c) / 2, root = std::sqrt(half * half + b * b);
  // This is the eigenvector of the greater eigenvalue, computed by the better conditioned of two forms.
  double dx = half + root, dy = b;
  if (half < 0) dx = b, dy = root - half;
  const double length = std::sqrt(dx * dx + dy * dy);
  if (length <= 0) return {0, 1, -my};
  dx /= length, dy /= length;
  if (dx < 0 || (dx == 0 && dy < 0)) dx = -dx, dy = -dy;
  return {-dy, dx, dy * mx - dx * my};
}

using WindowKey = std::pair<std::int64_t, std::int64_t>;  // row, column

struct WindowLine {
  std::int64_t row = 0, column = 0;  // of its window
  Line line;
  LineSums sums;
  double from = 0, to = 0;  // along it
};

class BlockFinder {
 public:
  BlockFinder(const TileLayers& layers, const RasterScale& scale, const CityBlocksParams& params)
      : layers_(layers),
        scale_(scale),
        params_(params),
        factor_(std::max(1u, static_cast<std::uint32_t>(std::lround(params.pixel / scale.pixel)))),
        pixel_(scale.pixel * factor_),
        window_(std::max<std::int64_t>(64, std::lround(params.window / pixel_))) {}

  std::vector<StreetStretch> find() {
    gather();
    const std::vector<WindowLine> lines = window_lines();
    std::vector<StreetStretch> stretches;
    for (const std::vector<std::size_t>& chain : chains_of(lines))
      if (auto stretch = stretch_of(lines, chain); !stretch.blocks.empty()) stretches.push_back(std::move(stretch));
    return stretches;
  }

 private:
  void gather() {
    std::vector<std::vector<FacadePixel>> of_tile(layers_.grid.count());
    for_each_tile(layers_.grid, [&](std::size_t tile) { of_tile[tile] = facade_pixels(tile); });
    std::map<WindowKey, std::size_t> sizes;
    for (const auto& list : of_tile)
      for (const FacadePixel& p : list) ++sizes[window_of(p)];
    for (auto& list : of_tile) {
      for (const FacadePixel& p : list) {
        std::vector<FacadePixel>& window = windows_[window_of(p)];
        if (window.empty()) window.reserve(sizes[window_of(p)]);
        window.push_back(p);
      }
      std::vector<FacadePixel>().swap(list);
    }
  }
  WindowKey window_of(const FacadePixel& p) const { return {p.y / window_, p.x / window_}; }

  std::vector<FacadePixel> facade_pixels(std::size_t tile) const {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    const Image range = layer_tile(layers_, "range", tile), mask = layer_tile(layers_, "mask", tile),
                level = layer_tile(layers_, "level", tile), accumulation = layer_tile(layers_, "accumulation", tile);
    const Height least = scale_.units(params_.least_facade);
    const std::uint32_t x0 = frame.x / factor_, y0 = frame.y / factor_;
    const std::uint32_t columns = (frame.x + frame.width - 1) / factor_ - x0 + 1;
    const std::uint32_t rows = (frame.y + frame.height - 1) / factor_ - y0 + 1;
    Image weights = filled_image(columns, rows, 0), heights = weights;
    std::size_t i = 0;
    for (std::uint32_t y = 0; y < frame.height; ++y) {
      for (std::uint32_t x = 0; x < frame.width; ++x, ++i) {
        if (mask.values[i] != 0 || range.values[i] == kNoHeight || level.values[i] == kNoHeight) continue;
        const Height height = range.values[i] - level.values[i];
        if (height < least) continue;
        const std::size_t c = std::size_t{(frame.y + y) / factor_ - y0} * columns + (frame.x + x) / factor_ - x0;
        weights.values[c] = std::min(kHeaviest, weights.values[c] + accumulation.values[i]);
        heights.values[c] = std::max(heights.values[c], height);
      }
    }
    std::vector<FacadePixel> list;
    for (std::uint32_t c = 0; c < weights.size(); ++c)
      if (heights.values[c] > 0)
        list.push_back({static_cast<std::int32_t>(x0 + c % columns), static_cast<std::int32_t>(y0 + c / columns),
                        weights.values[c], heights.values[c]});
    list.shrink_to_fit();
    return list;
  }

  std::vector<WindowLine> window_lines() const {
    std::vector<const std::pair<const WindowKey, std::vector<FacadePixel>>*> windows;
    for (const auto& entry : windows_) windows.push_back(&entry);
    std::vector<std::vector<WindowLine>> found(windows.size());
    const std::vector<std::uint64_t> bytes(windows.size(),
                                           static_cast<std::uint64_t>(window_ * window_) * kBytesSought);
    run_tasks(layers_.grid, bytes, [&](std::size_t i) {
      const auto& [key, pixels] = *windows[i];
      const std::int64_t x0 = key.second * window_, y0 = key.first * window_;
      Image weights = filled_image(static_cast<std::uint32_t>(window_), static_cast<std::uint32_t>(window_), 0);
      for (const FacadePixel& p : pixels)
        weights.values[static_cast<std::size_t>((p.y - y0) * window_ + p.x - x0)] = p.weight;
      for (const HoughLine& h : hough_lines(weights, {.max_lines = kLinesInWindow})) {
        WindowLine line{key.first, key.second, {}, {}, 0, 0};
        const double d = h.line.d - h.line.nx * static_cast<double>(x0) - h.line.ny * static_cast<double>(y0);
        line.line = {h.line.nx, h.line.ny, d};
        line.sums = sums_near(line.line, pixels);
        if (line.sums.n <= 0) continue;
        measure(line, pixels);
        if ((line.to - line.from) * pixel_ >= params_.least_length / 2) found[i].push_back(line);
      }
    });
    std::vector<WindowLine> all;
    for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  double reach() const { return params_.half_width / pixel_; }

  LineSums sums_near(const Line& line, const std::vector<FacadePixel>& pixels) const {
    LineSums sums;
    for (const FacadePixel& p : pixels)
      if (std::abs(line.distance(p.x, p.y)) <= reach()) sums.add(p.x - middle_x(), p.y - middle_y(), p.weight);
    return sums;
  }
  double middle_x() const { return std::floor(layers_.grid.width / factor_ / 2.0); }
  double middle_y() const { return std::floor(layers_.grid.height / factor_ / 2.0); }

  void measure(WindowLine& line, const std::vector<FacadePixel>& pixels) const {
    line.from = INFINITY, line.to = -INFINITY;
    for (const FacadePixel& p : pixels) {
      if (std::abs(line.line.distance(p.x, p.y)) > reach()) continue;
      line.from = std::min(line.from, line.line.along(p.x, p.y));
      line.to = std::max(line.to, line.line.along(p.x, p.y));
    }
  }

  // Returns true where each line continues the other: its nearer end lies on the other line.
  bool goes_on(const WindowLine& a, const WindowLine& b) const {
    if (std::abs(a.row - b.row) > 1 || std::abs(a.column - b.column) > 1) return false;
    if (std::abs(a.line.nx * b.line.nx + a.line.ny * b.line.ny) < kSameDirection) return false;
    const auto near_line = [&](const WindowLine& from, const WindowLine& to) {
      const double to_middle = 0.5 * (to.from + to.to);
      const double mx = -to.line.d * to.line.nx + to_middle * to.line.ny;
      const double my = -to.line.d * to.line.ny - to_middle * to.line.nx;
      const double along = from.line.along(mx, my);
      const double end = std::abs(along - from.from) < std::abs(along - from.to) ? from.from : from.to;
      const double x = -from.line.d * from.line.nx + end * from.line.ny;
      const double y = -from.line.d * from.line.ny - end * from.line.nx;
      return std::abs(to.line.distance(x, y)) <= 2 * reach();
    };
    return near_line(a, b) && near_line(b, a);
  }

  std::vector<std::vector<std::size_t>> chains_of(const std::vector<WindowLine>& lines) const {
    std::vector<std::uint32_t> parents(lines.size());
    UnionFind sets(parents);
    std::map<WindowKey, std::vector<std::uint32_t>> of_window;
    for (std::uint32_t i = 0; i < lines.size(); ++i) of_window[{lines[i].row, lines[i].column}].push_back(i);
    for (std::uint32_t i = 0; i < lines.size(); ++i)
      for (std::int64_t row = lines[i].row - 1; row <= lines[i].row; ++row)
        for (std::int64_t column = lines[i].column - 1; column <= lines[i].column + 1; ++column) {
          const auto beside = of_window.find({row, column});
          if (beside == of_window.end()) continue;
          for (const std::uint32_t j : beside->second)
            if (j < i && goes_on(lines[i], lines[j])) sets.unite(i, j);
        }
    std::map<std::uint32_t, std::vector<std::size_t>> by_root;
    for (std::uint32_t i = 0; i < lines.size(); ++i) by_root[sets.find(i)].push_back(i);
    std::vector<std::vector<std::size_t>> chains;
    for (auto& entry : by_root) chains.push_back(std::move(entry.second));
    std::sort(chains.begin(), chains.end());
    return chains;
  }

  StreetStretch stretch_of(const std::vector<WindowLine>& lines, const std::vector<std::size_t>& chain) const {
    LineSums sums;
    for (const std::size_t i : chain) sums.add(lines[i].sums);
    Line line = line_of(sums);
    line.d -= line.nx * middle_x() + line.ny * middle_y();
    double from = INFINITY, to = -INFINITY;
    for (const std::size_t i : chain)
      for (const double end : {lines[i].from, lines[i].to}) {
        const Line& l = lines[i].line;
        const double along = line.along(-l.d * l.nx + end * l.ny, -l.d * l.ny - end * l.nx);
        from = std::min(from, along), to = std::max(to, along);
      }
    const std::vector<Height> profile = profile_of(line, from, to);
    StreetStretch stretch;
    const double centre = (factor_ - 1) / 2.0;  // centre of a coarse pixel, in pixels
    stretch.x = (-line.d * line.nx + from * line.ny) * factor_ + centre;
    stretch.y = (-line.d * line.ny - from * line.nx) * factor_ + centre;
    stretch.dx = line.ny, stretch.dy = -line.nx;
    stretch.length = static_cast<double>(profile.size()) * pixel_;
    cut(profile, stretch);
    return stretch;
  }

  std::vector<Height> profile_of(const Line& line, double from, double to) const {
    std::vector<Height> profile(static_cast<std::size_t>(std::floor(to - from)) + 1, 0);
    for (const auto& entry : windows_) {
      const double half = static_cast<double>(window_) / 2;
      const double x = static_cast<double>(entry.first.second * window_) + half,
                   y = static_cast<double>(entry.first.first * window_) + half;
      if (std::abs(line.distance(x, y)) > 1.5 * half + reach()) continue;
      for (const FacadePixel& p : entry.second) {
        const double along = line.along(p.x, p.y) - from;
        if (std::abs(line.distance(p.x, p.y)) > reach() || along < 0) continue;
        const auto step = static_cast<std::size_t>(along);
        if (step < profile.size()) profile[step] = std::max(profile[step], p.height);
      }
    }
    return running_median(profile, static_cast<std::uint32_t>(std::lround(params_.smoothing / pixel_)));
  }

  // Writes the blocks and gaps of a profile. There are none where the length of facade is too small.
  void cut(const std::vector<Height>& profile, StreetStretch& stretch) const {
    const Height least = scale_.units(params_.least_facade);
    const auto facade = std::count_if(profile.begin(), profile.end(), [&](Height h) { return h >= least; });
    if (static_cast<double>(facade) * pixel_ < params_.least_length) return;
    std::size_t begin = 0;
    const auto add_block = [&](std::size_t end) {
      std::vector<Height> heights(profile.begin() + static_cast<std::ptrdiff_t>(begin),
                                  profile.begin() + static_cast<std::ptrdiff_t>(end));
      if (heights.empty()) return;
      stretch.blocks.push_back({static_cast<double>(begin) * pixel_, static_cast<double>(end) * pixel_,
                                upper_median(heights) * scale_.unit});
    };
    for (const ProfileCut& c : profile_cuts(profile, scale_.units(params_.depth))) {
      const double width = (c.to - c.from + 1) * pixel_;
      if (c.floor >= least || width < params_.least_gap) continue;
      if (c.from < begin) {  // overlapping valleys are merged: a low top between them belongs to both
        begin = std::max<std::size_t>(begin, c.to + 1);
        stretch.gaps.back().to = static_cast<double>(begin) * pixel_;
        continue;
      }
      add_block(c.from);
      stretch.gaps.push_back({c.from * pixel_, (c.to + 1) * pixel_, 0});
      begin = c.to + 1;
    }
    add_block(profile.size());
  }

  const TileLayers& layers_;
  const RasterScale& scale_;
  const CityBlocksParams& params_;
  std::uint32_t factor_;
  double pixel_;         // metres; pixel of the coarse image
  std::int64_t window_;  // coarse pixels
  std::map<WindowKey, std::vector<FacadePixel>> windows_;
};

}  // namespace

std::vector<StreetStretch> find_city_blocks(const TileLayers& layers, const RasterScale& scale,
                                            const CityBlocksParams& params) {
  return BlockFinder(layers, scale, params).find();
}

}  // namespace ilot
