// SPDX-License-Identifier: Apache-2.0
#include "tools/render/plot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tools/render/letters.h"

namespace ilot::render {
namespace {

constexpr int kMargin = 24, kTitle = 40, kText = 2, kLine = kLetterHeight * kText + 6;

struct Frame {
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  void take(FlatPoint p) {
    x0 = std::min(x0, p.x), y0 = std::min(y0, p.y), x1 = std::max(x1, p.x), y1 = std::max(y1, p.y);
  }
};

Frame frame_of(const Picture& picture) {
  Frame f;
  for (const PictureRaster& r : picture.rasters) {
    f.take(r.corner);
    f.take({r.corner.x + r.pixel * r.width, r.corner.y - r.pixel * r.height});
  }
  for (const PictureArea& a : picture.areas)
    for (const auto& ring : a.rings)
      for (const FlatPoint p : ring) f.take(p);
  for (const PicturePoint& p : picture.points) f.take(p.at);
  for (const PictureLine& l : picture.lines)
    for (const FlatPoint p : l.points)
      if (!l.dashed) f.take(p);
  if (f.x0 > f.x1) f = {0, 0, 1, 1};
  return f;
}

// The picture while it is drawn: converts metres to pixels.
class Plot {
 public:
  Plot(const Picture& picture, int size) : picture_(picture), frame_(frame_of(picture)) {
    const double width = std::max(frame_.x1 - frame_.x0, 1e-6), height = std::max(frame_.y1 - frame_.y0, 1e-6);
    scale_ = size / std::max(width, height);
    rows_ = static_cast<int>(std::ceil(height * scale_));
    columns_ = static_cast<int>(std::ceil(width * scale_));
    const int legend = static_cast<int>(picture.legend.size()) * kLine;
    const auto letters = static_cast<int>(longest_text());
    image_.width = std::max(columns_, letters * kLetterWidth * kText) + 2 * kMargin;
    image_.height = kTitle + rows_ + 2 * kMargin + (picture.scale ? kLine + 8 : 0) + legend;
    image_.pixels.assign(static_cast<std::size_t>(image_.width) * static_cast<std::size_t>(image_.height),
                         Rgb{255, 255, 255});
  }

  Image drawn() {
    for (const PictureRaster& r : picture_.rasters) draw(r);
    depth_.assign(picture_.areas.empty() ? 0 : image_.pixels.size(), -INFINITY);
    for (const PictureArea& a : picture_.areas) fill(a);
    for (const PictureArea& a : picture_.areas) draw_edges(a);
    const std::size_t points = picture_.points.size();
    const int radius = points < 1000 ? 3 : points < 4000 ? 2 : points < 400000 ? 1 : 0;
    for (const PicturePoint& p : picture_.points) dot_at(column(p.at.x), row(p.at.y), radius, p.colour);
    for (const PictureLine& l : picture_.lines) draw(l);
    write_words();
    return std::move(image_);
  }

 private:
  std::size_t longest_text() const {
    std::size_t longest = picture_.title.size();
    for (const PictureWord& w : picture_.legend) longest = std::max(longest, w.text.size() + 3);
    return longest;
  }
  double column(double x) const { return kMargin + (x - frame_.x0) * scale_; }
  double row(double y) const { return kTitle + kMargin + (frame_.y1 - y) * scale_; }

  // The drawing does not overlap the text.
  bool inside(int x, int y) const {
    constexpr int kOver = 4;
    return x >= kMargin - kOver && y >= kTitle + kMargin - kOver && x < kMargin + columns_ + kOver &&
           y < kTitle + kMargin + rows_ + kOver;
  }
  std::size_t pixel(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.width) + static_cast<std::size_t>(x);
  }
  void set(int x, int y, Rgb colour) {
    if (inside(x, y)) image_.pixels[pixel(x, y)] = colour;
  }
  void set_word(int x, int y, Rgb colour) {
    if (x >= 0 && y >= 0 && x < image_.width && y < image_.height) image_.pixels[pixel(x, y)] = colour;
  }
  FlatPoint place(double x, double y) const {
    return {(x - kMargin) / scale_ + frame_.x0, frame_.y1 - (y - kTitle - kMargin) / scale_};
  }
  void dot_at(double x, double y, int radius, Rgb colour) {
    const auto cx = static_cast<int>(std::lround(x)), cy = static_cast<int>(std::lround(y));
    for (int dy = -radius; dy <= radius; ++dy)
      for (int dx = -radius; dx <= radius; ++dx)
        if (dx * dx + dy * dy <= radius * radius + 1) set(cx + dx, cy + dy, colour);
  }
  void stroke(FlatPoint a, FlatPoint b, Rgb colour, bool dashed, int radius) {
    const double x0 = column(a.x), y0 = row(a.y), x1 = column(b.x), y1 = row(b.y);
    const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
    for (int i = 0; i <= steps; ++i) {
      if (dashed && i / 8 % 2 == 1) continue;
      const double t = static_cast<double>(i) / steps;
      dot_at(x0 + t * (x1 - x0), y0 + t * (y1 - y0), radius, colour);
    }
  }
  void draw(const PictureLine& line) {
    for (std::size_t i = 1; i < line.points.size(); ++i)
      stroke(line.points[i - 1], line.points[i], line.colour, line.dashed, 1);
  }
  void draw(const PictureRaster& raster);
  void fill(const PictureArea& area);
  void draw_edges(const PictureArea& area);
  void write_words();
  void write_scale(int top);

