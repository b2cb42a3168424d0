// SPDX-License-Identifier: Apache-2.0
// Measures each step of streets, from blocks on disk to labels on disk: processor time, nanoseconds for each pixel of
// the tiles that contain points, the peak of memory so far, and the total points per second of processor time. All
// settings have their defaults. MEBIBYTES [1024] is the memory budget of the passes.
// Usage: study_street_speed CLOUD WORK [THREADS [MEBIBYTES]]
#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "engine/formats/reader.h"
#include "engine/pass/index.h"
#include "engine/products/streets/ground/street_mask.h"
#include "engine/products/streets/ground/structures.h"
#include "engine/products/streets/ground/tiled_artefacts.h"
#include "engine/products/streets/ground/tiled_ground.h"
#include "engine/products/streets/objects/object_selection.h"
#include "engine/products/streets/street_labels.h"
#include "engine/products/streets/street_training.h"
#include "kernels/core/parallel.h"

namespace {

using namespace ilot;

double processor_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double peak_mebibytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Step {
  const char* name;
  double seconds, mebibytes;
};

class Clock {
 public:
  template <class Work>
  void time(const char* name, const Work& work) {
    const double before = processor_seconds();
    work();
    steps_.push_back({name, processor_seconds() - before, peak_mebibytes()});
  }
  void print(std::uint64_t points, double pixels) const {
    double all = 0;
    for (const Step& s : steps_) all += s.seconds;
    fmt::print("{:<22}{:>10}{:>12}{:>12}\n", "step", "seconds", "ns a pixel", "peak, MiB");
    for (const Step& s : steps_)
      fmt::print("{:<22}{:>10.3f}{:>12.1f}{:>12.0f}\n", s.name, s.seconds, 1e9 * s.seconds / pixels, s.mebibytes);
    fmt::print("{:<22}{:>10.3f}{:>12.1f}\n", "blocks to labels", all, 1e9 * all / pixels);
    fmt::print("{:.1f} M pixels, {:.2f} M points, {:.2f} M points a second of processor time\n", pixels / 1e6,
               static_cast<double>(points) / 1e6, static_cast<double>(points) / 1e6 / all);
  }

 private:
  std::vector<Step> steps_;
};

// Returns the object candidate to which each point belongs, by the default model.
ObjectLabels labels_of(const FoundStreet& street) {
  static const StreetClasses model{&default_object_model(), {}};
  const std::vector<CandidateClass> classes = model.of(street.candidates);
  const std::vector<std::uint32_t> candidate_of =
      candidate_of_part(street.candidates, select_objects(street.candidates, classes));
  ObjectLabels labels{{0}, {PointLabel::none}, {0}};
  for (std::size_t part = 1; part < candidate_of.size(); ++part) {
    labels.object.push_back(candidate_of[part]);
    labels.label.push_back(classes[candidate_of[part] - 1].label);
    labels.top.push_back(INFINITY);
  }
  return labels;
}

void measure(const std::filesystem::path& cloud, const std::filesystem::path& work, std::uint64_t budget_bytes) {
  PassContext context;
  context.budget_bytes = budget_bytes;
  std::vector<std::unique_ptr<PointReader>> readers;
  readers.push_back(open_cloud(cloud));
  const IndexResult index = build_index(readers, {}, work, context);
  const Store& store = index.store;
  Clock clock;
  FoundStreet street;
  clock.time("density", [&] { street.density = point_density(store, context); });
  const StreetView view = view_of(street.density);
  const double pixel = pixel_for(street.density.median, view);
  clock.time("images",
             [&] { street.tiles = std::make_unique<StreetTiles>(store, context, pixel, street.density.median); });
  const StreetTiles& tiles = *street.tiles;
  const RasterScale& scale = tiles.raster().scale;
  ObjectCandidateParams params;
  clock.time("terrain", [&] { street.terrain = find_terrain(tiles.cells()); });
  clock.time("heights", [&] { tiles.draw_heights(view); });
  clock.time("structures", [&] {
    find_structures(tiles.cells(), view);
    tiles.take_out_overhead();
  });
  clock.time("ground", [&] { fill_ground_tiled(tiles.layers(), scale); });
  clock.time("mask", [&] { find_street_mask(tiles.layers(), tiles.cells()); });
  clock.time("what stands on it", [&] {
    const ArtefactParams artefacts;
    find_artefacts_tiled(tiles.layers(), scale, artefacts);
    put_on_terrain(tiles.layers(), tiles.cells(), artefacts.highest_kerb, artefacts.least_height);
  });
  clock.time("level of the ground", [&] { tiles.spread_level(ArtefactParams{}.ring_reach); });
  clock.time("points above it", [&] {
    params.mean_accumulation = tiles.mean_accumulation();
    tiles.count_above(ArtefactParams{}.least_height, params.low_height);
  });
  clock.time("things", [&] { street.candidates = find_object_candidates(tiles.layers(), scale, params); });
  clock.time("blocks", [&] { street.stretches = find_city_blocks(tiles.layers(), scale); });
  ObjectLabels labels;
  clock.time("classes", [&] { labels = labels_of(street); });
  clock.time("labels", [&] { write_street_labels(store, tiles, labels, ArtefactParams{}.least_height, context); });
  double pixels = 0;
  const TileGrid& grid = tiles.layers().grid;
  for (std::size_t t = 0; t < grid.count(); ++t) pixels += static_cast<double>(grid.side) * grid.side;
  clock.print(store.points(), pixels);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: study_street_speed CLOUD WORK [THREADS [MEBIBYTES]]\n");
    return 2;
  }
  // The allocator keeps freed memory, as in `ilot run`. Otherwise the system would clear images of 1 MiB again and
  // again.
  mallopt(M_MMAP_THRESHOLD, 16 << 20);
  mallopt(M_TRIM_THRESHOLD, 32 << 20);
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1, mebibytes = argc > 4 ? std::atoi(argv[4]) : 1024;
  with_threads(threads, [&] { measure(argv[1], argv[2], std::uint64_t(mebibytes) << 20); });
  return 0;
}
