// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/extend_pass.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <tuple>
#include <unordered_map>

#include "engine/pass/pass.h"
#include "engine/store/extended_columns.h"
#include "engine/store/stretches.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"
#include "kernels/planes/extend.h"

namespace ilot {
namespace {

constexpr std::uint64_t kExtendBytesPerPoint = 72;  // an estimate: 66 where all points have labels
// Derived: 2.8 of the 3.5 standard deviations of epsilon, so that noise leaves few points of a kept surface out.
constexpr double kExtendShare = 0.8;  // of the smaller epsilon of two planes
// Derived: the rounding of coordinates to float32, so that points stay within epsilon.
constexpr double kStrictlyInside = 1 - 1e-6;

const std::array<Column<ExtendedPoint>, kExtendRounds> kRounds{columns::kExtended1, columns::kExtended2,
                                                               columns::kExtended3, columns::kExtended4};

// A point of a block that gets another plane.
struct Change {
  std::uint32_t block = 0, point = 0, plane = 0;
};

// What a round changed in a cell. The box is around the points that changed.
struct Changes {
  std::vector<Change> list;
  IndexBox box{{INT64_MAX, INT64_MAX, INT64_MAX}, {INT64_MIN, INT64_MIN, INT64_MIN}};

  void add(const Change& change, Index3 p) {
    list.push_back(change);
    box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y), std::min(box.min.z, p.z)};
    box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y), std::max(box.max.z, p.z)};
  }
};

std::filesystem::path path_of(const Store& store, const Cell& cell, std::size_t round) {
  return store.folder() / "extension" / (cell.node.name() + "." + std::to_string(round + 1));
}

std::filesystem::path box_path(const Store& store, const Cell& cell, std::size_t round) {
  return path_of(store, cell, round).concat(".box");
}

IndexBox surroundings(const Cell& cell, const CellSummary& summary) {
  return cell.node.box().grown(std::min(summary.connectivity, margin_of(cell)));
}

// Reads the joined planes of points of a block after some rounds.
void read_planes(const Store& store, const JoinedPlanes& joined, std::size_t rounds, std::uint32_t block,
                 std::uint32_t first, std::span<std::uint32_t> planes) {
  store.open(block, columns::kSegment).read(first, planes);
  for (std::uint32_t& p : planes) p = p == 0 ? 0 : joined.of_segment[p - 1];
  if (rounds == 0) return;
  const auto changed = store.open(block, kRounds[rounds - 1]);
  std::uint64_t at = 0;
  for (std::uint64_t end = changed.size(); at < end;) {
    const std::uint64_t middle = at + (end - at) / 2;
    if (changed.at(middle).point < first)
      at = middle + 1;
    else
      end = middle;
  }
  constexpr std::uint64_t kBatch = 256;
  std::array<ExtendedPoint, kBatch> batch;
  while (at < changed.size()) {
    const auto some = std::span(batch).first(std::min(kBatch, changed.size() - at));
    changed.read(at, some);
    for (const ExtendedPoint& p : some) {
      if (p.point - first >= planes.size()) return;
      planes[p.point - first] = p.plane;
    }
    at += some.size();
  }
}

// The planes before a round, by index of the joined plane plus one.
class Before {
 public:
  Before(const Store& store, const JoinedPlanes& joined, std::size_t round)
      : store_(store), joined_(joined), round_(round) {}

  std::vector<std::uint32_t> read(std::uint32_t block, std::uint32_t first, std::uint32_t count) const {
    std::vector<std::uint32_t> planes(count);
    read_planes(store_, joined_, round_, block, first, planes);
    return planes;
  }

 private:
  const Store& store_;
  const JoinedPlanes& joined_;
  std::size_t round_;
};

// The labelled points of a cell and its surroundings.
struct Patch : PaddedPoints {
  std::vector<std::uint32_t> plane;  // joined planes; then numbers by precedence
  std::vector<std::uint8_t> core;
  std::vector<Change> place;       // of the points of the cell itself, in order
  std::vector<std::uint32_t> ids;  // joined plane of each number, the first one has precedence
};

