// SPDX-License-Identifier: Apache-2.0
#include "engine/streets/things.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "kernels/core/portable_math.h"
#include "kernels/rasters/box_minimum.h"
#include "kernels/rasters/flat_zones_tiled.h"
#include "kernels/rasters/gradient.h"

namespace ilot {
namespace {

constexpr std::uint32_t kBytesPerPixel = 60;  // of what a component or a tile is worked on with
constexpr Height kModeMetres100 = 5;          // bins of the mode of heights, centimetres

struct PixelRect {
  std::int64_t x0 = INT64_MAX, y0 = INT64_MAX, x1 = INT64_MIN, y1 = INT64_MIN;  // closed
  void add(std::int64_t x, std::int64_t y) {
    x0 = std::min(x0, x), y0 = std::min(y0, y), x1 = std::max(x1, x), y1 = std::max(y1, y);
  }
  void add(const PixelRect& o) {
    x0 = std::min(x0, o.x0), y0 = std::min(y0, o.y0), x1 = std::max(x1, o.x1), y1 = std::max(y1, o.y1);
  }
  bool within(const PixelRect& o) const { return x0 >= o.x0 && y0 >= o.y0 && x1 <= o.x1 && y1 <= o.y1; }
  std::uint32_t width() const { return static_cast<std::uint32_t>(x1 - x0 + 1); }
  std::uint32_t height() const { return static_cast<std::uint32_t>(y1 - y0 + 1); }
};

// The layers of a rectangle and of one pixel around it.
struct Patch {
  std::int64_t x = 0, y = 0;  // of its first pixel
  Image height, range, accumulation, mask, above, low, components;
};

Patch load_patch(const StreetLayers& layers, const PixelRect& r) {
  const auto read = [&](const char* layer) {
    return layer_window(layers, layer, r.x0 - 1, r.y0 - 1, r.width() + 2, r.height() + 2);
  };
  return {r.x0 - 1,     r.y0 - 1,      read("height"), read("range"),     read("accumulation"),
          read("mask"), read("above"), read("low"),    read("components")};
}

Image cut(const Image& image, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) {
  Image out{width, height, {}};
  out.values.reserve(std::size_t{width} * height);
  for (std::uint32_t v = y; v < y + height; ++v) {
    const auto row = image.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{v} * image.width + x);
    out.values.insert(out.values.end(), row, row + width);
  }
  return out;
}

Patch cut(const Patch& p, const PixelRect& r) {
  const auto x = static_cast<std::uint32_t>(r.x0 - 1 - p.x), y = static_cast<std::uint32_t>(r.y0 - 1 - p.y);
  const auto part = [&](const Image& image) { return cut(image, x, y, r.width() + 2, r.height() + 2); };
  return {r.x0 - 1,     r.y0 - 1,      part(p.height), part(p.range),     part(p.accumulation),
          part(p.mask), part(p.above), part(p.low),    part(p.components)};
}

// Sums over the pixels of one thing.
struct Tally {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  // pixels
  double low = 0, low_x = 0, low_y = 0;                // points, and where they are
  double above = 0, points = 0, slope = 0, edge = 0, contact = 0;
  Height ground = kAboveAll;
};

std::uint32_t gap_reach(const RasterScale& scale, const ThingsParams& params);

class ComponentWork {
 public:
  ComponentWork(const Patch& patch, std::uint32_t component, const RasterScale& scale, const ThingsParams& params)
      : patch_(patch), scale_(scale), params_(params), own_(patch.height) {
    for (std::size_t i = 0; i < own_.size(); ++i)
      if (static_cast<std::uint32_t>(patch.components.values[i]) != component) own_.values[i] = kNoHeight;
    labels_ = separate_artefacts(own_, scale, params.separation);
    slope_ = gradient(own_, Adjacency::eight);
  }

  const PixelLabels& labels() const { return labels_; }

