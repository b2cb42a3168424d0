// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/cells/planes_pass.h"

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "engine/pass/pass.h"
#include "engine/products/planes/cells/cell_cleaning.h"
#include "engine/products/planes/cells/cell_shapes.h"
#include "engine/products/planes/cells/plane_methods.h"
#include "engine/store/flushed.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"
#include "kernels/neighbours/normals.h"
#include "kernels/plane_methods/threshold_choice.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesPerPoint = 48;  // in addition to the memory of the method

// The result of one cell as it is stored: this header, then the planes, then the labels of the points of the cell
// itself.
struct StoredCell {
  std::uint64_t planes = 0;
  std::int64_t connectivity = 1;
  double epsilon = 0, normal_angle = 25, step = 0, noise = 0;
  std::uint32_t min_points = 3;
  SeenFrom from = SeenFrom::air;
  bool curved = false;        // whether curved shapes were searched for
  std::uint8_t unused[10]{};  // the planes that follow contain 128-bit sums and are aligned
};
static_assert(sizeof(StoredCell) % alignof(CellPlane) == 0);

struct Normals {
  std::vector<float> x, y, z;
};

Normals unpack(const CellPoints& cp) {
  Normals n;
  for (auto* v : {&n.x, &n.y, &n.z}) v->assign(cp.x.size(), 0.0f);
  constexpr float kScale = 1.0f / 32767;
  for (std::size_t i = 0; i < cp.size; ++i) {
    const PackedNormal& p = cp.normals[i];
    n.x[i] = static_cast<float>(p.x) * kScale;
    n.y[i] = static_cast<float>(p.y) * kScale;
    n.z[i] = static_cast<float>(p.z) * kScale;
  }
  return n;
}

// The key of the random draws. It is a sum over the points, so their order does not change it. It is relative to the
// cell, so a shift by whole tiles does not change it either.
std::uint64_t content_key(const CellPoints& cp, std::uint64_t seed) {
  std::uint64_t sum = seed;
  for (std::size_t i = 0; i < cp.size; ++i) {
    const auto pack = [](float v) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(v) + (1 << 20)); };
    sum += mix64(mix64(pack(cp.x[i]) << 32 | pack(cp.y[i])) ^ pack(cp.z[i]));
  }
  return mix64(sum);
}

// The planes that have points in the cell itself, measured there, and the labels of these points in order.
struct CellResult {
  StoredCell header;
  std::vector<CellPlane> planes;
  std::vector<std::uint32_t> labels;
};

CellResult own_part(const CellPoints& cp, const PlaneSegments& found) {
  CellResult r;
  std::vector<std::vector<std::uint32_t>> members(found.planes.size());
  for (std::uint32_t i = 0; i < cp.size; ++i)
    if (cp.core[i] && found.label[i] != 0) members[found.label[i] - 1].push_back(i);
  std::vector<std::uint32_t> number(found.planes.size() + 1, 0);
  for (std::size_t p = 0; p < found.planes.size(); ++p) {
    if (members[p].empty()) continue;
    r.planes.push_back({found.planes[p], moments_of(cp.points(), members[p])});
    number[p + 1] = static_cast<std::uint32_t>(r.planes.size());
  }
  for (std::uint32_t i = 0; i < cp.size; ++i)
    if (cp.core[i]) r.labels.push_back(number[found.label[i]]);
  return r;
}

// The planes and shapes of a cell, and the parameters that were chosen.
struct Solved {
  PlaneSegments found;
  PlaneParams params;
  Sampling sampling;
  SeenFrom from = SeenFrom::air;
  bool searched_curved = false;
  ShapeSegments curved;  // has no labels where no shapes were searched for
};

// The epsilon at the knee of the mean squared distance as a function of epsilon, for the largest plane. Without a
// plane, epsilon does not change.
double epsilon_at_knee(const OrientedPoints& points, const Solved& s) {
  std::vector<std::uint32_t> size(s.found.planes.size(), 0), all(points.points.size);
  if (size.empty()) return s.params.epsilon;
  for (const std::uint32_t l : s.found.label)
    if (l != 0) ++size[l - 1];
  std::iota(all.begin(), all.end(), 0u);
  const auto largest = static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
  return choose_distance(points, all, s.found.planes[largest], s.sampling.noise, cos_degrees(s.params.normal_angle))
      .chosen;
}

