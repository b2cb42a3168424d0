// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/silent_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>

#include "engine/products/facades/openings/barred_holes.h"
#include "engine/products/facades/sides/located_edge.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: two cells less than the least opening; smaller squares fit between the points of thin scans.
constexpr double kSquare = 0.8;  // share of the least opening: side of the square that fits in a hole
// Choice: one stray or mixed point in 25; a lattice of bars fills more and is seen as such.
constexpr double kStray = 0.04;  // share of the cells of the square in which there may be points
// Choice: a window whose frame and curtains are seen has more.
constexpr double kLeastEmpty = 0.4;  // share of the cells of a hole in which nothing was seen
// Derived: a half circle fills 0.785 of its box, a pointed arch on short jambs 0.75.
constexpr double kStraightFill = 0.75;  // share of its box that a hole with straight sides fills
// Derived: straight sides that meet above jambs of three tenths of the height fill 0.65 of the box; rims take a
// twelfth.
constexpr double kArchFill = 0.6;  // the same for a hole that becomes narrower on both sides alike
// Choice: two thirds of the rows; the crown of a tree has a third or less.
constexpr double kStraight = 0.66;  // share of rows and columns that end at a straight side
// Derived: with 12 rays expected, none arrives by chance once in 160,000 holes.
constexpr double kLeastRays = 12;
// Choice: the width of a narrow pier.
constexpr double kRing = 0.3;  // metres around a hole in which the wall shows where the station fired
// Choice: a pier between two holes fills a fifth of the strip beside one of them.
constexpr double kBeside = 0.2;  // share of the rays that a strip beside a hole would have, were it all wall
// Choice: a railing or bare branches stop a third; a crown in leaf stops more.
constexpr double kMostStopped = 0.35;  // share of the rays of a crossed hole that ended before it
// Choice: reveals of 2 cm have that many points at 45 degrees on a window of 1 m.
constexpr double kLeastBehind = 0.01;  // share of the rays that end in a hole behind the wall, where the street is cut
// Choice: fewer are stray echoes.
constexpr double kFewestBehind = 4;  // points behind the wall, whatever the share
// Choice: the bare disc below a tripod.
constexpr double kBareDisc = 4;        // metres around a station in which there is ground, where nothing was cut off
constexpr std::uint64_t kGround = 10;  // points of it
// Choice: a door begins at a step or a kerb.
constexpr double kFoot = 0.35;  // metres above the foot of the wall: below it there is no wall
// Choice: more may be a front of glass or a gap between houses.
constexpr double kMostOfWall = 0.6;  // share of the wall that one hole covers
// The station of all rays where none is known; others are those of stations that are not in front of the wall.
constexpr SiteStation kNoStation = 0;

using enum WallCells::What;

// What holes end at. What stands before the wall hides a part of a hole, or parts it in two.
enum class Ends : std::uint8_t { at_wall, at_all_things };

bool is_obstacle(std::uint8_t what, Ends ends) {
  return what == kSolid || what == kRelief || (what == kBlocked && ends == Ends::at_all_things);
}

// What the points of one station show about a hole.
struct HoleView {
  std::array<double, 4> beside{};  // rays on the wall beside each of kSides
  std::array<double, 4> fired{};   // rays beside each of kSides, whatever they met
  double behind = 0;               // rays that ended in it behind the wall
  std::vector<bool> stopped;       // per cell of its box: a ray through it ended before the wall
};

struct ViewedHole {
  WallHole hole;
  Box2 box;  // metres
  std::map<SiteStation, HoleView> views;
  std::vector<bool> inside;  // per cell of the box: it belongs to the hole
  double wall = 0;           // cells of the wall around it
  std::vector<bool> behind;  // per cell of the box: a ray through it ended behind the wall
};

// The side of a box beside which a place is; none for places inside and beyond the corners.
std::optional<Side> side_beside(const Box2& box, Place2 p) {
  const bool in_u = p.u >= box.u0 && p.u < box.u1, in_v = p.v >= box.v0 && p.v < box.v1;
  if (in_u == in_v) return std::nullopt;
  if (in_v) return p.u < box.u0 ? Side::left : Side::right;
  return p.v < box.v0 ? Side::bottom : Side::top;
}

