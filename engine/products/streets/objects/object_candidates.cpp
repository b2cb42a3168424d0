// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/object_candidates.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>
#include <utility>

#include "engine/products/streets/objects/component_candidates.h"
#include "kernels/morphology/flat_zones_tiled.h"
#include "kernels/rasters/box_minimum.h"

namespace ilot {
namespace {

constexpr std::uint32_t kBytesPerPixel = 84;  // memory to process a component
constexpr std::uint32_t kBytesOfPatch = 40;  // per pixel of a tile: eight layers, numbers, and the halo around the tile
// Pixels in the largest box of a component that is processed as a whole: as many as a tile has (655 m2 at 5 cm). The
// largest component in our test clouds has 57,000.
constexpr std::uint64_t kLargestBox = 1u << 18;
constexpr std::uint32_t kLongestBox = 1u << 14;  // packed images are no wider than 2^15

PixelRect rect_of(const TileFrame& f) {
  return {f.x, f.y, std::int64_t{f.x} + f.width - 1, std::int64_t{f.y} + f.height - 1};
}

// Writes the layer "standing": the heights of pixels that have a point, or that are near one.
void find_standing(const TileLayers& layers, std::uint32_t reach) {
  for_each_tile(layers.grid,
                [&](std::size_t tile) {
                  Image seen = layer_around(layers, "accumulation", tile, reach),
                        height = layer_tile(layers, "height", tile);
                  for (Height& v : seen.values) v = v > 0 ? 0 : kNoHeight;
                  seen = without_halo(box_minimum(seen, reach), reach);
                  for (std::size_t i = 0; i < height.size(); ++i)
                    if (seen.values[i] == kNoHeight) height.values[i] = kNoHeight;
                  layers.write("standing", tile, height);
                },
                {24, reach});
}

// The part of a component that one tile contains.
struct Seen {
  std::uint32_t component = 0;
  std::size_t tile = 0;
  std::uint64_t pixels = 0;
  PixelRect box;
};

struct Components {
  std::vector<std::uint64_t> pixels;
  std::vector<PixelRect> boxes;
};

std::uint64_t area_of(const PixelRect& box) {
  return std::uint64_t{box.width()} * box.height();
}

// Cuts components whose boxes are too large to be processed as a whole. They are cut along the borders of tiles: the
// part in each tile becomes a component of its own, numbered after all others.
void cut_largest(const TileLayers& layers, std::vector<Seen> seen, Components& found) {
  std::erase_if(seen, [&](const Seen& s) {
    const PixelRect& box = found.boxes[s.component];
    return area_of(box) <= kLargestBox && std::max(box.width(), box.height()) <= kLongestBox;
  });
  std::sort(seen.begin(), seen.end(),
            [](const Seen& a, const Seen& b) { return std::tie(a.component, a.tile) < std::tie(b.component, b.tile); });
  std::map<std::size_t, std::map<std::uint32_t, std::uint32_t>> new_numbers;  // by tile and component
  for (const Seen& s : seen) {
    found.pixels[s.component] = 0;
    new_numbers[s.tile][s.component] = static_cast<std::uint32_t>(found.pixels.size());
    found.pixels.push_back(s.pixels);
    found.boxes.push_back(s.box);
  }
  for (const auto& [tile, numbers] : new_numbers) {
    Image image = layer_tile(layers, "components", tile);
    for (Height& v : image.values)
      if (const auto number = numbers.find(static_cast<std::uint32_t>(v)); number != numbers.end())
        v = static_cast<Height>(number->second);
    layers.write("components", tile, image);
  }
}

// Finds the connected components of what stands on the ground, joined over gaps of up to twice `reach` pixels.
Components find_components(const TileLayers& layers, std::uint32_t reach) {
  Components found;
  std::mutex mutex;
  std::vector<Seen> seen;
  const auto standing = [&](std::size_t tile) {
    Image image = layer_around(layers, "standing", tile, reach);
    for (Height& v : image.values) v = v == kNoHeight ? kNoHeight : 0;
    return without_halo(box_minimum(image, reach), reach);
  };
  const auto write = [&](std::size_t tile, const PixelLabels& labels) {
    const TileFrame frame = tile_frame(layers.grid, tile);
    const Image height = layer_tile(layers, "standing", tile);
    std::vector<Seen> runs;  // one entry per run of a row
    Image image{labels.width, labels.height, std::vector<Height>(labels.of.size(), 0)};
    for (std::uint32_t y = 0; y < labels.height; ++y) {
      for (std::uint32_t x = 0; x < labels.width; ++x) {
        const std::size_t i = std::size_t{y} * labels.width + x;
        if (height.values[i] == kNoHeight) continue;
        image.values[i] = static_cast<Height>(labels.of[i]);
        if (x == 0 || image.values[i - 1] != image.values[i]) runs.push_back({labels.of[i], tile, 0, {}});
        ++runs.back().pixels;
        runs.back().box.add(std::int64_t{frame.x} + x, std::int64_t{frame.y} + y);
      }
    }
    layers.write("components", tile, image);
    std::stable_sort(runs.begin(), runs.end(), [](const Seen& a, const Seen& b) { return a.component < b.component; });
    std::vector<Seen> here;
    for (const Seen& run : runs) {
      if (here.empty() || here.back().component != run.component) here.push_back({run.component, tile, 0, {}});
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
  cut_largest(layers, std::move(seen), found);
  return found;
}

class CandidateFinder {
 public:
  CandidateFinder(const TileLayers& layers, const RasterScale& scale, const ObjectCandidateParams& params)
      : layers_(layers),
        scale_(scale),
        params_(params),
        components_(find_components(layers, gap_reach(scale, params))),
        candidates_(components_.pixels.size()) {}

  std::vector<ObjectCandidate> find() {
    const std::vector<std::vector<std::uint32_t>> of_tile = share_out();
    run_tasks(layers_.grid, bytes_of_tiles(of_tile), [&](std::size_t tile) { work_on_tile(tile, of_tile[tile]); });
    std::vector<std::uint64_t> bytes;
    for (const std::uint32_t c : spanning_)
      bytes.push_back(std::uint64_t{components_.boxes[c].width()} * components_.boxes[c].height() * kBytesPerPixel);
    run_tasks(layers_.grid, bytes, [&](std::size_t i) { work_on_spanning(i); });
    std::vector<std::uint32_t> first(candidates_.size() + 1, 0);
    for (std::size_t c = 0; c < candidates_.size(); ++c) first[c + 1] = first[c] + separated(candidates_[c]);
    const std::vector<std::vector<std::uint32_t>> shared_by_tile = shared_of_tiles();
    for_each_tile(layers_.grid, [&](std::size_t tile) { number_tile(tile, shared_by_tile[tile], first); });
    for (const char* layer : {"components", "shared"}) layers_.drop(layer);
    std::vector<ObjectCandidate> all;
    std::size_t count = 0;
    for (const auto& list : candidates_) count += list.size();
    need_bytes(layers_.grid, count * sizeof(ObjectCandidate));
    all.reserve(count);
    for (const auto& list : candidates_) all.insert(all.end(), list.begin(), list.begin() + separated(list));
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      add_joined(candidates_[c], first[c], all);
      std::vector<ObjectCandidate>().swap(candidates_[c]);
    }
    return all;
  }

 private:
  static std::uint32_t separated(const std::vector<ObjectCandidate>& candidates) {
    return static_cast<std::uint32_t>(
        std::count_if(candidates.begin(), candidates.end(), [](const ObjectCandidate& t) { return t.parts[0] == 0; }));
  }

  // Appends the joins of a component. Their parts become numbers in the list of all candidates.
  static void add_joined(const std::vector<ObjectCandidate>& candidates, std::uint32_t first,
                         std::vector<ObjectCandidate>& all) {
    const std::uint32_t parts = separated(candidates), joined = static_cast<std::uint32_t>(all.size());
    for (std::size_t i = parts; i < candidates.size(); ++i) {
      all.push_back(candidates[i]);
      for (std::uint32_t& part : all.back().parts) part += part <= parts ? first : joined - parts;
    }
  }

  bool large_enough(std::uint32_t component) const {
    return components_.pixels[component] >= std::max(1u, scale_.area(params_.separation.least_area));
  }

  // Returns by tile the components that lie in one tile. The others are recorded in spanning_.
  std::vector<std::vector<std::uint32_t>> share_out() {
    std::vector<std::vector<std::uint32_t>> of_tile(layers_.grid.count());
    for (std::uint32_t c = 1; c < components_.pixels.size(); ++c) {
      if (!large_enough(c)) continue;
      const PixelRect& box = components_.boxes[c];
      const std::uint32_t side = layers_.grid.side;
      const std::int64_t column = box.x0 / side, row = box.y0 / side;
      if (box.x1 / side == column && box.y1 / side == row)
        of_tile[layers_.grid.tile_at(row, column)].push_back(c);
      else
        spanning_.push_back(c);
    }
    return of_tile;
  }

  // The memory for each tile: its layers, its results, and the largest component that is processed.
  std::vector<std::uint64_t> bytes_of_tiles(const std::vector<std::vector<std::uint32_t>>& of_tile) const {
    const std::uint64_t side = layers_.grid.side;
    std::vector<std::uint64_t> bytes;
    for (const auto& components : of_tile) {
      std::uint64_t largest = 0;
      for (const std::uint32_t c : components) largest = std::max(largest, area_of(components_.boxes[c]));
      bytes.push_back(side * side * kBytesOfPatch + largest * kBytesPerPixel);
    }
    return bytes;
  }

  void work_on_tile(std::size_t tile, const std::vector<std::uint32_t>& components) {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    Image local = filled_image(frame.width, frame.height, 0);
    if (!components.empty()) {
      const Patch patch = load_patch(layers_, rect_of(frame));
      for (const std::uint32_t c : components) {
        const PixelRect& box = components_.boxes[c];
        const Patch part = cut(patch, box);
        ComponentCandidates found = candidates_of_component(part, c, scale_, params_);
        candidates_[c] = std::move(found.candidates);
        put(found.labels, box, frame, local);
      }
    }
    layers_.write("candidates", tile, local);
  }

  void work_on_spanning(std::size_t i) {
    const std::uint32_t c = spanning_[i];
    const Patch patch = load_patch(layers_, components_.boxes[c]);
    ComponentCandidates found = candidates_of_component(patch, c, scale_, params_);
    candidates_[c] = std::move(found.candidates);
    const PixelLabels& labels = found.labels;
    layers_.write("shared", i, {labels.width, labels.height, {labels.of.begin(), labels.of.end()}});
  }

  // Writes the labels of a box, which has one pixel around it, to the pixels that lie in a tile.
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

  // Writes the labels of a component that spans more than one tile, where its box lies in this tile.
  void put_shared(std::uint32_t s, const TileFrame& frame, Image& tile) const {
    const PixelRect &box = components_.boxes[spanning_[s]], own = rect_of(frame);
    const PixelRect part{std::max(box.x0, own.x0), std::max(box.y0, own.y0), std::min(box.x1, own.x1),
                         std::min(box.y1, own.y1)};
    std::vector<Height> labels(area_of(part));
    layers_.read("shared", s,
                 {static_cast<std::uint32_t>(part.x0 - box.x0 + 1), static_cast<std::uint32_t>(part.y0 - box.y0 + 1),
                  part.width(), part.height()},
                 {labels.data(), part.width()});
    std::size_t i = 0;
    for (std::int64_t y = part.y0; y <= part.y1; ++y)
      for (std::int64_t x = part.x0; x <= part.x1; ++x, ++i)
        if (labels[i] != 0) tile.values[static_cast<std::size_t>((y - own.y0) * frame.width + x - own.x0)] = labels[i];
  }

  // For each tile, the components that span more than one tile and reach into it, as indices into spanning_.
  std::vector<std::vector<std::uint32_t>> shared_of_tiles() const {
    std::vector<std::vector<std::uint32_t>> of_tile(layers_.grid.count());
    const std::uint32_t side = layers_.grid.side;
    for (std::uint32_t s = 0; s < spanning_.size(); ++s) {
      const PixelRect& box = components_.boxes[spanning_[s]];
      for (std::int64_t row = box.y0 / side; row <= box.y1 / side; ++row)
        for (std::int64_t column = box.x0 / side; column <= box.x1 / side; ++column)
          if (const std::size_t tile = layers_.grid.tile_at(row, column); tile != kNoTile) of_tile[tile].push_back(s);
    }
    return of_tile;
  }

  void number_tile(std::size_t tile, const std::vector<std::uint32_t>& shared,
                   const std::vector<std::uint32_t>& first) const {
    const TileFrame frame = tile_frame(layers_.grid, tile);
    Image local = layer_tile(layers_, "candidates", tile);
    for (const std::uint32_t s : shared) put_shared(s, frame, local);
    const Image components = layer_tile(layers_, "components", tile);
    for (std::size_t i = 0; i < local.size(); ++i)
      if (local.values[i] != 0)
        local.values[i] += static_cast<Height>(first[static_cast<std::uint32_t>(components.values[i])]);
    layers_.write("candidates", tile, local);
  }

  const TileLayers& layers_;
  const RasterScale& scale_;
  const ObjectCandidateParams& params_;
  Components components_;
  std::vector<std::vector<ObjectCandidate>> candidates_;  // by component
  std::vector<std::uint32_t> spanning_;
};

}  // namespace

const char* candidate_feature_name(std::size_t feature) {
  static constexpr const char* kOwn[] = {
      "low share",     "ground share",  "roughness",     "length",         "width",         "inner pass",
      "outer pass",    "fill",          "lesser share",  "top step",       "mean step",     "joined share",
      "rise",          "joined fill",   "joined length", "upright share",  "evenness",      "free run",
      "touch share",   "joint share",   "box length",    "box width",      "box fill",      "high length",
      "high width",    "high share",    "half share",    "ends height",    "sides height",  "unevenness",
      "foot length",   "foot width",    "foot share",    "waist share",    "head share",    "solid share",
      "wall distance", "wall mean",     "crown share",   "overhang share", "edge ground",   "edge standing",
      "edge building", "points",        "pixel",         "root share",     "root length",   "neighbour bins",
      "linear",        "planar",        "upright axis",  "level normal",   "lowest bin",    "thickness",
      "band 1 share",  "band 2 share",  "band 3 share",  "band 4 share",   "band 5 share",  "band 6 share",
      "band 7 share",  "band 1 length", "band 2 length", "band 3 length",  "band 4 length", "band 5 length",
      "band 6 length", "band 7 length", "band 1 width",  "band 2 width",   "band 3 width",  "band 4 width",
      "band 5 width",  "band 6 width",  "band 7 width",  "band 1 offset",  "band 2 offset", "band 3 offset",
      "band 4 offset", "band 5 offset", "band 6 offset", "band 7 offset",  "level share",   "step share"};
  if (feature < kComponentFeatures) return feature_name(static_cast<ComponentFeature>(feature));
  return kOwn[feature - kComponentFeatures];
}

std::vector<ObjectCandidate> find_object_candidates(const TileLayers& layers, const RasterScale& scale,
                                                    const ObjectCandidateParams& params) {
  find_standing(layers, scale.pixels(params.seen_within));
  std::vector<ObjectCandidate> candidates = CandidateFinder(layers, scale, params).find();
  for (const char* layer : {"standing", "beside"}) layers.drop(layer);
  return candidates;
}

}  // namespace ilot
