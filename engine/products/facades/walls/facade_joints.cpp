// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/facade_joints.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/walls/box_grid.h"

#include "engine/products/facades/walls/side_faces.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: walls out of line by more form a corner.
constexpr double kParallelWallsDeg = 5;
// Derived: a majority.
constexpr double kOver = 0.5;  // share of the narrower wall that is above or below the other one
// Derived: a majority.
constexpr double kSameHeight = 0.5;  // share of the lower wall that is beside the other one at a corner

FacadeElement* outline_of(Facade& facade) {
  const auto at = std::find_if(facade.elements.begin(), facade.elements.end(), [](const FacadeElement& e) {
    return e.region == FacadeRegion::facade && e.ring.size() >= 4;
  });
  return at == facade.elements.end() ? nullptr : &*at;
}

// The lower and upper corner at an end: outlines begin with their lower left and lower right corners (wall_outline.h).
struct EndCorners {
  std::size_t low, high;
};
EndCorners end_of(const FacadeElement& outline, bool left) {
  return left ? EndCorners{0, outline.ring.size() - 1} : EndCorners{1, 2};
}

// u, v and w of a place, in metres.
Vec3 local(const Facade& f, Vec3 place, double metres) {
  const Vec3 d = metres * (place - f.origin);
  return {dot(d, f.right), dot(d, f.up), dot(d, f.out)};
}

Box2 box_of(const Facade& f, const FacadeElement& e, double metres) {
  Box2 box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const Vec3& p : e.ring) {
    const Vec3 q = local(f, p, metres);
    box = {std::min(box.u0, q.x), std::max(box.u1, q.x), std::min(box.v0, q.y), std::max(box.v1, q.y)};
  }
  return box;
}

// The distance in metres along the wall from a place on it to the plane of another facade.
double way_to(const Facade& from, Vec3 place, const Facade& to, double metres) {
  return dot(to.origin - place, to.out) / dot(from.right, to.out) * metres;
}

// The rise of the top per metre to the right, at an end of the wall.
double rise_at(const Facade& f, const FacadeElement& outline, bool left) {
  const std::size_t high = end_of(outline, left).high, next = left ? high - 1 : high + 1;
  const Vec3 along = outline.ring[next] - outline.ring[high];
  const double across = dot(along, f.right);
  return outline.edges.empty() || across == 0 ? 0 : dot(along, f.up) / across;
}

// Choice: a cell has a few walls; time alone depends on it. The rounding is that of coordinates in millimetres.
constexpr double kOutlineCell = 16, kRounding = 0.001;  // metres

// The box of an outline on the ground, in CRS units. It is grown by `reach` (metres) and by the sideways extent of a
// leaning wall.
FlatBox ground_of(const Facade& f, const FacadeElement& outline, double reach, double metres) {
  FlatBox box = FlatBox::none();
  for (const Vec3& p : outline.ring) box.add({p.x, p.y});
  const double height = box_of(f, outline, metres).height() / metres;
  const double lean = std::sqrt(f.up.x * f.up.x + f.up.y * f.up.y);
  return box.grown(lean * height + reach / metres);
}

// Finds outlines by place; it is updated while they move.
class OutlineGrid {
 public:
  OutlineGrid(std::vector<Facade>& facades, double metres) : metres_(metres), grid_(kOutlineCell / metres) {
    for (std::size_t i = 0; i < facades.size(); ++i) add(facades, i);
  }
  void add(std::vector<Facade>& facades, std::size_t i) {
    const FacadeElement* outline = outline_of(facades[i]);
    if (outline == nullptr) return;
    const FlatBox box = ground_of(facades[i], *outline, 0, metres_);
    grid_.add(static_cast<std::uint32_t>(i), box);
    lean_ = std::max(lean_, std::sqrt(facades[i].up.x * facades[i].up.x + facades[i].up.y * facades[i].up.y));
  }
  std::vector<std::uint32_t> near(const FlatBox& box) const { return grid_.near(box); }
  double lean() const { return lean_; }  // of the wall that leans most: metres sideways per metre of height

 private:
  double metres_, lean_ = 0;
  BoxGrid grid_;
};

struct Meeting {
  double way = INFINITY;  // metres by which the end moves
  std::size_t other = 0;  // the facade that it meets
};