std::size_t cell_in(const ViewedHole& h, Place2 p, double cell) {
  const auto part = [&](double at, std::int64_t most) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(at / cell), 0, most - 1);
  };
  return static_cast<std::size_t>(part(p.v - h.box.v0, h.hole.box.rows()) * h.hole.box.columns() +
                                  part(p.u - h.box.u0, h.hole.box.columns()));
}

// Notes what a ray shows: that its station saw the wall beside the hole, or what became of it in the hole.
void note(const FacadeSite& site, const Ray& ray, bool on_wall, Place2 p, double cell, ViewedHole& h) {
  const double w = ray.at.w;
  const bool flat = on_wall || (w > 0 && w <= kFlatRelief);
  if (const std::optional<Side> side = side_beside(h.box, p)) {
    HoleView& view = h.views[ray.station];
    view.fired[static_cast<std::size_t>(*side)] += 1;
    if (flat) ++view.beside[static_cast<std::size_t>(*side)];
    return;
  }
  if (!h.box.contains(p)) return;
  const std::size_t at = cell_in(h, p, cell);
  HoleView& view = h.views[ray.station];
  if (view.stopped.empty()) view.stopped.assign(h.inside.size(), false);
  if (w > site.epsilon) view.stopped[at] = true;
  if (w >= -site.epsilon || on_wall || !h.inside[at]) return;
  ++view.behind;
  h.behind[at] = true;
}

void look_near(const RaySamples& samples, double cell, ViewedHole& h) {
  const Box2 around = h.box.grown(kRing);
  for (const Ray& ray : samples.near(around)) {
    if (samples.oblique() ? samples.eye_of(ray) == nullptr : ray.station != kNoStation) continue;
    const Place2 p = samples.crossing(ray, 0);
    if (around.contains(p)) note(samples.site(), ray, samples.on_wall(ray), p, cell, h);
  }
}

// Marks cells behind points that lie farther before the wall than its own points reach, and returns how many points
// lie about each station.
std::vector<std::uint64_t> look_far(const RaySamples& samples, double cell, std::vector<ViewedHole>& holes) {
  const std::vector<FacadeStation>& stations = samples.site().stations;
  std::vector<std::uint64_t> about(stations.size(), 0);
  if (stations.empty()) return about;
  std::vector<SpaceBox> boxes;
  for (const FacadeStation& s : stations) {
    SpaceBox& box = boxes.emplace_back(SpaceBox{{s.position.x - kBareDisc, s.position.y - kBareDisc, 0},
                                                {s.position.x + kBareDisc, s.position.y + kBareDisc, s.position.z}});
    for (const ViewedHole& h : holes) {
      box.low = {std::min(box.low.x, h.box.u0), std::min(box.low.y, h.box.v0), 0};
      box.high = {std::max(box.high.x, h.box.u1), std::max(box.high.y, h.box.v1), s.position.z};
    }
  }
  const auto mark = [&](const FacadePoint& p, SiteStation station) {
    const Vec3& eye = stations[station].position;
    if (p.w >= eye.z) return;
    const double to_eye = std::max(std::abs(p.u - eye.x), std::abs(p.w - eye.z));
    about[station] += to_eye <= kBareDisc;
    const double on = eye.z / (eye.z - static_cast<double>(p.w));
    const Place2 at{eye.x + (p.u - eye.x) * on, eye.y + (p.v - eye.y) * on};
    for (ViewedHole& h : holes) {
      if (!h.box.contains(at)) continue;
      const auto view = h.views.find(station);
      if (view == h.views.end()) continue;
      if (view->second.stopped.empty()) view->second.stopped.assign(h.inside.size(), false);
      view->second.stopped[cell_in(h, at, cell)] = true;
    }
  };
  samples.far_points(boxes, [&](std::span<const FacadePoint> points, std::span<const SiteStation> from) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SiteStation known = from.empty() ? kStationUnknown : from[i];
      if (known == kStationNotInFront) continue;
      if (known != kStationUnknown) {
        mark(points[i], static_cast<SiteStation>(known - 1));
        continue;
      }
      for (std::size_t s = 0; s < stations.size(); ++s) mark(points[i], static_cast<SiteStation>(s));
    }
  });
  return about;
}

