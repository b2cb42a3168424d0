// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/carriageways.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/flat_area.h"
#include "engine/products/streets/pavements/kerb_transects.h"
#include "kernels/geometry/flat.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

// Choice: corners of areas that are as near are one; far below the error of a kerb.
constexpr double kGrid = 1e-3;  // metres

// A way across the road, in metres.
struct Way {
  FlatPoint from, to;
  std::size_t other = 0;                  // the kerb on the far side
  std::uint32_t number = 0, missing = 0;  // along the chain, from 1; places before it from which no kerb was met
  bool seen = true;                       // both kerbs were
  double length() const { return distance(from, to); }
};

// Ways from one chain with road between them.
using WayRun = std::vector<Way>;

// Kerbs that begin where another ends, as those that were not seen do, and that kerb. In metres.
struct KerbChain {
  std::vector<Vec3> line;
  std::vector<double> ends;        // metres along the line at which each kerb ends
  std::vector<std::size_t> kerbs;  // indices

  std::size_t kerb_at(double along) const {
    const auto found = std::lower_bound(ends.begin(), ends.end() - 1, along);
    return kerbs[static_cast<std::size_t>(found - ends.begin())];
  }
};

double length_of(const std::vector<Vec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += norm(FlatPoint{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y});
  return length;
}

// Chains begin at kerbs that no kerb leads to; of closed ones at the first kerb.
std::vector<KerbChain> chains_of(const std::vector<std::vector<Vec3>>& lines) {
  const auto place = [](const Vec3& p) { return std::pair(p.x, p.y); };
  std::map<std::pair<double, double>, std::size_t> starting;
  std::set<std::pair<double, double>> ending;
  for (std::size_t k = 0; k < lines.size(); ++k)
    starting.try_emplace(place(lines[k].front()), k), ending.insert(place(lines[k].back()));
  std::vector<std::uint8_t> taken(lines.size(), 0);
  std::vector<KerbChain> chains;
  const auto follow = [&](std::size_t k) {
    KerbChain chain;
    while (taken[k] == 0) {
      taken[k] = 1;
      chain.line.insert(chain.line.end(), lines[k].begin() + (chain.line.empty() ? 0 : 1), lines[k].end());
      chain.kerbs.push_back(k), chain.ends.push_back(length_of(chain.line));
      const auto next = starting.find(place(lines[k].back()));
      if (next == starting.end()) break;
      k = next->second;
    }
    if (!chain.kerbs.empty()) chains.push_back(std::move(chain));
  };
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (!ending.contains(place(lines[k].front()))) follow(k);
  for (std::size_t k = 0; k < lines.size(); ++k) follow(k);
  return chains;
}

std::vector<std::vector<Vec3>> lines_in_metres(std::span<const StreetKerb> kerbs, double metres_per_unit) {
  std::vector<std::vector<Vec3>> lines;
  for (const StreetKerb& kerb : kerbs) {
    lines.emplace_back();
    for (const Vec3& p : kerb.line) lines.back().push_back(metres_per_unit * p);
  }
  return lines;
}

bool alike(const Way& a, const Way& b, const CarriagewayParams& params) {
  return std::abs(a.length() - b.length()) <= params.same_length;
}

// Ways that cross each other on the way are apart, so that no area is turned over.
bool continues(const Way& a, const Way& b, const CarriagewayParams& params) {
  if (dot(b.from - a.from, b.to - a.to) < 0) return false;
  return b.number == a.number + 1 || (alike(a, b, params) && distance(a.from, b.from) <= params.longest_gap);
}

std::vector<WayRun> runs_of_ways(std::span<const StreetKerb> kerbs, double metres_per_unit,
                                 const CarriagewayParams& params) {
  const std::vector<std::vector<Vec3>> lines = lines_in_metres(kerbs, metres_per_unit);
  const KerbLookup lookup(lines);
  std::vector<WayRun> runs;
  for (const KerbChain& chain : chains_of(lines)) {
    bool open = false;  // the last run may go on
    for (const Transect& t : transects_over(chain.line, params.spacing)) {
      const KerbAhead ahead = lookup.next(t.at.x, t.at.y, -t.across_x, -t.across_y, params.nearest, params.widest);
      if (!ahead.faces) {
        open = open && std::isinf(ahead.distance);
        continue;
      }
      const FlatPoint from{t.at.x, t.at.y};
      Way way{from, from - ahead.distance * FlatPoint{t.across_x, t.across_y}, ahead.line, t.number};
      way.seen = kerbs[chain.kerb_at(t.along)].seen && kerbs[ahead.line].seen;
      if (!open || !continues(runs.back().back(), way, params)) runs.emplace_back();
      if (!runs.back().empty()) way.missing = way.number - runs.back().back().number - 1;
      runs.back().push_back(way);
      open = true;
    }
  }
  std::erase_if(runs, [&](const WayRun& run) {
    double length = 0;
    for (std::size_t i = 1; i < run.size(); ++i) length += distance(run[i - 1].from, run[i].from);
    return length < params.least_length;
  });
  return runs;
}