Patch load_patch(const Store& store, const Cell& cell, const CellSummary& summary, const Before& before) {
  const IndexBox own = cell.node.box(), around = surroundings(cell, summary);
  const View plan = plan_view(store, around, cell.node.min_corner());
  Patch patch;
  for_each_stretch(store, plan.slices, [&](const Stretch& s) {
    const auto planes = before.read(s.block, s.first, static_cast<std::uint32_t>(s.codes.size()));
    for (std::uint32_t i = 0; i < s.codes.size(); ++i) {
      if (planes[i] == 0) continue;
      const Index3 p = s.position(i);
      if (!around.contains(p)) continue;
      const bool core = own.contains(p);
      patch.add(static_cast<float>(p.x - plan.anchor.x), static_cast<float>(p.y - plan.anchor.y),
                static_cast<float>(p.z - plan.anchor.z));
      patch.plane.push_back(planes[i]);
      patch.core.push_back(core);
      if (core) patch.place.push_back({s.block, s.first + i, planes[i]});
    }
  });
  patch.pad();
  return patch;
}

// Numbers the planes of a patch by precedence.
void number(Patch& patch, const JoinedPlanes& joined) {
  for (std::uint32_t last = 0; const std::uint32_t plane : patch.plane)
    if (plane != last) patch.ids.push_back(last = plane);
  std::sort(patch.ids.begin(), patch.ids.end());
  patch.ids.erase(std::unique(patch.ids.begin(), patch.ids.end()), patch.ids.end());
  std::sort(patch.ids.begin(), patch.ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t of_a = joined.planes[a - 1].points, of_b = joined.planes[b - 1].points;
    return of_a != of_b ? of_a > of_b : a < b;
  });
  std::unordered_map<std::uint32_t, std::uint32_t> numbers;
  for (std::uint32_t n = 0; n < patch.ids.size(); ++n) numbers.emplace(patch.ids[n], n + 1);
  std::uint32_t last = 0, of_last = 0;  // neighbours in the list mostly have the same plane
  for (std::uint32_t& plane : patch.plane) {
    if (plane != last) of_last = numbers.at(last = plane);
    plane = of_last;
  }
}

Changes changes_in(const Store& store, const Cell& cell, const CellSummary& summary, const Before& before,
                   const JoinedPlanes& joined, double rounding) {
  Patch patch = load_patch(store, cell, summary, before);
  number(patch, joined);
  if (patch.ids.size() < 2) return {};
  const Index3 corner = cell.node.min_corner();
  std::vector<ExtendedPlane> planes;
  for (const std::uint32_t id : patch.ids) {
    const JoinedPlane& j = joined.planes[id - 1];
    const Vec3 from_anchor{static_cast<double>(corner.x - j.anchor.x), static_cast<double>(corner.y - j.anchor.y),
                           static_cast<double>(corner.z - j.anchor.z)};
    planes.push_back({{j.plane.n, j.plane.d + dot(j.plane.n, from_anchor)}, j.epsilon * kStrictlyInside - rounding});
  }
  Changes changes;
  const ExtendParams params{cell.node.edge(), summary.connectivity, cos_degrees(summary.normal_angle), kExtendShare};
  if (extend_planes(patch.points(), patch.core, planes, params, patch.plane) == 0) return changes;
  std::size_t own = 0;
  for (std::size_t i = 0; i < patch.size; ++i) {
    if (!patch.core[i]) continue;
    const Change& was = patch.place[own++];
    const std::uint32_t now = patch.ids[patch.plane[i] - 1];
    if (now == was.plane) continue;
    changes.add({was.block, was.point, now},
                {corner.x + static_cast<std::int64_t>(patch.x[i]), corner.y + static_cast<std::int64_t>(patch.y[i]),
                 corner.z + static_cast<std::int64_t>(patch.z[i])});
  }
  return changes;
}

// The cells in which, or near which, points changed in the round before. Only they can change.
std::vector<std::uint8_t> active_cells(const Store& store, const std::vector<Cell>& cells, const CellPlanes& found,
                                       std::size_t round) {
  if (round == 0) return std::vector<std::uint8_t>(cells.size(), 1);
  std::vector<std::uint8_t> active(cells.size(), 0);
  std::int64_t edge = 1;
  for (const Cell& cell : cells) edge = std::max(edge, cell.node.edge());
  using Place = std::tuple<std::int64_t, std::int64_t, std::int64_t>;
  const auto place = [&](const Cell& cell, std::int64_t dx, std::int64_t dy, std::int64_t dz) {
    const Index3 c = cell.node.min_corner();
    const auto at = [&](std::int64_t v) { return v >= 0 ? v / edge : -((edge - 1 - v) / edge); };
    return Place{at(c.x) + dx, at(c.y) + dy, at(c.z) + dz};
  };
  std::vector<std::pair<Place, std::uint32_t>> by_place;
  for (std::uint32_t c = 0; c < cells.size(); ++c) by_place.push_back({place(cells[c], 0, 0, 0), c});
  std::sort(by_place.begin(), by_place.end());
  for (const Cell& changed : cells) {
    if (!std::filesystem::exists(path_of(store, changed, round - 1))) continue;
    const IndexBox box = read_column<IndexBox>(box_path(store, changed, round - 1)).at(0);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
          const Place at = place(changed, dx, dy, dz);
          auto c = std::lower_bound(by_place.begin(), by_place.end(), std::pair{at, std::uint32_t{0}});
          for (; c != by_place.end() && c->first == at; ++c)
            active[c->second] |= surroundings(cells[c->second], found.cells[c->second]).intersects(box);
        }
  }
  return active;
}