// The share of the rays through a hole that ended before it. Where a station's rays are rarer than cells, not every
// cell that is hidden from it has a point before it.
double stopped_share(const ViewedHole& h, const HoleView& view, double rays_a_cell) {
  double stopped = 0, all = 0;
  for (std::size_t i = 0; i < h.inside.size(); ++i) {
    all += h.inside[i];
    stopped += h.inside[i] && !view.stopped.empty() && view.stopped[i];
  }
  return all > 0 ? stopped / all / (1 - natural_exp(-rays_a_cell)) : 1;
}

bool crosses(const ViewedHole& h, const HoleView& view, double cell) {
  double on_wall = 0;
  for (const double n : view.beside) on_wall += n;
  if (h.wall == 0 || on_wall == 0) return false;
  const double rays_a_cell = on_wall / h.wall;
  if (rays_a_cell * static_cast<double>(h.hole.region.cells.size()) < kLeastRays) return false;
  const double strip = kRing / cell;
  for (const Side side : kSides) {
    if (side == Side::bottom && h.box.v0 < kFoot) continue;
    const bool upright = side == Side::left || side == Side::right;
    const auto along = static_cast<double>(upright ? h.hole.box.rows() : h.hole.box.columns());
    if (view.fired[static_cast<std::size_t>(side)] < kBeside * rays_a_cell * strip * along) return false;
  }
  return stopped_share(h, view, rays_a_cell) <= kMostStopped;
}

// Sets whether rays crossed a hole, and which part of it.
void set_crossed(std::span<const std::uint64_t> about, double cell, ViewedHole& h) {
  int crossing = 0;
  double behind = 0, expected = 0;
  bool known = false;
  for (const auto& [station, view] : h.views) {
    behind += view.behind;
    if (!crosses(h, view, cell)) continue;
    double on_wall = 0;
    for (const double n : view.beside) on_wall += n;
    expected += on_wall / h.wall * static_cast<double>(h.hole.region.cells.size());
    known |= !about.empty() && about[station] >= kGround;
    ++crossing;
  }
  const bool by_station = crossing > 0 && (known || crossing > 1);
  h.hole.crossed = by_station || (crossing > 0 && behind >= std::max(kFewestBehind, kLeastBehind * expected));
  h.hole.open = crossing > 0;
  if (h.hole.crossed && !by_station) h.hole.shown = shown_part(h.hole.box, h.behind, cell);
}