// The area between two ways of a run. Where one goes on beside what the other ends at, as an island, the area is as
// deep as the shorter one.
FlatPolygon piece_between(const Way& a, const Way& b, const CarriagewayParams& params) {
  const bool whole = a.other == b.other || alike(a, b, params);
  const double depth = std::min(a.length(), b.length());
  const auto end = [&](const Way& way) {
    return whole ? way.to : way.from + depth / way.length() * (way.to - way.from);
  };
  return {{a.from, b.from, end(b), end(a)}, {}};
}

std::vector<FlatPolygon> pieces_of(const std::vector<WayRun>& runs, const CarriagewayParams& params) {
  std::vector<FlatPolygon> pieces;
  for (const WayRun& run : runs)
    for (std::size_t i = 1; i < run.size(); ++i) pieces.push_back(piece_between(run[i - 1], run[i], params));
  return pieces;
}

// A place inside of the first piece of a run; the whole run is in one carriageway.
FlatPoint place_in(const WayRun& run, const CarriagewayParams& params) {
  FlatPoint sum;
  for (const FlatPoint& corner : piece_between(run[0], run[1], params).ring) sum = sum + 0.25 * corner;
  return sum;
}

std::vector<Vec3> in_units(const std::vector<FlatPoint>& ring, double metres_per_unit) {
  std::vector<Vec3> out;
  for (const FlatPoint& p : ring) out.push_back({p.x / metres_per_unit, p.y / metres_per_unit, 0});
  return out;
}

double area_of(const FlatPolygon& polygon) {
  double doubled = doubled_area(polygon.ring);
  for (const auto& hole : polygon.holes) doubled += doubled_area(hole);
  return doubled / 2;
}

// What its ways say of a carriageway.
void measure(const std::vector<const WayRun*>& runs, Carriageway& road) {
  std::vector<double> lengths;
  std::size_t seen = 0, missing = 0;
  for (const WayRun* run : runs)
    for (const Way& way : *run) {
      lengths.push_back(way.length());
      missing += way.missing;
      seen += way.seen ? 1 : 0;
    }
  std::sort(lengths.begin(), lengths.end());
  road.width_m = (lengths[(lengths.size() - 1) / 2] + lengths[lengths.size() / 2]) / 2;
  road.narrowest_m = lengths.front();
  road.seen_share = static_cast<double>(seen) / static_cast<double>(lengths.size() + missing);
}

}  // namespace

std::vector<Carriageway> find_carriageways(std::span<const StreetKerb> kerbs, double metres_per_unit,
                                           const CarriagewayParams& params) {
  const std::vector<WayRun> runs = runs_of_ways(kerbs, metres_per_unit, params);
  std::vector<FlatPolygon> polygons = FlatArea(pieces_of(runs, params), kGrid).simplified(params.tolerance).polygons();
  std::sort(polygons.begin(), polygons.end(), [](const FlatPolygon& a, const FlatPolygon& b) {
    return std::pair(a.ring[0].x, a.ring[0].y) < std::pair(b.ring[0].x, b.ring[0].y);
  });
  std::vector<Carriageway> roads;
  for (FlatPolygon& polygon : polygons) {
    std::erase_if(polygon.holes, [&](const auto& hole) { return -doubled_area(hole) / 2 < params.least_hole; });
    std::vector<const WayRun*> inside;
    for (const WayRun& run : runs)
      if (contains(polygon, place_in(run, params))) inside.push_back(&run);
    if (inside.empty()) continue;
    Carriageway road;
    road.id = static_cast<std::uint32_t>(roads.size() + 1);
    road.ring = in_units(polygon.ring, metres_per_unit);
    for (const auto& hole : polygon.holes) road.holes.push_back(in_units(hole, metres_per_unit));
    road.area_m2 = area_of(polygon);
    measure(inside, road);
    roads.push_back(std::move(road));
  }
  return roads;
}

}  // namespace ilot