// The facade that the left (or right) end of one facade meets.
Meeting meeting_of(std::vector<Facade>& facades, const OutlineGrid& grid, std::size_t own, bool left,
                   const JointParams& params) {
  Meeting nearest;
  Facade& f = facades[own];
  const FacadeElement* outline = outline_of(f);
  const double m = params.metres_per_unit, least = cos_degrees(90 - params.least_turn_deg);
  const EndCorners end = end_of(*outline, left);
  const Vec3 low = outline->ring[end.low], high = outline->ring[end.high];
  // The line is within `reach` of the end and of the other outline, except for the lean of the walls between their
  // heights.
  FlatBox around = FlatBox::none();
  around.add({low.x, low.y}), around.add({high.x, high.y});
  around = around.grown((2 * params.reach + kRounding) / m + grid.lean() * norm(high - low));
  for (const std::size_t o : grid.near(around)) {
    FacadeElement* other = o == own ? nullptr : outline_of(facades[o]);
    if (other == nullptr || std::abs(dot(f.right, facades[o].out)) < least) continue;
    const Vec3 middle = 0.5 * (low + high);
    const double way = way_to(f, middle, facades[o], m);
    if (std::abs(way) > params.reach || std::abs(way) >= std::abs(nearest.way)) continue;
    const Vec3 line = local(facades[o], middle + (way / m) * f.right, m);
    const Box2 box = box_of(facades[o], *other, m);
    const double own_low = local(facades[o], low, m).y, own_high = local(facades[o], high, m).y;
    const double common = std::min(own_high, box.v1) - std::max(own_low, box.v0);
    const bool beside = common >= kSameHeight * std::min(own_high - own_low, box.height());
    if (line.x < box.u0 - params.reach || line.x > box.u1 + params.reach || !beside) continue;
    nearest = {way, o};
  }
  return nearest;
}

void begin_at_left_end(Facade& f, const FacadeElement& outline, double metres) {
  const Box2 box = box_of(f, outline, metres);
  f.origin = f.origin + (box.u0 / metres) * f.right + (box.v0 / metres) * f.up;
  f.width_m = box.width();
  f.height_m = box.height();
}

// Finds corners by place; it is updated while they move.
class CornerGrid {
 public:
  CornerGrid(const std::vector<Vec3*>& corners, double metres) : corners_(corners), reach_(1 / metres), grid_(reach_) {
    for (std::size_t i = 0; i < corners.size(); ++i) add(i);
  }
  void add(std::size_t i) { grid_.add(static_cast<std::uint32_t>(i), ground_of(i)); }
  // The first corner after `behind` that may be near another one; the number of corners if there is none.
  std::size_t next(std::size_t i, std::size_t behind) const {
    const std::vector<std::uint32_t> near = grid_.near(ground_of(i).grown(reach_));
    const auto at = std::upper_bound(near.begin(), near.end(), behind);
    return at == near.end() ? corners_.size() : *at;
  }

 private:
  FlatBox ground_of(std::size_t i) const {
    FlatBox box = FlatBox::none();
    box.add({corners_[i]->x, corners_[i]->y});
    return box;
  }
  const std::vector<Vec3*>& corners_;
  double reach_;  // one metre, in CRS units
  BoxGrid grid_;
};

// Joins corners of two outlines on one line whose only difference is in height, at most `reach`.
void join_heights(std::vector<Facade>& facades, double reach, double metres) {
  // Choice: twice the error of a corner of 1 cm.
  constexpr double kOnLine = 0.02;  // metres; lines in which walls meet are vertical within this distance
  std::vector<Vec3*> corners;
  for (Facade& f : facades)
    if (FacadeElement* outline = outline_of(f))
      for (const bool left : {true, false}) {
        const EndCorners end = end_of(*outline, left);
        corners.push_back(&outline->ring[end.low]);
        corners.push_back(&outline->ring[end.high]);
      }
  CornerGrid grid(corners, metres);
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = grid.next(a, a); b < corners.size(); b = grid.next(a, b)) {
      const Vec3 apart = metres * (*corners[b] - *corners[a]);
      if (apart.x * apart.x + apart.y * apart.y > kOnLine * kOnLine || std::abs(apart.z) > reach) continue;
      const Vec3 middle = 0.5 * (*corners[a] + *corners[b]);
      *corners[a] = *corners[b] = middle;
      grid.add(a), grid.add(b);
    }
}

FacadeElement step_of(const Facade& wall, const FacadeElement& outline, double depth, double m) {
  FacadeElement e;
  e.kind = depth > 0 ? "protrusion" : "recess";
  e.id = static_cast<std::uint32_t>(wall.elements.size() + 1);
  const Box2 box = box_of(wall, outline, m);
  const auto place = [&](double u, double v) { return wall.origin + (u / m) * wall.right + (v / m) * wall.up; };
  if (outline.edges.empty()) {  // a rectangle
    e.ring = {place(box.u0, box.v0), place(box.u1, box.v0), place(box.u1, box.v1), place(box.u0, box.v1)};
    for (std::size_t i = 0; i < e.ring.size(); ++i)
      e.edges.push_back({DrawnStatus::seen, 0, 0, i % 2 == 0 ? outline.height_error_m : outline.width_error_m, 0});
  } else {
    e.edges = outline.edges;
    for (const Vec3& p : outline.ring) {
      const Vec3 at = local(wall, p, m);
      e.ring.push_back(place(at.x, at.y));
    }
  }
  e.width_m = box.width();
  e.height_m = box.height();
  e.depth_m = depth;
  e.width_error_m = outline.width_error_m;
  e.height_error_m = outline.height_error_m;
  e.depth_error_m = outline.depth_error_m;
  e.points = outline.points;
  if (!outline.edges.empty()) return e;  // the ring and the depth contain everything
  FacadeSite site;
  site.axes = {wall.origin, wall.right, wall.up, wall.out};
  site.metres_per_unit = m;
  e.body = body_between(site, box, 0, box, depth);
  return e;
}