// The hole of a region, with what is around it; no result if it ends where the wall ends or is mostly seen.
std::optional<ViewedHole> viewed_hole(const WallCells& cells, CellRegion region, double least_empty) {
  ViewedHole h;
  CellBox all{INT64_MAX, -1, INT64_MAX, -1};
  std::size_t empty = 0, hidden = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % cells.columns, r = i / cells.columns;
    all = {std::min(all.c0, c), std::max(all.c1, c), std::min(all.r0, r), std::max(all.r1, r)};
    const std::uint8_t what = cells.what[static_cast<std::size_t>(i)];
    empty += what == kUnknown, hidden += what == kBlocked;
  }
  const auto count = static_cast<double>(region.cells.size());
  const bool opening = least_empty > 0;  // what was not seen may go on beyond the end of the wall
  if (opening && (all.c0 == 0 || all.c1 + 2 >= cells.columns)) return std::nullopt;
  if (all.r1 + 2 >= cells.rows) return std::nullopt;
  if (static_cast<double>(empty) < least_empty * count) return std::nullopt;
  if (static_cast<double>(empty + hidden) < kLeastEmpty * count) return std::nullopt;
  if (count > kMostOfWall * static_cast<double>(cells.what.size())) return std::nullopt;
  h.hole.box = box_of(region, cells.columns);
  h.box = box_in_metres(h.hole.box, cells.cell);
  h.inside.assign(static_cast<std::size_t>(h.hole.box.columns() * h.hole.box.rows()), false);
  h.behind.assign(h.inside.size(), false);
  double filled = 0;
  for (const std::int64_t i : region.cells) {
    const std::int64_t c = i % cells.columns - h.hole.box.c0, r = i / cells.columns - h.hole.box.r0;
    if (c < 0 || r < 0 || c >= h.hole.box.columns() || r >= h.hole.box.rows()) continue;
    h.inside[static_cast<std::size_t>(r * h.hole.box.columns() + c)] = true;
    ++filled;
  }
  h.hole.empty = 2 * empty > region.cells.size();
  const auto within = static_cast<double>(h.inside.size());
  h.hole.straight =
      (filled >= kStraightFill * within && straight_share(region, h.hole.box, cells.columns) >= kStraight) ||
      (filled >= kArchFill * within && has_arched_top(region, h.hole.box, cells.columns));
  h.hole.region = std::move(region);
  return h;
}

// Counts the cells of the wall beside the sides of a hole.
void count_wall(const WallCells& cells, ViewedHole& h) {
  const auto reach = static_cast<std::int64_t>(kRing / cells.cell) + 1;
  const CellBox& box = h.hole.box;
  for (std::int64_t r = std::max<std::int64_t>(0, box.r0 - reach); r <= std::min(cells.rows - 1, box.r1 + reach); ++r)
    for (std::int64_t c = std::max<std::int64_t>(0, box.c0 - reach); c <= std::min(cells.columns - 1, box.c1 + reach);
         ++c) {
      const Place2 middle{(static_cast<double>(c) + 0.5) * cells.cell, (static_cast<double>(r) + 0.5) * cells.cell};
      const std::uint8_t what = cells.at(c, r);
      h.wall +=
          (what == kSolid || what == kRelief) && h.box.grown(kRing).contains(middle) && side_beside(h.box, middle);
    }
}

std::vector<ViewedHole> viewed_holes(const WallCells& cells, const std::vector<bool>& taken, double least_size,
                                     Ends ends, double least_empty) {
  const auto side = std::max<std::int64_t>(3, std::llround(kSquare * least_size / cells.cell));
  std::vector<bool> obstacles(cells.what.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i) obstacles[i] = is_obstacle(cells.what[i], ends);
  const std::vector<bool> open = covered_by_squares(cells, obstacles, side, kStray);
  std::vector<ViewedHole> viewed;
  for_each_region(
      cells, [&](std::size_t i) { return open[i] && !taken[i]; },
      [&](CellRegion region) {
        if (std::optional<ViewedHole> h = viewed_hole(cells, std::move(region), least_empty))
          viewed.push_back(std::move(*h));
      });
  return viewed;
}

// Finds which holes rays crossed.
void look(const RaySamples& samples, const WallCells& cells, std::vector<ViewedHole>& holes) {
  if (holes.empty()) return;
  for (ViewedHole& h : holes) count_wall(cells, h), look_near(samples, cells.cell, h);
  const std::vector<std::uint64_t> about = look_far(samples, cells.cell, holes);
  for (ViewedHole& h : holes) set_crossed(about, cells.cell, h);
}

// Finds which holes rays crossed that only bars divide: all panes of a window, where they crossed it as a whole.
void look_over_bars(const RaySamples& samples, const WallCells& cells, std::vector<ViewedHole>& viewed) {
  std::vector<WallHole> panes;
  for (const ViewedHole& h : viewed) panes.push_back(h.hole);
  std::vector<ViewedHole> windows;
  for (CellRegion& region : regions_over_bars(panes, cells))
    if (std::optional<ViewedHole> h = viewed_hole(cells, std::move(region), kLeastEmpty))
      windows.push_back(std::move(*h));
  look(samples, cells, windows);
  std::vector<bool> crossed(cells.what.size(), false);
  for (const ViewedHole& w : windows)
    if (w.hole.crossed && w.hole.straight)
      for (const std::uint32_t i : w.hole.region.cells) crossed[i] = true;
  for (ViewedHole& h : viewed) h.hole.crossed |= crossed[h.hole.region.cells.front()];
}

}  // namespace

