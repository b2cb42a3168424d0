// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/adjacency_pass.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "engine/pass/pass.h"
#include "engine/store/flushed.h"
#include "engine/store/sorted_columns.h"
#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::uint64_t kTouchBytesPerPoint = 40;
// Derived: three places fix a line and one residual.
constexpr double kLeastPlaces = 3;
// Choice: planes that meet at less have no certain line.
constexpr double kParallel = 0.9961946980917455;  // cosine of 5 degrees

// A cube of space and a plane that has points in it.
struct Entry {
  std::uint64_t cube = 0;
  std::uint32_t plane = 0;
  friend auto operator<=>(const Entry&, const Entry&) = default;
};

struct Contacts {
  std::int64_t places = 0;
  std::int64_t x = 0, y = 0, z = 0;  // sums of the centres of the cubes from the corner of the cell, in half edges
};
using ContactMap = std::map<std::pair<std::uint32_t, std::uint32_t>, Contacts>;

constexpr int kAxisBits = 21;

// Cubes with an edge of 2^bits from the corner of the cell, moved by half an edge where asked, and the planes that have
// points in them.
class Cubes {
 public:
  Cubes(Index3 corner, int bits, bool moved) : corner_(corner), bits_(bits), moved_(moved) {}

  void add(Index3 p, std::uint32_t plane) {
    const std::int64_t half = moved_ ? std::int64_t{1} << bits_ >> 1 : 0;
    const auto place = [&](std::int64_t v, std::int64_t c) {
      return static_cast<std::uint64_t>((v - c + half) >> bits_);
    };
    const std::uint64_t cube =
        place(p.x, corner_.x) << 2 * kAxisBits | place(p.y, corner_.y) << kAxisBits | place(p.z, corner_.z);
    if (entries_.empty() || entries_.back() != Entry{cube, plane}) entries_.push_back({cube, plane});
  }

  void count(ContactMap& contacts) {
    std::sort(entries_.begin(), entries_.end());
    entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
    for (std::size_t begin = 0, end = 0; begin < entries_.size(); begin = end) {
      while (end < entries_.size() && entries_[end].cube == entries_[begin].cube) ++end;
      for (std::size_t i = begin; i < end; ++i)
        for (std::size_t j = i + 1; j < end; ++j)
          add_place(entries_[begin].cube, contacts[{entries_[i].plane, entries_[j].plane}]);
    }
  }

 private:
  void add_place(std::uint64_t cube, Contacts& c) const {
    constexpr std::uint64_t kMask = (std::uint64_t{1} << kAxisBits) - 1;
    const auto centre = [&](std::uint64_t at) { return 2 * static_cast<std::int64_t>(at) + (moved_ ? 0 : 1); };
    ++c.places;
    c.x += centre(cube >> 2 * kAxisBits);
    c.y += centre(cube >> kAxisBits & kMask);
    c.z += centre(cube & kMask);
  }

  Index3 corner_;
  int bits_;
  bool moved_;
  std::vector<Entry> entries_;
};

std::vector<Touch> touches_in(const Store& store, const Cell& cell, std::int64_t connectivity,
                              const std::vector<std::uint32_t>& final_id, const std::vector<JoinedPlane>& planes) {
  const int bits = std::bit_width(static_cast<std::uint64_t>(std::max<std::int64_t>(2, connectivity)) - 1);
  const Index3 corner = cell.node.min_corner();
  Cubes still(corner, bits, false), moved(corner, bits, true);
  constexpr std::uint32_t kBatch = 1 << 14;
  for (const CellSlice& s : cell.slices) {
    const Tile tile = store.blocks()[s.block].node.tile;
    for (std::uint32_t done = 0; done < s.count; done += kBatch) {
      const std::uint32_t n = std::min(kBatch, s.count - done);
      const auto codes = store.read(s.block, columns::kCodes, s.first + done, n);
      const auto labels = store.read(s.block, columns::kPlane, s.first + done, n);
      for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t id = final_id[labels[i]];
        if (id == 0) continue;
        const Index3 p = index_of({tile, codes[i]});
        still.add(p, id);
        moved.add(p, id);
      }
    }
  }
  ContactMap contacts;
  still.count(contacts);
  moved.count(contacts);
  const double edge = std::ldexp(1.0, bits);
  std::vector<Touch> touches;
  for (const auto& [pair, c] : contacts) {
    const Index3 anchor = planes[pair.first - 1].anchor;
    const auto places = static_cast<double>(c.places);
    const auto sum = [&](std::int64_t centres, std::int64_t from, std::int64_t to) {
      return static_cast<double>(centres) * edge / 2 + places * static_cast<double>(from - to);
    };
    touches.push_back({pair.first,
                       pair.second,
                       places * edge / 2,
                       places,
                       {sum(c.x, corner.x, anchor.x), sum(c.y, corner.y, anchor.y), sum(c.z, corner.z, anchor.z)}});
  }
  return touches;
}