  const Picture& picture_;
  Frame frame_;
  double scale_ = 1;  // pixels per metre
  int rows_ = 0, columns_ = 0;
  std::vector<double> depth_;  // depth of the nearest area
  Image image_;
};

void Plot::draw(const PictureRaster& raster) {
  const double side = raster.pixel * scale_;
  const double left = column(raster.corner.x), top = row(raster.corner.y);
  const auto last_x = static_cast<int>(std::ceil(left + side * raster.width));
  const auto last_y = static_cast<int>(std::ceil(top + side * raster.height));
  for (int y = static_cast<int>(top); y < last_y; ++y) {
    const double r = std::floor((y + 0.5 - top) / side);
    if (r < 0 || r >= raster.height) continue;
    for (int x = static_cast<int>(left); x < last_x; ++x) {
      const double c = std::floor((x + 0.5 - left) / side);
      if (c < 0 || c >= raster.width) continue;
      const std::size_t i = static_cast<std::size_t>(r) * raster.width + static_cast<std::size_t>(c);
      if (raster.shown[i] != 0) set(x, y, raster.colours[i]);
    }
  }
}

// Fills an area row by row between the crossings of the row with the rings.
void Plot::fill(const PictureArea& area) {
  double top = INFINITY, bottom = -INFINITY;
  for (const auto& ring : area.rings)
    for (const FlatPoint p : ring) top = std::min(top, row(p.y)), bottom = std::max(bottom, row(p.y));
  std::vector<double> crossings;
  for (int y = static_cast<int>(std::floor(top)); y <= bottom; ++y) {
    crossings.clear();
    for (const auto& ring : area.rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        const double ya = row(a.y), yb = row(b.y), at = y + 0.5;
        if ((ya <= at) == (yb <= at)) continue;
        crossings.push_back(column(a.x) + (column(b.x) - column(a.x)) * (at - ya) / (yb - ya));
      }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 1; i < crossings.size(); i += 2)
      for (int x = static_cast<int>(std::ceil(crossings[i - 1] - 0.5)); x + 0.5 <= crossings[i]; ++x) {
        if (!inside(x, y)) continue;
        const double depth = area.depth.at(place(x + 0.5, y + 0.5));
        if (depth < depth_[pixel(x, y)]) continue;
        depth_[pixel(x, y)] = depth;
        set(x, y, area.colour);
      }
  }
}

// Draws those parts of the edges that no nearer area hides.
void Plot::draw_edges(const PictureArea& area) {
  constexpr double kOnTheFace = 0.05;  // metres
  for (const auto& ring : area.rings)
    for (std::size_t n = 0; n < ring.size(); ++n) {
      const FlatPoint a = ring[n], b = ring[(n + 1) % ring.size()];
      const double x0 = column(a.x), y0 = row(a.y), x1 = column(b.x), y1 = row(b.y);
      const int steps = std::max(1, static_cast<int>(std::ceil(std::max(std::abs(x1 - x0), std::abs(y1 - y0)))));
      for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps, px = x0 + t * (x1 - x0), py = y0 + t * (y1 - y0);
        const auto x = static_cast<int>(std::floor(px)), y = static_cast<int>(std::floor(py));
        if (!inside(x, y) || area.depth.at(place(px, py)) + kOnTheFace < depth_[pixel(x, y)]) continue;
        set(x, y, area.edge);
      }
    }
}

// Draws a scale bar of a round number of metres, about a quarter of the picture.
void Plot::write_scale(int top) {
  const double quarter = (image_.width - 2 * kMargin) / scale_ / 4,
               power = std::pow(10, std::floor(std::log10(quarter)));
  const double length = quarter >= 5 * power ? 5 * power : quarter >= 2 * power ? 2 * power : power;
  const auto pixels = static_cast<int>(std::lround(length * scale_));
  for (int x = 0; x <= pixels; ++x)
    for (int y = 0; y < 3; ++y) set_word(kMargin + x, top + 8 + y, kInk);
  for (int y = 0; y < 13; ++y)
    for (int w = 0; w < 2; ++w)
      set_word(kMargin + w, top + 3 + y, kInk), set_word(kMargin + pixels - w, top + 3 + y, kInk);
  char text[32];
  std::snprintf(text, sizeof text, "%g m", length);
  write_text(image_, kMargin + pixels + 12, top + 2, text, kInk, kText);
}

void Plot::write_words() {
  write_text(image_, kMargin, kMargin / 2 + 6, picture_.title, kInk, kText);
  int top = kTitle + rows_ + 2 * kMargin - 8;
  if (picture_.scale) {
    write_scale(top);
    top += kLine + 8;
  }
  for (const PictureWord& word : picture_.legend) {
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 12; ++x) {
        const bool border = x == 0 || y == 0 || x == 11 || y == 11;
        set_word(kMargin + x, top + 2 + y, border ? kGrey : word.colour);
      }
    write_text(image_, kMargin + 24, top + 1, word.text, kInk, kText);
    top += kLine;
  }
}

}  // namespace

Image plot(const Picture& picture, int size) {
  return Plot(picture, size).drawn();
}

}  // namespace ilot::render
