// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/wall_reach.h"

#include <algorithm>
#include <utility>

#include "engine/pass/pass.h"
#include "engine/products/facades/walls/wall_growth.h"

namespace ilot {
namespace {

// Choice: at three times the distance to its planes a wall has a tenth of their density.
constexpr double kGrowthReach = 12;  // metres
// Choice: half of a wide window: one that a border cuts is whole in one of two parts.
constexpr double kAroundPart = 1.5;  // metres of the wall around a part in which openings are searched too

// The wall and the room around it.
WallGroup with_room(const WallGroup& wall, const GrowthRoom& room, double metres) {
  WallGroup grown = wall;
  grown.axes.origin = wall.axes.origin - (room.left / metres) * wall.axes.right;
  grown.width = room.left + wall.width + room.right;
  grown.height = wall.height + room.top;
  grown.above = 0;
  return grown;
}

void move_opening(double u, double v, FoundRectangle& r) {
  for (const Side side : kSides) {
    const double by = side == Side::left || side == Side::right ? u : v;
    r.side(side).at += by, r.side(side).inner += by;
  }
  if (r.arc) r.arc->centre = {r.arc->centre.u + u, r.arc->centre.v + v};
  if (r.end) r.end = Box2{r.end->u0 + u, r.end->u1 + u, r.end->v0 + v, r.end->v1 + v};
}

// Where points are sparse, cells without a point hide a narrow pier or a floor between openings, but some points of the
// wall are on it. Cuts an opening at such points; a piece without room for an opening is dropped.
std::vector<FoundRectangle> cut_at_wall(const RaySamples& samples, const FoundRectangle& r, double least_size) {
  // Choice: a frame in the plane of the wall is at the sides; an edge is known to so much where it is seen.
  constexpr double kInside = 0.1;  // metres from the sides
  const Box2 box = r.box(), inner{box.u0 + kInside + r.error(Side::left), box.u1 - kInside - r.error(Side::right),
                                  box.v0 + kInside + r.error(Side::bottom), box.v1 - kInside - r.error(Side::top)};
  std::vector<double> wall, open;
  for (const Ray& ray : samples.near(box)) {
    const Place2 p = samples.crossing(ray, 0);
    if (samples.on_wall(ray) && inner.contains(p)) wall.push_back(p.u);
    if (!samples.on_wall(ray) && ray.at.w < 0 && box.contains(p)) open.push_back(p.u);
  }
  if (wall.empty() || !r.is_rectangle()) return {r};
  std::sort(wall.begin(), wall.end()), std::sort(open.begin(), open.end());
  std::vector<FoundRectangle> pieces;
  FoundRectangle rest = r;
  const auto take = [&](FoundRectangle piece) {
    if (piece.box().width() >= least_size) pieces.push_back(std::move(piece));
  };
  for (std::size_t i = 0; i < wall.size();) {
    std::size_t k = i;  // points of one pier: between them there is no room for an opening
    while (k + 1 < wall.size() && wall[k + 1] - wall[k] < least_size) ++k;
    if (k == i) {  // one point may be stray
      ++i;
      continue;
    }
    const auto after = std::upper_bound(open.begin(), open.end(), wall[k]);
    const auto before = std::lower_bound(open.begin(), open.end(), wall[i]);
    const auto edge = [&](double wall_at, double open_at) {
      LocatedEdge e;
      e.at = e.inner = (wall_at + open_at) / 2;
      e.error = std::abs(wall_at - open_at) / 2 + samples.site().step;
      return e;
    };
    FoundRectangle piece = rest;
    piece.side(Side::right) = edge(wall[i], before == open.begin() ? wall[i] : *(before - 1));
    take(std::move(piece));
    rest.side(Side::left) = edge(wall[k], after == open.end() ? wall[k] : *after);
    i = k + 1;
  }
  take(std::move(rest));
  return pieces;
}

// An opening may be found in two parts.
void add_new(std::vector<FoundRectangle>&& found, std::vector<FoundRectangle>& openings) {
  for (FoundRectangle& r : found)
    if (!shares_area(r.box(), openings)) openings.push_back(std::move(r));
}

}  // namespace

void find_sparse_parts(const FacadeWork& work, std::span<WallGroup> walls, const WallParams& params,
                       const PassContext& context) {
  const std::vector<GrowthRoom> rooms = growth_rooms(walls, kGrowthReach, params);
  std::vector<PassTask> tasks;
  const auto around = [&](std::size_t i) {
    FacadeWork own{work.store, work.final_id, {}, {}};
    own.metres_per_unit = work.metres_per_unit;
    own.beside = 0;
    own.before = own.behind = WallGrowth::depth(epsilon_of(walls[i]));
    return own;
  };
  for (std::size_t i = 0; i < walls.size(); ++i)
    tasks.push_back({WallGrowth::bytes(walls[i].width, walls[i].height, rooms[i], epsilon_of(walls[i])),
                     points_to_read(around(i), with_room(walls[i], rooms[i], work.metres_per_unit))});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    WallGroup& wall = walls[i];
    WallGrowth growth(wall.width, wall.height, rooms[i], epsilon_of(wall));
    const FacadeWork own = around(i);
    gather_facade(own, with_room(wall, rooms[i], work.metres_per_unit))
        .points([&](std::span<const FacadePoint> points, std::span<const SiteStation>) {
          for (FacadePoint p : points) {
            p.u -= static_cast<float>(rooms[i].left);
            growth.add(p);
          }
        });
    wall.sparse = growth.parts();
  });
  share_growth(walls, kGrowthReach, params);
}