// The distance by which `part` stands before `wall`, if it is a storey of the same front; otherwise 0.
double step_between(const Facade& wall, const Box2& own, const Facade& part, const FacadeElement& outline,
                    const JointParams& params) {
  const double m = params.metres_per_unit;
  if (dot(wall.out, part.out) < cos_degrees(kParallelWallsDeg)) return 0;
  const Box2 box = box_of(wall, outline, m);
  const double depth = local(wall, 0.5 * (outline.ring[0] + outline.ring[2]), m).z;
  if (std::abs(depth) < params.least_step || std::abs(depth) > params.most_step) return 0;
  const double over = std::min(own.u1, box.u1) - std::max(own.u0, box.u0);
  const double gap = std::max(own.v0, box.v0) - std::min(own.v1, box.v1);
  return over >= kOver * std::min(own.width(), box.width()) && std::abs(gap) <= params.reach ? depth : 0;
}

}  // namespace

void close_corners(std::vector<Facade>& facades, const JointParams& params) {
  OutlineGrid grid(facades, params.metres_per_unit);
  for (std::size_t i = 0; i < facades.size(); ++i) {
    if (outline_of(facades[i]) == nullptr) continue;
    for (const bool left : {true, false}) {
      const Meeting met = meeting_of(facades, grid, i, left, params);
      if (!std::isfinite(met.way)) continue;
      FacadeElement* outline = outline_of(facades[i]);
      // The two ends of the side are moved separately: the line may lean as much as the walls do.
      const EndCorners end = end_of(*outline, left);
      for (const std::size_t corner : {end.low, end.high}) {
        const double m = params.metres_per_unit;
        const Vec3 p = outline->ring[corner];
        const double way = way_to(facades[i], p, facades[met.other], m) / m;
        outline->ring[corner] =
            p +
            way * (facades[i].right + (corner == end.high ? rise_at(facades[i], *outline, left) : 0.0) * facades[i].up);
      }
      grid.add(facades, i);
    }
  }
  join_heights(facades, params.reach, params.metres_per_unit);
  for (Facade& f : facades)
    if (FacadeElement* outline = outline_of(f)) {
      const Box2 box = box_of(f, *outline, params.metres_per_unit);
      outline->width_m = box.width();
      outline->height_m = box.height();
      begin_at_left_end(f, *outline, params.metres_per_unit);
    }
}

void add_storey_steps(std::vector<Facade>& facades, const JointParams& params) {
  const double m = params.metres_per_unit;
  // The directions of two facades of one front differ by a slope of less than a tenth. Therefore one of them may come
  // nearer by a tenth of its length.
  // Derived: see above: walls of one front differ by a slope of less than a tenth.
  constexpr double kApart = 0.1;
  BoxGrid grid(kOutlineCell / m);
  const auto ground = [&](std::size_t i, const FacadeElement& outline) {
    const Box2 box = box_of(facades[i], outline, m);
    return ground_of(facades[i], outline, kApart * (box.width() + box.height()), m);
  };
  for (std::size_t i = 0; i < facades.size(); ++i)
    if (const FacadeElement* outline = outline_of(facades[i]))
      grid.add(static_cast<std::uint32_t>(i), ground(i, *outline));
  for (std::size_t i = 0; i < facades.size(); ++i) {
    FacadeElement* own = outline_of(facades[i]);
    if (own == nullptr) continue;
    for (const std::size_t k : grid.near(ground(i, *own).grown((params.most_step + params.reach + kRounding) / m))) {
      own = outline_of(facades[i]);  // elements may have moved in memory when one was added
      FacadeElement* other = outline_of(facades[k]);
      if (i == k) continue;
      const Box2 box = box_of(facades[i], *own, m), part = box_of(facades[k], *other, m);
      const double area = box.width() * box.height(), smaller = part.width() * part.height();
      if (smaller > area || (smaller == area && k < i)) continue;
      const double depth = step_between(facades[i], box, facades[k], *other, params);
      if (depth == 0) continue;
      FacadeElement step = step_of(facades[i], *other, depth, m);
      facades[i].elements.push_back(std::move(step));
    }
  }
}

}  // namespace ilot