Solved search(const CellPoints& cp, const NeighbourIndex& index, const Sampling& sampling, const Settings& settings,
              double unit_metres, std::int64_t reach) {
  const Normals n = unpack(cp);
  const std::span<const PackedNormal> normals = std::span(cp.normals).first(cp.size);
  Solved s;
  s.sampling = sampling;
  s.from = seen_from(normals);
  s.params = choose_plane_params(settings.planes, s.sampling, s.from, unit_metres, reach);
  const PlaneMethod method = choose_method(settings.planes, s.from);
  PlaneSearch search{{cp.points(), n.x.data(), n.y.data(), n.z.data()},
                     normals,
                     index,
                     s.params,
                     s.from,
                     cp.colour_class,
                     settings.planes.probability,
                     content_key(cp, settings.seed)};
  s.found = find_planes(method, search);
  if (settings.planes.epsilon || settings.planes.epsilon_by != EpsilonBy::knee || s.sampling.noise == 0) return s;
  search.params.epsilon = s.params.epsilon = epsilon_at_knee(search.points, s);
  s.found = find_planes(method, search);
  return s;
}

// Finds the spheres, cylinders and cones of a cell. Points with these labels take no part in the search for planes.
ShapeSegments search_curved(const CellPoints& cp, const NeighbourIndex& index, const Settings& settings,
                            const PlaneParams& params, SeenFrom from) {
  const Normals n = unpack(cp);
  const PlaneSearch search{{cp.points(), n.x.data(), n.y.data(), n.z.data()},
                           std::span(cp.normals).first(cp.size),
                           index,
                           params,
                           from,
                           cp.colour_class,
                           settings.planes.probability,
                           content_key(cp, settings.seed)};
  return find_curved(search, static_cast<std::uint32_t>(settings.planes.curved_points));
}

// Searches the kept points only; the other points have no plane.
Solved search_kept(const CellPoints& cp, const std::vector<std::uint8_t>& kept, const Settings& settings,
                   double unit_metres, std::int64_t reach) {
  const CellPoints part = only(cp, kept);
  const NeighbourIndex index = build_neighbour_index(part.points());
  Solved s = search(part, index, measure_sampling(index), settings, unit_metres, reach);
  std::vector<std::uint32_t> label(cp.size, 0);
  for (std::size_t i = 0, at = 0; i < cp.size; ++i)
    if (kept[i] != 0) label[i] = s.found.label[at++];
  s.found.label = std::move(label);
  return s;
}

// Finds the planes of the points that cleaning keeps and that have no curved shape, where curved shapes are searched
// for.
Solved search_all(const CellPoints& cp, const NeighbourIndex& index, const Settings& settings, double unit_metres,
                  std::int64_t reach) {
  const bool cleaned = settings.planes.cleaning != Cleaning::none;
  const SeenFrom from = seen_from(std::span(cp.normals).first(cp.size));
  const Sampling sampling = measure_sampling(index);
  const bool shapes = wants_curved(settings.planes, sampling.step * unit_metres);
  if (!cleaned && !shapes) return search(cp, index, sampling, settings, unit_metres, reach);
  const PlaneParams params = choose_plane_params(settings.planes, sampling, from, unit_metres, reach);
  std::vector<std::uint8_t> kept(cp.size, 1);
  if (cleaned) kept = kept_points(index, settings.planes.cleaning, params);
  ShapeSegments curved;
  if (shapes) curved = search_curved(cp, index, settings, params, from);
  for (std::size_t i = 0; i < curved.label.size(); ++i)
    if (curved.label[i] != 0) kept[i] = 0;
  Solved s = cleaned || !curved.shapes.empty() ? search_kept(cp, kept, settings, unit_metres, reach)
                                               : search(cp, index, sampling, settings, unit_metres, reach);
  s.from = from;
  s.searched_curved = shapes;
  s.curved = std::move(curved);
  return s;
}