  // The separated ones, then those that join two of them; parts by their place here, from 1.
  std::vector<Thing> things() const {
    std::vector<Thing> out = described(labels_);
    const Joins passes = joins_of();
    const std::vector<Join>& joins = passes.list;
    // What joins what, level by level, so that the things of one level have no pixel in common.
    std::vector<std::uint32_t> of(labels_.of), level(out.size() + joins.size() + 1, 0);
    const auto parts = static_cast<std::uint32_t>(out.size());
    std::uint32_t levels = 0;
    for (std::uint32_t j = 0; j < joins.size(); ++j) {
      level[parts + j + 1] = 1 + std::max(level[joins[j].a], level[joins[j].b]);
      levels = std::max(levels, level[parts + j + 1]);
    }
    out.resize(out.size() + joins.size());
    for (std::uint32_t l = 1; l <= levels; ++l) {
      std::vector<std::uint32_t> becomes(out.size() + 1, 0);
      for (std::uint32_t j = 0; j < joins.size(); ++j)
        if (level[parts + j + 1] == l) becomes[joins[j].a] = becomes[joins[j].b] = parts + j + 1;
      PixelLabels joined{labels_.width, labels_.height, 0, std::vector<std::uint32_t>(of.size(), 0)};
      std::vector<std::uint32_t> number(out.size() + 1, 0), who;
      for (std::size_t i = 0; i < of.size(); ++i) {
        const std::uint32_t next = becomes[of[i]];
        if (next == 0) continue;
        of[i] = next;
        if (number[next] == 0) {
          number[next] = ++joined.count;
          who.push_back(next);
        }
        joined.of[i] = number[next];
      }
      const std::vector<Thing> described_now = described(joined);
      for (std::size_t i = 0; i < who.size(); ++i) out[who[i] - 1] = described_now[i];
    }
    for (std::uint32_t j = 0; j < joins.size(); ++j) {
      out[parts + j].parts[0] = joins[j].a;
      out[parts + j].parts[1] = joins[j].b;
    }
    const auto inner = static_cast<std::size_t>(ThingFeature::inner_pass),
               beside = static_cast<std::size_t>(ThingFeature::outer_pass);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i].features[inner] = 1;
      out[i].features[beside] = std::max(0.0, passes.outer[i + 1]);
      if (i < parts) continue;
      const Join& join = joins[i - parts];
      out[i].features[inner] =
          std::min({std::max(0.0, join.pass), out[join.a - 1].features[inner], out[join.b - 1].features[inner]});
    }
    return out;
  }

 private:
  struct Join {
    std::uint32_t a = 0, b = 0;
    double pass = 1;  // over the lower top
  };
  struct Joins {
    std::vector<Join> list;
    std::vector<double> outer;  // of each part and each join, from 1: the highest pass to another over the lower top
  };

  struct Side {
    Height top = kNoHeight;
    double pixels = 0;
    std::map<std::uint32_t, Height> passes;  // to those beside it; below 0: the gap in pixels, turned over
  };

  // Parts with ground between them, seen from every pixel on an edge.
  void add_gaps(std::map<std::uint32_t, Side>& sides) const {
    const auto reach = static_cast<std::int64_t>(2 * gap_reach(scale_, params_));
    const auto w = std::int64_t{labels_.width}, h = std::int64_t{labels_.height};
    if (labels_.count < 2) return;
    for (std::int64_t y = 1; y + 1 < h; ++y)
      for (std::int64_t x = 1; x + 1 < w; ++x) {
        const auto i = static_cast<std::size_t>(y * w + x);
        const std::uint32_t a = labels_.of[i];
        const auto row = static_cast<std::size_t>(w);
        if (a == 0 ||
            (labels_.of[i - 1] != 0 && labels_.of[i + 1] != 0 && labels_.of[i - row] != 0 && labels_.of[i + row] != 0))
          continue;
        for (std::int64_t v = std::max<std::int64_t>(0, y - reach - 1); v <= std::min(h - 1, y + reach + 1); ++v)
          for (std::int64_t u = std::max<std::int64_t>(0, x - reach - 1); u <= std::min(w - 1, x + reach + 1); ++u) {
            const std::uint32_t b = labels_.of[static_cast<std::size_t>(v * w + u)];
            if (b == 0 || b == a) continue;
            const auto gap = static_cast<Height>(-std::max(std::abs(u - x), std::abs(v - y)));
            for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
              Height& known = sides[from].passes.try_emplace(to, gap).first->second;
              known = std::max(known, gap);
            }
          }
      }
  }

  // Pairs of parts, or of what they were joined to, in the order in which they are joined.
  Joins joins_of() const {
    std::map<std::uint32_t, Side> sides;
    const std::size_t w = labels_.width;
    for (std::size_t i = 0; i < labels_.of.size(); ++i) {
      const std::uint32_t a = labels_.of[i];
      if (a == 0) continue;
      Side& side = sides[a];
      side.top = std::max(side.top, own_.values[i]);
      ++side.pixels;
      for (const std::size_t q : {i + 1, i + w - 1, i + w, i + w + 1}) {
        const std::uint32_t b = labels_.of[q];
        if (b == 0 || b == a) continue;
        const Height pass = std::min(own_.values[i], own_.values[q]);
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
          Height& known = sides[from].passes.try_emplace(to, pass).first->second;
          known = std::max(known, pass);
        }
      }
    }
    add_gaps(sides);
    const double largest = params_.largest / (scale_.pixel * scale_.pixel);
    const auto outer = [&](const Side& side) {
      double highest = 0;
      for (const auto& [b, pass] : side.passes)
        highest = std::max(highest, static_cast<double>(pass) / std::min(side.top, sides.at(b).top));
      return highest;
    };
    Joins joins{{}, std::vector<double>(std::size_t{labels_.count} + 1, 0)};
    for (const auto& [a, side] : sides) joins.outer[a] = outer(side);
    std::uint32_t next = labels_.count;
    for (;;) {
      Join best;
      double highest = -1;
      for (const auto& [a, side] : sides)
        for (const auto& [b, pass] : side.passes) {
          if (b < a || side.pixels + sides.at(b).pixels > largest) continue;
          const double ratio = static_cast<double>(pass) / std::min(side.top, sides.at(b).top);
          if (ratio > highest) highest = ratio, best = {a, b, ratio};
        }
      if (best.a == 0) break;
      joins.list.push_back(best);
      Side whole = sides.at(best.a);
      const Side& other = sides.at(best.b);
      whole.top = std::max(whole.top, other.top);
      whole.pixels += other.pixels;
      for (const auto& [c, pass] : other.passes) {
        Height& known = whole.passes.try_emplace(c, pass).first->second;
        known = std::max(known, pass);
      }
      whole.passes.erase(best.a), whole.passes.erase(best.b);
      sides.erase(best.a), sides.erase(best.b);
      ++next;
      for (const auto& [c, pass] : whole.passes) {
        Side& beside = sides.at(c);
        beside.passes.erase(best.a), beside.passes.erase(best.b);
        beside.passes[next] = pass;
      }
      joins.outer.push_back(outer(whole));
      sides[next] = std::move(whole);
    }
    return joins;
  }

  std::vector<Thing> described(const PixelLabels& labels) const {
    const std::vector<ComponentFeatures> features = document_features(labels);
    const std::vector<Tally> tallies = tally(labels);
    std::vector<Thing> out;
    for (std::uint32_t i = 0; i < labels.count; ++i) out.push_back(thing(features[i], tallies[i]));
    return out;
  }

  std::vector<ComponentFeatures> document_features(const PixelLabels& labels) const {
    PixelLabels seen = labels;
    std::vector<std::uint32_t> accumulation(seen.of.size(), 0);
    std::vector<std::uint8_t> any(std::size_t{seen.count} + 1, 0);
    for (std::size_t i = 0; i < seen.of.size(); ++i) {
      accumulation[i] = static_cast<std::uint32_t>(std::max(0, patch_.accumulation.values[i]));
      any[seen.of[i]] |= accumulation[i] > 0;
    }
    for (std::size_t i = 0; i < seen.of.size(); ++i)
      if (accumulation[i] == 0 && any[seen.of[i]] != 0) seen.of[i] = 0;
    const Height bin = std::max(1, scale_.units(0.01 * kModeMetres100));
    auto features = component_features(seen, own_, accumulation, {scale_.unit, scale_.pixel, bin});
    for (ComponentFeatures& f : features)
      for (auto a = static_cast<std::size_t>(ComponentFeature::mean_accumulation);
           a <= static_cast<std::size_t>(ComponentFeature::mode_accumulation); ++a)
        f[a] /= params_.mean_accumulation;
    return features;
  }

  std::vector<Tally> tally(const PixelLabels& labels) const {
    std::vector<Tally> tallies(labels.count);
    const std::size_t w = own_.width;
    for (std::size_t i = 0; i < labels.of.size(); ++i) {
      if (labels.of[i] == 0) continue;
      Tally& t = tallies[labels.of[i] - 1];
      const auto x = static_cast<double>(i % w), y = static_cast<double>(i / w);
      ++t.n;
      t.x += x, t.y += y, t.xx += x * x, t.xy += x * y, t.yy += y * y;
      const double low = std::max(0, patch_.low.values[i]);
      t.low += low, t.low_x += low * x, t.low_y += low * y;
      t.above += std::max(0, patch_.above.values[i]);
      t.points += std::max(0, patch_.accumulation.values[i]);
      t.slope += slope_.values[i];
      if (patch_.range.values[i] != kNoHeight)
        t.ground = std::min(t.ground, patch_.range.values[i] - patch_.height.values[i]);
      bool edge = false, contact = false;
      for (const std::size_t q : {i - w, i - 1, i + 1, i + w}) {
        edge |= labels.of[q] != labels.of[i];
        contact |= patch_.mask.values[q] != 1;
      }
      t.edge += edge;
      t.contact += contact;
    }
    return tallies;
  }

  Thing thing(const ComponentFeatures& document, const Tally& t) const {
    Thing out;
    const double n = std::max(1.0, t.n), x = t.x / n, y = t.y / n;
    const double xx = t.xx / n - x * x, xy = t.xy / n - x * y, yy = t.yy / n - y * y;
    const double half = (xx + yy) / 2, root = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
    const auto side = [&](double variance) {
      return scale_.pixel * std::sqrt(12 * std::max(0.0, variance) + 1);  // a single pixel is one wide
    };
    out.length = side(half + root);
    out.width = side(half - root);
    const double twice = direction_degrees((xx - yy) / 2, xy);
    out.heading_deg = twice / 2;
    out.x = static_cast<double>(patch_.x) + (t.low > 0 ? t.low_x / t.low : x);
    out.y = static_cast<double>(patch_.y) + (t.low > 0 ? t.low_y / t.low : y);
    out.middle_x = static_cast<double>(patch_.x) + x;
    out.middle_y = static_cast<double>(patch_.y) + y;
    out.ground = t.ground == kAboveAll ? 0 : t.ground;
    out.points = static_cast<std::uint64_t>(t.above);
    out.pixels = static_cast<std::uint32_t>(t.n);
    std::copy(document.begin(), document.end(), out.features.begin());
    const auto set = [&](ThingFeature f, double v) { out.features[static_cast<std::size_t>(f)] = v; };
    out.features[static_cast<std::size_t>(ComponentFeature::area)] = t.n * scale_.pixel * scale_.pixel;
    set(ThingFeature::low_share, t.above > 0 ? t.low / t.above : 0);
    set(ThingFeature::ground_share, t.points > 0 ? 1 - t.above / t.points : 0);
    set(ThingFeature::roughness, t.slope / n * scale_.unit);
    set(ThingFeature::length, out.length);
    set(ThingFeature::width, out.width);
    set(ThingFeature::facade_contact, t.edge > 0 ? t.contact / t.edge : 0);
    return out;
  }

  const Patch& patch_;
  const RasterScale& scale_;
  const ThingsParams& params_;
  Image own_;
  PixelLabels labels_;
  Image slope_;
};