double distance_at(const JoinedPlane& of, Index3 anchor, Vec3 place) {
  const Vec3 moved =
      place + Vec3{static_cast<double>(anchor.x - of.anchor.x), static_cast<double>(anchor.y - of.anchor.y),
                   static_cast<double>(anchor.z - of.anchor.z)};
  return signed_distance(of.plane, moved);
}

bool ascending(const Touch& s, const Touch& t) {
  return s.a != t.a ? s.a < t.a : s.b < t.b;
}

Vec3 upwards(Vec3 v) {
  const bool down = v.z < 0 || (v.z == 0 && (v.y < 0 || (v.y == 0 && v.x < 0)));
  return down ? -1.0 * v : v;
}

}  // namespace

void adjacency_pass(const Store& store, const std::vector<Cell>& cells, const CellPlanes& cell_planes,
                    const std::vector<std::uint32_t>& final_id, const std::vector<JoinedPlane>& planes,
                    const PassContext& context) {
  std::vector<std::vector<std::uint32_t>> cells_of(store.blocks().size());
  std::vector<PassTask> tasks(store.blocks().size());
  for (std::uint32_t c = 0; c < cells.size(); ++c) {
    const std::uint32_t block = cells[c].slices.front().block;
    cells_of[block].push_back(c);
    tasks[block].bytes += cells[c].points * kTouchBytesPerPoint;
    tasks[block].points += cells[c].points;
  }
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (store.has(block, columns::kTouches)) return;
    std::vector<std::vector<Touch>> parts(cells_of[block].size());
    parallel_for(parts.size(), [&](std::size_t p) {
      const std::uint32_t c = cells_of[block][p];
      parts[p] = touches_in(store, cells[c], cell_planes.cells[c].connectivity, final_id, planes);
    });
    std::vector<Touch> touches;
    for (const auto& part : parts) touches.insert(touches.end(), part.begin(), part.end());
    std::stable_sort(touches.begin(), touches.end(), ascending);
    store.write(block, columns::kTouches, touches);
  });
  flush_pass(store, Pass::adjacency);
}

void each_touch(const Store& store, const std::function<void(const Touch&)>& take) {
  constexpr std::uint64_t kPlanesTogether = 1 << 10;
  SortedColumns parts(store, columns::kTouches, [](const Touch& t) { return std::uint64_t{t.a}; });
  while (parts.next() != parts.kEnd) {
    std::vector<Touch> some = parts.until(parts.next() + kPlanesTogether);
    std::stable_sort(some.begin(), some.end(), ascending);  // the touches of one pair are in the order of the cells
    for (std::size_t i = 0; i < some.size();) {
      Touch sum = some[i++];
      for (; i < some.size() && some[i].a == sum.a && some[i].b == sum.b; ++i) {
        sum.length += some[i].length;
        sum.places += some[i].places;
        sum.place = sum.place + some[i].place;
      }
      if (sum.places >= kLeastPlaces) take(sum);
    }
  }
}

PlaneNeighbours neighbours_of(const Touch& touch, const JoinedPlane& a, const JoinedPlane& b, double unit,
                              double metres_per_unit) {
  PlaneNeighbours n;
  n.a = touch.a;
  n.b = touch.b;
  n.contact_m = touch.length * unit * metres_per_unit;
  const Vec3 centre = (1 / touch.places) * touch.place;
  const double from_a = distance_at(a, a.anchor, centre), from_b = distance_at(b, a.anchor, centre);
  const double c = dot(a.plane.n, b.plane.n);
  n.angle_deg = degrees_of_cosine(std::abs(c));
  Vec3 place;
  if (std::abs(c) > kParallel) {
    n.touching = Touching::step;
    n.step_m = (from_a - (c > 0 ? from_b : -from_b)) * unit * metres_per_unit;
    place = centre - from_a * a.plane.n;
  } else {
    // The foot is on both planes at once: centre + s na + t nb.
    const double s = (c * from_b - from_a) / (1 - c * c), t = (c * from_a - from_b) / (1 - c * c);
    const Vec3 along = cross(a.plane.n, b.plane.n);
    n.direction = upwards((1 / norm(along)) * along);
    place = centre + s * a.plane.n + t * b.plane.n;
  }
  n.place = {(static_cast<double>(a.anchor.x) + place.x) * unit, (static_cast<double>(a.anchor.y) + place.y) * unit,
             (static_cast<double>(a.anchor.z) + place.z) * unit};
  return n;
}

}  // namespace ilot
