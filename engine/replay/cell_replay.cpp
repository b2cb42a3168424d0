// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/cell_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/error.h"
#include "engine/replay/kept_planes.h"
#include "engine/store/stretches.h"

namespace ilot {
namespace {

std::string name_of(const Cell& cell) {
  const Index3 c = cell.node.min_corner();
  return fmt::format("cell:{},{},{}", c.x, c.y, c.z);
}

double distance2(const Cell& cell, Index3 p) {
  const IndexBox b = cell.node.box();
  const auto off = [](std::int64_t v, std::int64_t low, std::int64_t high) {
    return static_cast<double>(std::max<std::int64_t>({low - v, v - high, 0}));
  };
  const double x = off(p.x, b.min.x, b.max.x), y = off(p.y, b.min.y, b.max.y), z = off(p.z, b.min.z, b.max.z);
  return x * x + y * y + z * z;
}

const Cell& cell_of(const std::vector<Cell>& cells, const std::string& id, double unit) {
  double x = 0, y = 0, z = 0;
  long long cx = 0, cy = 0, cz = 0;
  int end = 0;
  Index3 wanted;
  const auto whole = [&] { return static_cast<std::size_t>(end) == id.size(); };
  if (std::sscanf(id.c_str(), "at:%lf,%lf,%lf%n", &x, &y, &z, &end) == 3 && whole())
    wanted = {std::llround(x / unit), std::llround(y / unit), std::llround(z / unit)};
  else if (std::sscanf(id.c_str(), "%lld,%lld,%lld%n", &cx, &cy, &cz, &end) == 3 && whole())
    wanted = {cx, cy, cz};
  else
    throw Error("cell:" + id + ": write cell:X,Y,Z or cell:at:E,N,H", ExitCode::usage);
  const bool at = id.starts_with("at:");
  const auto nearest = std::min_element(cells.begin(), cells.end(), [&](const Cell& a, const Cell& b) {
    return distance2(a, wanted) < distance2(b, wanted);
  });
  if (nearest != cells.end() && (at ? distance2(*nearest, wanted) == 0 : nearest->node.min_corner() == wanted))
    return *nearest;
  throw Error("cell:" + id + ": there is no such cell with points" +
                  (nearest == cells.end() ? "" : "; the nearest is " + name_of(*nearest)) + " (ilot replay OUT --list)",
              ExitCode::usage);
}

// Removes the links to files that are computed again.
void forget(const Store& scratch, const Cell& cell) {
  forget_cell(scratch, cell);
  for (const CellSlice& s : cell.slices) {
    std::filesystem::remove(scratch.path(s.block, columns::kNormals));
    std::filesystem::remove(scratch.path(s.block, columns::kSegment));
    std::filesystem::remove(scratch.path(s.block, columns::kPlane));
    std::filesystem::remove(scratch.path(s.block, columns::kTally));
  }
}

Vec3 unpacked(const PackedNormal& n) {
  constexpr double kScale = 1.0 / 32767;
  return {n.x * kScale, n.y * kScale, n.z * kScale};
}

void add_points(const Store& store, const CellSlice& slice, std::uint32_t first_plane,
                const std::vector<std::uint32_t>& final_id, CellReplay& replay) {
  const auto codes = store.read(slice.block, columns::kCodes, slice.first, slice.count);
  const auto normals = store.read(slice.block, columns::kNormals, slice.first, slice.count);
  const auto segments = store.read(slice.block, columns::kSegment, slice.first, slice.count);
  const auto planes = store.read(slice.block, columns::kPlane, slice.first, slice.count);
  const Tile tile = store.blocks()[slice.block].node.tile;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const Index3 p = index_of({tile, codes[i]});
    replay.points.push_back({{static_cast<double>(p.x) * store.unit(), static_cast<double>(p.y) * store.unit(),
                              static_cast<double>(p.z) * store.unit()},
                             unpacked(normals[i]),
                             normals[i].curvature / 65535.0 / 3,
                             segments[i] == 0 ? 0 : segments[i] - first_plane,
                             final_id[planes[i]]});
  }
}

template <class T>
void compare(const Store& now, const Store& kept, const Cell& cell, const Column<T>& column, const char* what,
             std::vector<std::string>& differences) {
  std::uint64_t others = 0;
  for (const CellSlice& s : cell.slices) {
    const auto a = now.read(s.block, column, s.first, s.count), b = kept.read(s.block, column, s.first, s.count);
    for (std::size_t i = 0; i < a.size(); ++i) others += !(a[i] == b[i]);
  }
  if (others > 0)
    differences.push_back(grouped(others) + (others == 1 ? " point has another " : " points have another ") + what +
                          " than in the store");
}

}  // namespace

CellReplay replay_cell(const KeptRun& run, const std::string& id, Progress& progress) {
  const Store& store = run.store();
  if (!store.has(0, columns::kSegment))
    throw Error("cell:" + id + ": the run found no planes (--products planes)", ExitCode::usage);
  const std::vector<Cell> cells = canonical_cells(store, run.context().metres_per_unit);
  const Cell& cell = cell_of(cells, id, store.unit());
  forget(store, cell);
  const auto planes = kept_planes(run, progress);
  const CellPlanes found = planes_pass(store, cells, run.options().settings, run.context());  // of the current content
  CellReplay replay;
  replay.corner = cell.node.min_corner();
  replay.unit = store.unit();
  replay.edge = static_cast<double>(cell.node.edge()) * store.unit();
  replay.metres_per_unit = run.context().metres_per_unit;
  replay.summary = found.cells[static_cast<std::size_t>(&cell - cells.data())];
  replay.planes = read_cell_planes(store, cell);
  for (const CellSlice& slice : cell.slices)
    add_points(store, slice, replay.summary.first_plane, planes->final_id, replay);
  const Store kept(run.options().store, store.unit(), store.blocks());
  compare(store, kept, cell, columns::kNormals, "normal", replay.differences);
  compare(store, kept, cell, columns::kSegment, "segment", replay.differences);
  compare(store, kept, cell, columns::kPlane, "plane", replay.differences);
  return replay;
}

std::vector<std::string> cells_to_replay(const Store& store, const PassContext& context) {
  std::vector<std::string> lines;
  for (const Cell& cell : canonical_cells(store, context.metres_per_unit)) {
    const Index3 c = cell.node.min_corner();
    const double half = 0.5 * static_cast<double>(cell.node.edge());
    const auto middle = [&](std::int64_t v) { return (static_cast<double>(v) + half) * store.unit(); };
    lines.push_back(fmt::format("{}  at {:.1f} {:.1f} {:.1f}  edge {:.1f} m, {} points", name_of(cell), middle(c.x),
                                middle(c.y), middle(c.z), 2 * half * store.unit() * context.metres_per_unit,
                                grouped(cell.points)));
  }
  return lines;
}

}  // namespace ilot