// Half of the gap over which parts may be one thing, pixels.
std::uint32_t gap_reach(const RasterScale& scale, const ThingsParams& params) {
  return scale.pixels(params.nearest_apart) / 2;
}

PixelRect rect_of(const TileFrame& f) {
  return {f.x, f.y, std::int64_t{f.x} + f.width - 1, std::int64_t{f.y} + f.height - 1};
}

struct Components {
  std::vector<std::uint64_t> pixels;
  std::vector<PixelRect> boxes;
};

// Components of what stands there, joined over gaps of up to twice `reach` pixels.
Components find_components(const StreetLayers& layers, std::uint32_t reach) {
  Components found;
  std::mutex mutex;
  struct Seen {
    std::uint32_t component;
    std::uint64_t pixels;
    PixelRect box;
  };
  std::vector<Seen> seen;
  const auto standing = [&](std::size_t tile) {
    Image image = layer_around(layers, "height", tile, reach);
    for (Height& v : image.values) v = v == kNoHeight ? kNoHeight : 0;
    return without_halo(box_minimum(image, reach), reach);
  };
  const auto write = [&](std::size_t tile, const PixelLabels& labels) {
    const TileFrame frame = tile_frame(layers.grid, tile);
    const Image height = layer_tile(layers, "height", tile);
    std::vector<Seen> runs;  // one a run of a row
    Image image{labels.width, labels.height, std::vector<Height>(labels.of.size(), 0)};
    for (std::uint32_t y = 0; y < labels.height; ++y) {
      for (std::uint32_t x = 0; x < labels.width; ++x) {
        const std::size_t i = std::size_t{y} * labels.width + x;
        if (height.values[i] == kNoHeight) continue;
        image.values[i] = static_cast<Height>(labels.of[i]);
        if (x == 0 || image.values[i - 1] != image.values[i]) runs.push_back({labels.of[i], 0, {}});
        ++runs.back().pixels;
        runs.back().box.add(std::int64_t{frame.x} + x, std::int64_t{frame.y} + y);
      }
    }
    layers.write("components", tile, image);
    std::stable_sort(runs.begin(), runs.end(), [](const Seen& a, const Seen& b) { return a.component < b.component; });
    std::vector<Seen> here;
    for (const Seen& run : runs) {
      if (here.empty() || here.back().component != run.component) here.push_back({run.component, 0, {}});
      here.back().pixels += run.pixels;
      here.back().box.add(run.box);
    }
    const std::lock_guard lock(mutex);
    seen.insert(seen.end(), here.begin(), here.end());
  };
  const ZoneSizes sizes = flat_zones_tiled(layers.grid, 0, Adjacency::eight, standing, write);
  found.pixels.resize(sizes.pixels.size(), 0);
  found.boxes.resize(sizes.pixels.size());
  for (const Seen& s : seen) {
    found.pixels[s.component] += s.pixels;
    found.boxes[s.component].add(s.box);
  }
  return found;
}

