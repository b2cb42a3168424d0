// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_shape.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "kernels/rasters/occupancy.h"

namespace ilot {
namespace {

// Number, sum and sum of squares of pixels along both axes of a candidate.
struct Spread {
  double n = 0, u = 0, v = 0, uu = 0, vv = 0;
  void add(double pu, double pv) { ++n, u += pu, v += pv, uu += pu * pu, vv += pv * pv; }
  double side(double sum, double squares) const {
    return n > 0 ? std::sqrt(12 * std::max(0.0, squares / n - (sum / n) * (sum / n)) + 1) : 0;
  }
  double length() const { return side(u, uu); }  // pixels; 0 without any
  double width() const { return side(v, vv); }
};

// Mean of heights.
struct Mean {
  double n = 0, sum = 0;
  void add(double h) { ++n, sum += h; }
  double value() const { return n > 0 ? sum / n : 0; }
};

// A candidate while its pixels are read. The axes are those of its moments.
struct Form {
  double n = 0, xx = 0, xy = 0, yy = 0;  // around the middle
  double cos = 1, sin = 0, length = 0, width = 0, top = 0;
  int bins = 0;  // up to the top
  double u0 = INFINITY, u1 = -INFINITY, v0 = INFINITY, v1 = -INFINITY;
  Spread all, high, foot;
  double half = 0, waist = 0, head = 0, occupied = 0;  // pixels, and bins of pixels
  double h = 0, hh = 0, hu = 0, hv = 0;
  Mean ends, middle, sides, core;
};

class Shaper {
 public:
  Shaper(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
         std::span<ObjectCandidate> candidates)
      : labels_(labels), images_(images), scale_(scale), candidates_(candidates), forms_(candidates.size()) {}

  void set() {
    each_pixel([&](Form& f, double x, double y, std::size_t) { ++f.n, f.xx += x * x, f.xy += x * y, f.yy += y * y; });
    for (std::size_t i = 0; i < forms_.size(); ++i) set_axes(candidates_[i], forms_[i]);
    each_pixel([&](Form& f, double x, double y, std::size_t pixel) {
      const double u = f.cos * x + f.sin * y, v = f.cos * y - f.sin * x;
      add_height(f, u, v, images_.own.values[pixel] * scale_.unit);
      add_bins(f, u, v, static_cast<Occupancy>(images_.patch.occupancy.values[pixel]));
    });
    for (std::size_t i = 0; i < forms_.size(); ++i) write(forms_[i], candidates_[i]);
  }

 private:
  // Calls take(form, x, y, pixel) with the position from the middle of the candidate, in pixels.
  template <class Take>
  void each_pixel(Take take) {
    const std::size_t w = images_.own.width;
    for (std::size_t i = 0; i < labels_.of.size(); ++i) {
      if (labels_.of[i] == 0) continue;
      const ObjectCandidate& c = candidates_[labels_.of[i] - 1];
      take(forms_[labels_.of[i] - 1], static_cast<double>(images_.patch.x) + static_cast<double>(i % w) - c.middle_x,
           static_cast<double>(images_.patch.y) + static_cast<double>(i / w) - c.middle_y, i);
    }
  }

  void set_axes(const ObjectCandidate& c, Form& f) const {
    const double half = (f.xx - f.yy) / 2, root = std::sqrt(half * half + f.xy * f.xy);
    const double twice = root > 0 ? half / root : 1;  // cosine of twice the heading
    f.cos = std::sqrt(std::max(0.0, (1 + twice) / 2));
    f.sin = std::copysign(std::sqrt(std::max(0.0, (1 - twice) / 2)), f.xy);
    f.length = c.length / scale_.pixel, f.width = c.width / scale_.pixel;
    f.top = c.features[static_cast<std::size_t>(ComponentFeature::max_height)];
    f.bins = std::clamp(static_cast<int>(std::ceil(f.top / scale_.bin())), 1, static_cast<int>(kOccupancyBins));
  }

  static void add_height(Form& f, double u, double v, double h) {
    f.u0 = std::min(f.u0, u), f.u1 = std::max(f.u1, u), f.v0 = std::min(f.v0, v), f.v1 = std::max(f.v1, v);
    f.all.add(u, v);
    f.h += h, f.hh += h * h, f.hu += h * u, f.hv += h * v;
    if (h >= 0.75 * f.top) f.high.add(u, v);
    f.half += h >= 0.5 * f.top;
    (std::abs(u) > f.length / 4 ? f.ends : f.middle).add(h);
    (std::abs(v) > f.width / 4 ? f.sides : f.core).add(h);
  }

  // Thirds of the height: foot, waist, head.
  static void add_bins(Form& f, double u, double v, Occupancy of) {
    const auto below = [](int bins) { return static_cast<Occupancy>((std::uint64_t{1} << bins) - 1); };
    const Occupancy foot = below((f.bins + 2) / 3), waist = below((2 * f.bins + 2) / 3) & ~foot,
                    head = below(f.bins) & ~foot & ~waist;
    if ((of & foot) != 0) f.foot.add(u, v);
    f.waist += (of & waist) != 0;
    f.head += (of & head) != 0;
    f.occupied += std::popcount(of & below(f.bins));
  }

  void write(const Form& f, ObjectCandidate& c) const {
    const double n = std::max(1.0, f.n), pixel = scale_.pixel;
    const auto set = [&](CandidateFeature which, double v) { c.features[static_cast<std::size_t>(which)] = v; };
    const double length = f.n > 0 ? f.u1 - f.u0 + 1 : 0, width = f.n > 0 ? f.v1 - f.v0 + 1 : 0;
    set(CandidateFeature::box_length, pixel * length);
    set(CandidateFeature::box_width, pixel * width);
    set(CandidateFeature::box_fill, f.n > 0 ? f.n / (length * width) : 0);
    set(CandidateFeature::high_length, pixel * f.high.length());
    set(CandidateFeature::high_width, pixel * f.high.width());
    set(CandidateFeature::high_share, f.high.n / n);
    set(CandidateFeature::half_share, f.half / n);
    const auto ratio = [](double a, double b) { return b > 0 ? a / b : 1; };
    set(CandidateFeature::ends_height, f.ends.n > 0 ? ratio(f.ends.value(), f.middle.value()) : 1);
    set(CandidateFeature::sides_height, f.sides.n > 0 ? ratio(f.sides.value(), f.core.value()) : 1);
    const auto slope_part = [](double hu, double uu) { return uu > 0 ? hu * hu / uu : 0; };
    const double left = f.hh - f.h * f.h / n - slope_part(f.hu, f.all.uu) - slope_part(f.hv, f.all.vv);
    set(CandidateFeature::unevenness, std::sqrt(std::max(0.0, left / n)));
    set(CandidateFeature::foot_length, pixel * f.foot.length());
    set(CandidateFeature::foot_width, pixel * f.foot.width());
    set(CandidateFeature::foot_share, f.foot.n / n);
    set(CandidateFeature::waist_share, f.waist / n);
    set(CandidateFeature::head_share, f.head / n);
    set(CandidateFeature::solid_share, f.occupied / (n * f.bins));
  }

  const PixelLabels& labels_;
  const ComponentImages& images_;
  const RasterScale& scale_;
  std::span<ObjectCandidate> candidates_;
  std::vector<Form> forms_;
};

}  // namespace

void set_shapes(const PixelLabels& labels, const ComponentImages& images, const RasterScale& scale,
                std::span<ObjectCandidate> candidates) {
  Shaper(labels, images, scale, candidates).set();
}

}  // namespace ilot
