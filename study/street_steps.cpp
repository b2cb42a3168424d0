// SPDX-License-Identifier: Apache-2.0
// Draws pictures of each step of the segmentation of a street [Hernandez and Marcotegui 2008, 2.2 to 5.3], for one
// block. They show what figures 2 to 16 of the document show. North is up. A pixel of the images is two pixels of the
// pictures. Usage: study_street_steps CLOUD OUT [BLOCK]. BLOCK is the number of the block along the first stretch, from
// 1. With 0, all of a cloud is drawn, such as a tile from the air, if it is no larger than 3,000 pixels.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "engine/model/object_colours.h"
#include "engine/pass/index.h"
#include "engine/products/streets/ground/artefacts.h"
#include "engine/products/streets/make_streets.h"
#include "engine/products/streets/objects/object_selection.h"
#include "engine/products/streets/street_training.h"
#include "kernels/core/parallel.h"
#include "kernels/morphology/area_opening.h"
#include "kernels/morphology/fill.h"
#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/morphology/region_links.h"
#include "kernels/rasters/gradient.h"
#include "tests/oracles/whole_fill.h"
#include "tests/oracles/whole_links.h"
#include "tests/oracles/whole_street.h"
#include "tools/render/image.h"

namespace {

using namespace ilot;
namespace fs = std::filesystem;
using render::Rgb;

constexpr double kBeside = 22;            // metres that are drawn on each side of the block's facades
constexpr double kBeyond = 4;             // metres that are drawn beyond the ends of the block
constexpr std::uint32_t kLargest = 3000;  // pixels of a cloud that is drawn as a whole
constexpr Rgb kEmpty{24, 28, 48};

// The window of pixels that are drawn.
struct Window {
  std::int64_t x = 0, y = 0;
  std::uint32_t width = 0, height = 0;
};

using Paint = std::function<Rgb(std::size_t pixel)>;

class Pictures {
 public:
  Pictures(fs::path folder, const Window& window) : folder_(std::move(folder)), window_(window) {
    fs::create_directories(folder_);
  }

  void draw(const std::string& name, const Paint& paint) const {
    constexpr std::uint32_t kTimes = 2;
    render::Image image{static_cast<int>(window_.width * kTimes), static_cast<int>(window_.height * kTimes), {}};
    for (std::uint32_t y = 0; y < window_.height * kTimes; ++y)
      for (std::uint32_t x = 0; x < window_.width * kTimes; ++x)
        image.pixels.push_back(paint(std::size_t{window_.height - 1 - y / kTimes} * window_.width + x / kTimes));
    render::write_png(image, folder_ / (name + ".png"));
    fmt::print("{}\n", (folder_ / (name + ".png")).string());
  }