// The labels of a component that several tiles share: a pixel of the whole, and its label in the component.
struct SharedLabels {
  std::uint32_t component = 0;
  PixelRect box;
  PixelLabels labels;  // of the box and a pixel around it
};

class ThingFinder {
 public:
  ThingFinder(const StreetLayers& layers, const RasterScale& scale, const ThingsParams& params)
      : layers_(layers),
        scale_(scale),
        params_(params),
        components_(find_components(layers, gap_reach(scale, params))),
        things_(components_.pixels.size()) {}

  std::vector<Thing> find() {
    const std::vector<std::vector<std::uint32_t>> of_tile = share_out();
    for_each_tile(layers_.grid, [&](std::size_t tile) { work_on_tile(tile, of_tile[tile]); }, {kBytesPerPixel, 0});
    shared_.resize(spanning_.size());
    std::vector<std::uint64_t> bytes;
    for (const std::uint32_t c : spanning_)
      bytes.push_back(std::uint64_t{components_.boxes[c].width()} * components_.boxes[c].height() * kBytesPerPixel);
    run_tasks(layers_.grid, bytes, [&](std::size_t i) { work_on_spanning(i); });
    std::vector<std::uint32_t> first(things_.size() + 1, 0);
    for (std::size_t c = 0; c < things_.size(); ++c) first[c + 1] = first[c] + separated(things_[c]);
    for_each_tile(layers_.grid, [&](std::size_t tile) { number_tile(tile, first); });
    layers_.drop("components");
    std::vector<Thing> all;
    for (const auto& list : things_) all.insert(all.end(), list.begin(), list.begin() + separated(list));
    for (std::size_t c = 0; c < things_.size(); ++c) add_joined(things_[c], first[c], all);
    return all;
  }