// Writes the column of a round: the points changed before it, and the changes of its cells in their place.
void write_round(const Store& store, const std::vector<Cell>& cells, std::size_t round, const PassContext& context) {
  constexpr std::uint64_t kChangeBytes = sizeof(Change) + 2 * sizeof(ExtendedPoint);  // if all points change
  const auto pieces = pieces_of_blocks(store, cells);
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kChangeBytes, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (store.has(block, kRounds[round])) return;
    std::vector<ExtendedPoint> changed;
    for (const CellPiece& piece : pieces[block]) {
      const std::filesystem::path path = path_of(store, cells[piece.cell], round);
      if (!std::filesystem::exists(path)) continue;
      for (const Change& change : read_column<Change>(path))
        if (change.block == block) changed.push_back({change.point, change.plane});
    }
    if (round > 0) {
      const auto before = store.read(block, kRounds[round - 1]);
      changed.insert(changed.end(), before.begin(), before.end());
    }
    const auto by_point = [](const ExtendedPoint& a, const ExtendedPoint& b) { return a.point < b.point; };
    std::stable_sort(changed.begin(), changed.end(), by_point);  // of one point, the change of this round comes first
    changed.erase(std::unique(changed.begin(), changed.end(),
                              [](const ExtendedPoint& a, const ExtendedPoint& b) { return a.point == b.point; }),
                  changed.end());
    store.write(block, kRounds[round], changed);
  });
}

bool is_written(const Store& store, std::size_t round) {
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block)
    if (!store.has(block, kRounds[round])) return false;
  return true;
}

void run_round(const Store& store, const std::vector<Cell>& cells, const CellPlanes& found, const JoinedPlanes& joined,
               std::size_t round, const PassContext& context) {
  if (is_written(store, round)) return;
  const std::vector<std::uint8_t> active = active_cells(store, cells, found, round);
  std::vector<std::uint32_t> work;
  for (std::uint32_t c = 0; c < cells.size(); ++c)
    if (active[c]) work.push_back(c);
  std::vector<PassTask> tasks(work.size());
  parallel_for(work.size(), [&](std::size_t i) {
    const Cell& cell = cells[work[i]];
    const View plan = plan_view(store, surroundings(cell, found.cells[work[i]]), cell.node.min_corner());
    tasks[i] = {plan.size * kExtendBytesPerPoint, cell.points};
  });
  const Before before(store, joined, round);
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const Cell& cell = cells[work[i]];
    const Changes changes = changes_in(store, cell, found.cells[work[i]], before, joined, context.rounding);
    if (changes.list.empty()) return;
    write_column<IndexBox>(box_path(store, cell, round), std::span(&changes.box, 1));
    write_column<Change>(path_of(store, cell, round), changes.list);
  });
  write_round(store, cells, round, context);
}

void find_too_small(const Store& store, JoinedPlanes& joined) {
  std::vector<std::uint64_t> points(joined.planes.size() + 1, 0);
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block)
    for (const std::uint32_t plane : Before(store, joined, kRounds.size()).read(block, 0, store.blocks()[block].points))
      ++points[plane];
  for (std::size_t i = 0; i < joined.planes.size(); ++i)
    joined.planes[i].too_small = points[i + 1] < joined.planes[i].min_points;
}

}  // namespace

void read_extended(const Store& store, const JoinedPlanes& joined, std::uint32_t block, std::uint32_t first,
                   std::span<std::uint32_t> planes) {
  read_planes(store, joined, kRounds.size(), block, first, planes);
}

void extend_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& found, JoinedPlanes& joined,
                 const PassContext& context) {
  std::filesystem::create_directories(store.folder() / "extension");
  for (std::size_t round = 0; round < kRounds.size(); ++round) run_round(store, cells, found, joined, round, context);
  find_too_small(store, joined);
}

}  // namespace ilot