std::vector<WallHole> find_holes(const RaySamples& samples, const WallCells& cells, double least_size,
                                 std::vector<WallHole>* open) {
  std::vector<WallHole> holes;
  std::vector<bool> taken(cells.what.size(), false), listed(taken);
  const auto list = [&](const WallHole& hole) {
    if (open == nullptr || !hole.open || !hole.straight || !hole.empty || listed[hole.region.cells.front()]) return;
    for (const std::uint32_t i : hole.region.cells) listed[i] = true;
    open->push_back(hole);
  };
  // Openings first, whole; then what something before them leaves of them. What stays was not seen.
  for (const Ends ends : {Ends::at_wall, Ends::at_all_things}) {
    std::vector<ViewedHole> viewed = viewed_holes(cells, taken, least_size, ends, kLeastEmpty);
    look(samples, cells, viewed);
    look_over_bars(samples, cells, viewed);
    for (ViewedHole& h : viewed) {
      if (!h.hole.crossed || !h.hole.straight) {
        list(h.hole);
        continue;
      }
      for (const std::uint32_t i : h.hole.region.cells) taken[i] = true;
      holes.push_back(std::move(h.hole));
    }
  }
  for (ViewedHole& h : viewed_holes(cells, taken, least_size, Ends::at_wall, 0)) holes.push_back(std::move(h.hole));
  return holes;
}

UnseenArea area_of(const WallHole& hole, const WallCells& cells) {
  UnseenArea area;
  area.straight = hole.straight && hole.empty;
  area.error = cells.cell;
  const Box2 box = box_in_metres(hole.box, cells.cell);
  if (area.straight) {
    area.ring = {{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}};
    return area;
  }
  // Follows the border of the region with the region on the left. Its first cell is in its lowest row, so the way
  // along the lower side of that cell belongs to the outer ring.
  std::vector<std::uint32_t> sorted = hole.region.cells;
  std::sort(sorted.begin(), sorted.end());
  const auto holds = [&](std::int64_t c, std::int64_t r) {
    return c >= 0 && r >= 0 && c < cells.columns && r < cells.rows &&
           std::binary_search(sorted.begin(), sorted.end(), static_cast<std::uint32_t>(r * cells.columns + c));
  };
  const std::int64_t first_c = sorted[0] % cells.columns, first_r = sorted[0] / cells.columns;
  std::int64_t c = first_c, r = first_r, dc = 1, dr = 0;  // a corner of cells, and the direction from there
  do {
    const std::int64_t turn_c = -dr, turn_r = dc;  // to the left
    const auto is_inside = [&](std::int64_t ac, std::int64_t ar, std::int64_t bc, std::int64_t br) {
      // The cell ahead of the corner that lies between the directions a and b.
      return holds(c + (ac + bc < 0 ? -1 : 0), r + (ar + br < 0 ? -1 : 0));
    };
    c += dc, r += dr;
    if (!is_inside(dc, dr, turn_c, turn_r)) {  // nothing ahead on the left: turn left about the last cell
      area.ring.push_back({static_cast<double>(c) * cells.cell, static_cast<double>(r) * cells.cell});
      dc = turn_c, dr = turn_r;
    } else if (is_inside(dc, dr, -turn_c, -turn_r)) {  // the region is on both sides: turn right
      area.ring.push_back({static_cast<double>(c) * cells.cell, static_cast<double>(r) * cells.cell});
      dc = -turn_c, dr = -turn_r;
    }
  } while (c != first_c || r != first_r);
  return area;
}

}  // namespace ilot