 private:
  static std::uint32_t separated(const std::vector<Thing>& things) {
    return static_cast<std::uint32_t>(
        std::count_if(things.begin(), things.end(), [](const Thing& t) { return t.parts[0] == 0; }));
  }

  // The joined things of a component, their parts by number in the whole.
  static void add_joined(const std::vector<Thing>& things, std::uint32_t first, std::vector<Thing>& all) {
    const std::uint32_t parts = separated(things), joined = static_cast<std::uint32_t>(all.size());
    for (std::size_t i = parts; i < things.size(); ++i) {
      all.push_back(things[i]);
      for (std::uint32_t& part : all.back().parts) part += part <= parts ? first : joined - parts;
    }
  }

  bool large_enough(std::uint32_t component) const {
    return components_.pixels[component] >= std::max(1u, scale_.area(params_.separation.least_area));
  }

  // Components that lie in one tile, by tile; the others are set aside.
  std::vector<std::vector<std::uint32_t>> share_out() {
    std::vector<std::vector<std::uint32_t>> of_tile(layers_.grid.count());
    for (std::uint32_t c = 1; c < components_.pixels.size(); ++c) {
      if (!large_enough(c)) continue;
      const PixelRect& box = components_.boxes[c];
      const std::uint32_t side = layers_.grid.side;
      const std::int64_t column = box.x0 / side, row = box.y0 / side;
      if (box.x1 / side == column && box.y1 / side == row)
        of_tile[static_cast<std::size_t>(row * layers_.grid.columns() + column)].push_back(c);
      else
        spanning_.push_back(c);
    }
    return of_tile;
  }