CellResult solve(const Store& store, const Cell& cell, const Settings& settings, const ColourPalette& palette,
                 const PassContext& context) {
  const bool coloured = settings.planes.method == PlaneMethod::colour_ransac;
  const CellPoints cp = load_cell(store, cell, coloured ? palette : ColourPalette{});
  const NeighbourIndex index = build_neighbour_index(cp.points());
  const double unit_metres = store.unit() * context.metres_per_unit;
  const Solved s = search_all(cp, index, settings, unit_metres, margin_of(cell));
  if (!s.curved.shapes.empty()) write_cell_shapes(store, cell, cp, s.curved, s.params);
  CellResult r = own_part(cp, s.found);
  r.header = {r.planes.size(),  s.params.connectivity, s.params.epsilon, s.params.normal_angle, s.sampling.step,
              s.sampling.noise, s.params.min_points,   s.from,           s.searched_curved};
  return r;
}

void write_cell(const Store& store, const Cell& cell, const CellResult& r) {
  RecordWriter writer(cell_path(store, cell));
  writer.append(std::as_bytes(std::span(&r.header, 1)));
  writer.append(std::as_bytes(std::span(r.planes)));
  writer.append(std::as_bytes(std::span(r.labels)));
  writer.commit();
}

StoredCell header_of(const RecordReader& reader) {
  StoredCell header;
  reader.read(0, std::as_writable_bytes(std::span(&header, 1)));
  return header;
}

void summarise(const Store& store, const std::vector<Cell>& cells, std::uint32_t cell, CellPlanes& all) {
  const StoredCell header = header_of(RecordReader(cell_path(store, cells[cell])));
  all.cells[cell] = {static_cast<std::uint32_t>(all.cell_of.size()),
                     static_cast<std::uint32_t>(header.planes),
                     header.connectivity,
                     header.min_points,
                     header.epsilon,
                     header.normal_angle,
                     header.step,
                     header.noise,
                     header.from,
                     header.curved};
  all.cell_of.insert(all.cell_of.end(), header.planes, cell);
}

// Writes the labels of the cells as one column per block, numbered over all cells.
void write_segments(const Store& store, const std::vector<Cell>& cells, const CellPlanes& all,
                    const PassContext& context) {
  const auto pieces = pieces_of_blocks(store, cells);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * 8ull, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (store.has(block, columns::kSegment)) return;
    std::vector<std::uint32_t> segment(store.blocks()[block].points);
    for (const CellPiece& p : pieces[block]) {
      const auto part = std::span(segment).subspan(p.slice.first, p.slice.count);
      const std::uint64_t labels = sizeof(StoredCell) + all.cells[p.cell].plane_count * sizeof(CellPlane);
      RecordReader(cell_path(store, cells[p.cell]))
          .read(labels + p.offset * sizeof(std::uint32_t), std::as_writable_bytes(part));
      for (std::uint32_t& label : part) label += label == 0 ? 0 : all.cells[p.cell].first_plane;
    }
    store.write(block, columns::kSegment, segment);
  });
}

}  // namespace

std::filesystem::path cell_path(const Store& store, const Cell& cell) {
  return store.folder() / "cells" / (cell.node.name() + ".cell");
}

CellPlanes planes_pass(const Store& store, const std::vector<Cell>& cells, const Settings& settings,
                       const PassContext& context, const ColourPalette& palette) {
  std::filesystem::create_directories(store.folder() / "cells");
  std::vector<PassTask> tasks(cells.size());
  const std::uint64_t bytes = kBytesPerPoint + bytes_per_point(settings.planes.method);
  parallel_for(cells.size(), [&](std::size_t c) {
    tasks[c] = {points_to_load(store, cells[c]) * bytes, cells[c].points};
  });
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const Cell& cell = cells[i];
    if (!std::filesystem::exists(cell_path(store, cell)))  // this file is written after the shapes of the cell
      write_cell(store, cell, solve(store, cell, settings, palette, context));
    context.advance(cell.points);
  });
  CellPlanes all;
  all.cells.resize(cells.size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) summarise(store, cells, c, all);
  write_segments(store, cells, all, context);
  flush_pass(store, Pass::planes);
  return all;
}

void forget_cell(const Store& store, const Cell& cell) {
  std::filesystem::remove(cell_path(store, cell));
}

std::vector<CellPlane> read_cell_planes(const Store& store, const Cell& cell) {
  const RecordReader reader(cell_path(store, cell));
  const StoredCell header = header_of(reader);
  std::vector<CellPlane> planes(header.planes);
  reader.read(sizeof header, std::as_writable_bytes(std::span(planes)));
  return planes;
}

}  // namespace ilot