WallGroup group_of_part(const WallGroup& wall, const SparsePart& part, double metres_per_unit) {
  const Box2 whole = grown_box(wall);
  const Box2 box{std::max(whole.u0, part.u0 - kAroundPart), std::min(whole.u1, part.u1 + kAroundPart),
                 std::max(whole.v0, part.v0 - kAroundPart), std::min(whole.v1, part.v1 + kAroundPart)};
  WallGroup group = wall;
  group.sparse.clear();
  // The plane through the ends of the part.
  const double length = part.upright ? part.u1 - part.u0 : part.v1 - part.v0;
  const double slope = length > 0 ? (part.w1 - part.w0) / length : 0;
  const double w = part.w0 + slope * (part.upright ? box.u0 - part.u0 : box.v0 - part.v0);
  FacadeAxes& axes = group.axes;
  axes.origin = wall.axes.origin + (1 / metres_per_unit) * (box.u0 * axes.right + box.v0 * axes.up + w * axes.out);
  Vec3& along = part.upright ? axes.right : axes.up;
  along = along + slope * wall.axes.out;
  along = (1 / norm(along)) * along;
  axes.out = cross(axes.right, axes.up);
  group.width = box.width(), group.height = box.height(), group.above = 0;
  // Derived: the step of a site is the root of the area of a point.
  group.points = 1, group.area_m2 = part.step * part.step;
  return group;
}

std::uint64_t bytes_of_sparse_parts(const FacadeWork& work, const WallGroup& wall) {
  std::uint64_t most = 0;
  for (const SparsePart& part : wall.sparse) {
    const WallGroup group = group_of_part(wall, part, work.metres_per_unit);
    most = std::max(most, facade_bytes(gather_facade(work, group).site, points_to_read(work, group), 1));
  }
  return most;
}

SparseFindings sparse_findings(const FacadeWork& work, const WallGroup& wall, const OpeningParams& params) {
  SparseFindings all;
  all.box = grown_box(wall);
  bool goes_up = false;
  for (const SparsePart& part : wall.sparse) {
    const GatheredFacade gathered = gather_facade(work, group_of_part(wall, part, work.metres_per_unit));
    const RaySamples samples(gathered.site, gathered.points, {work.store.folder()}, gathered.far);
    std::vector<UnseenArea> unseen;
    const std::vector<FoundRectangle> found = find_openings(samples, params, nullptr, &unseen);
    const double units = work.metres_per_unit;
    const Vec3 from = units * (gathered.site.axes.origin - wall.axes.origin);
    const double u = dot(from, wall.axes.right), v = dot(from, wall.axes.up);
    std::vector<FoundRectangle> pieces;
    for (const FoundRectangle& r : found)
      for (FoundRectangle& piece : cut_at_wall(samples, r, params.least_size)) pieces.push_back(std::move(piece));
    for (FoundRectangle& r : pieces) move_opening(u, v, r);
    add_new(std::move(pieces), all.openings);
    for (UnseenArea& area : unseen) {
      for (Place2& p : area.ring) p = {p.u + u, p.v + v};
      const Box2 box = box_of(area.ring);
      const Place2 middle{(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2};
      if (Box2{part.u0, part.u1, part.v0, part.v1}.contains(middle)) all.unseen.push_back(std::move(area));
    }
    if (part.upright)
      for (SparseColumn& c : sparse_columns(samples, part.u0 - u, part.u1 - u))
        all.columns.push_back({c.u0 + u, c.u1 + u, c.top + v});
    goes_up |= !part.upright;
    all.step = std::max(all.step, part.step);
  }
  if (goes_up) all.columns.clear();
  return all;
}

void include_sparse_parts(WallGroup& wall, double metres_per_unit) {
  const Box2 box = grown_box(wall);
  wall.axes.origin = wall.axes.origin + (box.u0 / metres_per_unit) * wall.axes.right;
  wall.core0 -= box.u0, wall.core1 -= box.u0;
  wall.above = std::max(0.0, wall.above - (box.v1 - wall.height));
  wall.width = box.width(), wall.height = box.v1;
  wall.sparse.clear();
}

}  // namespace ilot