 private:
  fs::path folder_;
  Window window_;
};

// Paints values grey, from the 2nd to the 98th percentile.
Paint greys(const Image& image) {
  std::vector<Height> known;
  for (const Height v : image.values)
    if (v != kNoHeight && v != kAboveAll) known.push_back(v);
  std::sort(known.begin(), known.end());
  const Height low = known.empty() ? 0 : known[known.size() / 50],
               high = known.empty() ? 1 : known[known.size() * 49 / 50];
  return [&image, low, high](std::size_t i) {
    const Height v = image.values[i];
    if (v == kNoHeight) return kEmpty;
    const double share = static_cast<double>(std::clamp(v, low, high) - low) / std::max(1, high - low);
    const auto grey = static_cast<std::uint8_t>(40 + 215 * share);
    return Rgb{grey, grey, grey};
  };
}

Rgb colour_of(std::uint32_t label) {
  if (label == 0) return kEmpty;
  const std::uint32_t h = label * 2654435761u;
  const auto part = [&](int shift) { return static_cast<std::uint8_t>(70 + (h >> shift) % 186); };
  return {part(4), part(12), part(20)};
}

Paint labels(const std::vector<std::uint32_t>& of) {
  return [&of](std::size_t i) { return colour_of(of[i]); };
}

Rgb colour_of(PointLabel label) {
  if (label == PointLabel::vegetation) return {60, 150, 70};
  if (!is_street_object(label)) return {110, 110, 110};
  const auto [red, green, blue] = object_colour(label);
  return {red, green, blue};
}

// Returns the window of all pixels that contain a point.
Window window_with_points(const FoundStreet& street) {
  const TileGrid& grid = street.tiles->raster().grid;
  const Image range = layer_window(street.tiles->layers(), "range", 0, 0, grid.width, grid.height);
  std::int64_t x0 = grid.width, y0 = grid.height, x1 = -1, y1 = -1;
  for (std::int64_t y = 0; y < grid.height; ++y)
    for (std::int64_t x = 0; x < grid.width; ++x) {
      if (range.values[static_cast<std::size_t>(y * grid.width + x)] == kNoHeight) continue;
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  return {x0, y0, static_cast<std::uint32_t>(x1 - x0 + 1), static_cast<std::uint32_t>(y1 - y0 + 1)};
}

Window window_of(const FoundStreet& street, std::size_t block) {
  const TileGrid& grid = street.tiles->raster().grid;
  if (block == 0 && std::max(grid.width, grid.height) <= kLargest) return window_with_points(street);
  if (street.stretches.empty()) throw std::runtime_error("no line of facades was found");
  const StreetStretch& s = street.stretches.front();
  if (block < 1 || block > s.blocks.size())
    throw std::runtime_error(fmt::format("the first stretch has {} blocks", s.blocks.size()));
  const double pixel = street.tiles->raster().scale.pixel, dx = s.dx / pixel, dy = s.dy / pixel;
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  for (const double along : {s.blocks[block - 1].from - kBeyond, s.blocks[block - 1].to + kBeyond})
    for (const double across : {-kBeside, kBeside}) {
      const double x = s.x + along * dx - across * dy, y = s.y + along * dy + across * dx;
      x0 = std::min(x0, x), x1 = std::max(x1, x), y0 = std::min(y0, y), y1 = std::max(y1, y);
    }
  return {std::llround(x0), std::llround(y0), static_cast<std::uint32_t>(x1 - x0), static_cast<std::uint32_t>(y1 - y0)};
}

// Draws the lines of facades over the range image, with blocks in red and gaps in yellow.
void draw_blocks(const FoundStreet& street, const Window& w, const Image& range, const Pictures& pictures) {
  std::vector<std::uint8_t> drawn(range.size(), 0);
  const double pixel = street.tiles->raster().scale.pixel;
  for (const StreetStretch& s : street.stretches)
    for (const auto* list : {&s.blocks, &s.gaps})
      for (const StretchPart& part : *list)
        for (double along = part.from; along <= part.to; along += pixel / 2) {
          const auto x = std::llround(s.x + along / pixel * s.dx) - w.x,
                     y = std::llround(s.y + along / pixel * s.dy) - w.y;
          for (int v = -2; v <= 2; ++v)
            for (int u = -2; u <= 2; ++u)
              if (x + u >= 0 && y + v >= 0 && x + u < w.width && y + v < w.height)
                drawn[static_cast<std::size_t>((y + v) * w.width + x + u)] = list == &s.blocks ? 1 : 2;
        }
  const Paint grey = greys(range);
  pictures.draw("b2-blocks", [&](std::size_t i) {
    return drawn[i] == 1 ? Rgb{230, 50, 40} : drawn[i] == 2 ? Rgb{250, 210, 40} : grey(i);
  });
}

// Draws the steps from the ground to the separation, computed on the window alone.
void draw_steps(const Image& range, const RasterScale& scale, const Pictures& pictures) {
  GroundParams ground_params;
  ground_params.longest_gap = std::max(ground_params.longest_gap, 5 * scale.pixel);
  const ArtefactParams artefact_params;
  const SeparationParams separation;
  const Image closed =
      fill_short_gaps(range, {scale.pixels(ground_params.longest_gap), scale.units(ground_params.gap_step)});
  pictures.draw("b3-gaps-closed", greys(closed));
  const Image filled = test::fill_missing(closed);
  pictures.draw("b3-holes-filled", greys(filled));
  const Height flat = scale.units(ground_params.flat);
  const Image linked = test::fill_missing(test::link_regions(filled, {flat, scale.pixels(ground_params.longest_link)}));
  pictures.draw("b3-regions-linked", greys(linked));
  pictures.draw("b3-flat-zones", labels(flat_zones(linked, flat, Adjacency::eight).of));
  const test::Ground ground = test::find_ground(range, scale, ground_params);
  const Paint grey = greys(ground.filled);
  pictures.draw("b3-ground", [&](std::size_t i) { return ground.mask[i] == 1 ? grey(i) : kEmpty; });
  const test::Artefacts artefacts = test::find_artefacts(ground, scale, artefact_params);
  pictures.draw("b4-artefacts", greys(artefacts.height));
  pictures.draw("b4-bare-ground", [&](std::size_t i) { return artefacts.ground[i] == 1 ? grey(i) : kEmpty; });
  const Image opened = area_opening(artefacts.height, scale.area(separation.least_area), Adjacency::eight);
  pictures.draw("b5-opened", greys(opened));
  const Image tops = h_maxima(opened, scale.units(separation.rise), Adjacency::eight);
  pictures.draw("b5-tops", labels(regional_maxima(tops, Adjacency::eight).of));
  pictures.draw("b5-gradient", greys(gradient(opened, Adjacency::eight)));
}

// Draws the steps from the separation to the classes, as a run computes them.
void draw_candidates(const FoundStreet& street, const Image& parts, const Pictures& pictures) {
  const std::vector<std::uint32_t> part_of(parts.values.begin(), parts.values.end());
  const auto part_at = [&](std::size_t i) { return parts.values[i] == kNoHeight ? 0u : part_of[i]; };
  pictures.draw("b5-parts", [&](std::size_t i) { return colour_of(part_at(i)); });
  std::vector<CandidateFeatures> features;
  std::vector<CandidateParts> joins;
  for (const ObjectCandidate& t : street.candidates)
    features.push_back(t.features), joins.push_back({t.parts[0], t.parts[1]});
  const std::vector<CandidateClass> classes = classify_candidates(library_model(street.view), features, joins);
  const std::vector<std::uint32_t> candidate =
      candidate_of_part(street.candidates, select_objects(street.candidates, classes));
  pictures.draw("b7-whole", [&](std::size_t i) { return colour_of(candidate[part_at(i)]); });
  pictures.draw("b7-classes", [&](std::size_t i) {
    const std::uint32_t t = candidate[part_at(i)];
    return t == 0 ? kEmpty : colour_of(classes[t - 1].label);
  });
}

void run(const fs::path& cloud, const fs::path& out, std::size_t block) {
  const fs::path folder = fs::temp_directory_path() / ("bench_street_steps_" + cloud.stem().string());
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::vector<std::unique_ptr<PointReader>> readers;
  readers.push_back(open_cloud(cloud));
  PassContext context;
  const IndexResult index = build_index(readers, {}, folder, context);
  const FoundStreet street = find_street(index.store, {}, context);
  const Window w = window_of(street, block);
  const auto layer = [&](const char* name) {
    return layer_window(street.tiles->layers(), name, w.x, w.y, w.width, w.height);
  };
  const Pictures pictures(out, w);
  const Image range = layer("range");
  pictures.draw("b1-range", greys(range));
  Image accumulation = layer("accumulation");
  std::replace(accumulation.values.begin(), accumulation.values.end(), 0, kNoHeight);  // no point: empty
  pictures.draw("b1-accumulation", greys(accumulation));
  draw_blocks(street, w, range, pictures);
  draw_steps(range, street.tiles->raster().scale, pictures);
  draw_candidates(street, layer("candidates"), pictures);
  fs::remove_all(folder);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: study_street_steps CLOUD OUT [BLOCK]\n");
    return 2;
  }
  try {
    const auto block = static_cast<std::size_t>(argc > 3 ? std::atoi(argv[3]) : 1);
    with_threads(hardware_threads(), [&] { run(argv[1], argv[2], block); });
    return 0;
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_street_steps: {}\n", e.what());
    return 1;
  }
}