  void work_on_tile(std::size_t tile, const std::vector<std::uint32_t>& components) {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    Image local = filled_image(frame.width, frame.height, 0);
    if (!components.empty()) {
      const Patch patch = load_patch(layers_, rect_of(frame));
      for (const std::uint32_t c : components) {
        const PixelRect& box = components_.boxes[c];
        const Patch part = cut(patch, box);
        const ComponentWork work(part, c, scale_, params_);
        things_[c] = work.things();
        put(work.labels(), box, frame, local);
      }
    }
    layers_.write("things", tile, local);
  }

  void work_on_spanning(std::size_t i) {
    const std::uint32_t c = spanning_[i];
    const Patch patch = load_patch(layers_, components_.boxes[c]);
    const ComponentWork work(patch, c, scale_, params_);
    things_[c] = work.things();
    shared_[i] = {c, components_.boxes[c], work.labels()};
  }

  // Labels of a box with a pixel around it, where they lie in a tile.
  static void put(const PixelLabels& labels, const PixelRect& box, const TileFrame& frame, Image& tile) {
    for (std::int64_t y = std::max<std::int64_t>(box.y0, frame.y); y <= box.y1 && y < frame.y + frame.height; ++y) {
      for (std::int64_t x = std::max<std::int64_t>(box.x0, frame.x); x <= box.x1 && x < frame.x + frame.width; ++x) {
        const std::uint32_t label =
            labels.of[static_cast<std::size_t>((y - box.y0 + 1) * labels.width + x - box.x0 + 1)];
        if (label != 0)
          tile.values[static_cast<std::size_t>((y - frame.y) * frame.width + x - frame.x)] = static_cast<Height>(label);
      }
    }
  }

  void number_tile(std::size_t tile, const std::vector<std::uint32_t>& first) const {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    Image local = layer_tile(layers_, "things", tile);
    const PixelRect own = rect_of(frame);
    for (const SharedLabels& s : shared_)
      if (s.box.x0 <= own.x1 && s.box.x1 >= own.x0 && s.box.y0 <= own.y1 && s.box.y1 >= own.y0)
        put(s.labels, s.box, frame, local);
    const Image components = layer_tile(layers_, "components", tile);
    for (std::size_t i = 0; i < local.size(); ++i)
      if (local.values[i] != 0)
        local.values[i] += static_cast<Height>(first[static_cast<std::uint32_t>(components.values[i])]);
    layers_.write("things", tile, local);
  }

  const StreetLayers& layers_;
  const RasterScale& scale_;
  const ThingsParams& params_;
  Components components_;
  std::vector<std::vector<Thing>> things_;  // by component
  std::vector<std::uint32_t> spanning_;
  std::vector<SharedLabels> shared_;
};

}  // namespace

const char* thing_feature_name(std::size_t feature) {
  static constexpr const char* kOwn[] = {"low share", "ground share", "roughness",  "length",
                                         "width",     "inner pass",   "outer pass", "facade contact"};
  if (feature < kComponentFeatures) return feature_name(static_cast<ComponentFeature>(feature));
  return kOwn[feature - kComponentFeatures];
}

std::vector<Thing> find_things(const StreetLayers& layers, const RasterScale& scale, const ThingsParams& params) {
  return ThingFinder(layers, scale, params).find();
}

}  // namespace ilot
