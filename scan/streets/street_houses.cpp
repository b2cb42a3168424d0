// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_houses.h"

#include <algorithm>
#include <array>

namespace ilot::scan {
namespace {

constexpr double kDoorHeight = 2.6, kShopHead = 3.0, kSill = 0.9;
constexpr double kBelowGround = 2.5;  // metres below the threshold that walls reach
constexpr double kRoofRise = 2.6, kRoofRun = 1.3;

struct Span {
  double low = 0, high = 0;
};

struct Window {
  Span s, z;
};

SurfaceLabel label(StreetClass street_class, std::uint32_t plane, Material material) {
  return {static_cast<std::uint8_t>(street_class), plane, 0, material};
}

// Builds outwards from the axis: `out` is the distance from it.
class HouseBuilder {
 public:
  HouseBuilder(StreetModel& model, const Street& street, const StreetHouse& house)
      : model_(model), street_(street), house_(house) {}

  void build() {
    make_windows();
    add_front();
    add_core();
    add_mouldings();
    add_roof();
  }

 private:
  Vec3 at(double s, double out, double z) const { return {s, house_.side * out, z}; }

  Solid block(Span s, Span out, Span z, SurfaceId surface) const {
    const double t = house_.side * (house_.side > 0 ? out.low : out.high);
    const std::array<Vec3, 4> ring{{{s.low, t, z.low},
                                    {s.high, t, z.low},
                                    {s.high, t + out.high - out.low, z.low},
                                    {s.low, t + out.high - out.low, z.low}}};
    return prism(ring, {0, 0, z.high - z.low}, surface);
  }
  // The faces of block(): first the one towards the axis, then those at the ends.
  std::size_t front_face() const { return house_.side > 0 ? 0 : 2; }

  double foot() const { return std::min(street_.road_height(house_.from), street_.road_height(house_.to)) - 0.3; }

  std::vector<Vec3> upright_ring(double out, Span s, Span z) const {
    std::vector<Vec3> ring{at(s.low, out, z.low), at(s.high, out, z.low), at(s.high, out, z.high),
                           at(s.low, out, z.high)};
    if (house_.side < 0) std::reverse(ring.begin(), ring.end());
    return ring;  // counter-clockwise seen from the axis
  }

  Plane upright_plane(double out) const { return {{0, -static_cast<double>(house_.side), 0}, out}; }

  void make_windows() {
    const double pitch = (house_.to - house_.from) / house_.columns, half = house_.window_width / 2;
    for (std::uint32_t floor = 0; floor < house_.floors; ++floor)
      for (std::uint32_t column = 0; column < house_.columns; ++column) {
        const double middle = house_.from + (column + 0.5) * pitch;
        const double z = house_.base + house_.ground_floor + house_.storey * (floor - 1.0);
        Window window{{middle - half, middle + half},
                      {z + kSill, z + kSill + std::min(house_.window_height, house_.storey - 1.2)}};
        if (floor == 0) {
          const bool door = column == 0;
          const double wide = house_.shop && !door ? pitch / 2 - 0.25 : half;
          window.s = {middle - wide, middle + wide};
          window.z = {house_.base + (door          ? -kBelowGround
                                     : house_.shop ? 0.5
                                                   : kSill + 0.2),
                      house_.base + (door ? kDoorHeight : kShopHead)};
        }
        windows_.push_back(window);
      }
  }

  // Adds strips of wall between the rows of windows, and piers within a row.
  void add_front() {
    const Span all{house_.from, house_.to}, z{foot(), house_.eave()};
    TruePlane& front = add_plane(model_, "facade", upright_plane(kHalfStreet), upright_ring(kHalfStreet, all, z));
    for (const Window& w : windows_) {
      std::vector<Vec3> hole = upright_ring(kHalfStreet, w.s, {std::max(w.z.low, foot() + 0.01), w.z.high});
      std::reverse(hole.begin(), hole.end());
      front.polygons[0].holes.push_back(std::move(hole));
    }
    const std::uint32_t id = front.id;
    front_ = model_.scene.add_surface(label(StreetClass::facade, id, house_.wall));
    reveal_ = model_.scene.add_surface(label(StreetClass::facade, 0, house_.wall));
    double top = foot() - kBelowGround;
    for (std::uint32_t floor = 0; floor < house_.floors; ++floor) {
      const std::span<const Window> row(&windows_[floor * house_.columns], house_.columns);
      const double low = std::max(row.back().z.low, foot() - kBelowGround), high = row.back().z.high;
      if (low > top) add_wall(all, {top, low});
      double s = house_.from;
      for (const Window& w : row) {
        add_wall({s, w.s.low}, {low, high});
        if (w.z.high < high) add_wall(w.s, {w.z.high, high});
        s = w.s.high;
      }
      add_wall({s, house_.to}, {low, high});
      if (floor == 0) open_door(row[0], low);
      top = high;
    }
    add_wall(all, {top, house_.eave()});
  }

  // Ends the strip below the windows of the ground floor at the door.
  void open_door(const Window& door, double low) {
    Part& strip = model_.scene.parts[first_strip_];
    strip = wall_block({door.s.high, house_.to}, {foot() - kBelowGround, low});
    add_wall({house_.from, door.s.low}, {foot() - kBelowGround, low});
  }

  Solid wall_block(Span s, Span z) const {
    Solid wall = block({s.low - kOverlap, s.high + kOverlap}, {kHalfStreet, kHalfStreet + kReveal + kOverlap},
                       {z.low - kOverlap, z.high + kOverlap}, reveal_);
    wall.surfaces[front_face()] = front_;
    return wall;
  }

  void add_wall(Span s, Span z) {
    if (windows_.empty() || s.high - s.low < 1e-9) return;
    if (first_strip_ == kNone) first_strip_ = model_.scene.parts.size();
    model_.scene.parts.push_back(wall_block(s, z));
  }

  void add_core() {
    const double out = kHalfStreet + kReveal;
    const Span s{house_.from, house_.to}, z{foot(), house_.eave()};
    const std::uint32_t inside = add_plane(model_, "facade", upright_plane(out), upright_ring(out, s, z)).id;
    Solid core = block(s, {out, kHalfStreet + kHouseDepth}, {foot() - kBelowGround, house_.eave()}, reveal_);
    core.surfaces[front_face()] = model_.scene.add_surface(label(StreetClass::facade, inside, Material::glass));
    for (double end : {-1.0, 1.0}) {
      const double place = end < 0 ? house_.from : house_.to;
      std::vector<Vec3> ring{at(place, kHalfStreet, z.low), at(place, kHalfStreet + kHouseDepth, z.low),
                             at(place, kHalfStreet + kHouseDepth, z.high), at(place, kHalfStreet, z.high)};
      if (end * house_.side < 0) std::reverse(ring.begin(), ring.end());
      const std::uint32_t id = add_plane(model_, "facade", {{end, 0, 0}, -end * place}, ring).id;
      core.surfaces[end < 0 ? 3 : 1] = model_.scene.add_surface(label(StreetClass::facade, id, house_.wall));
    }
    model_.scene.parts.push_back(core);
  }

  void add_moulding(Span z, double out) {
    model_.scene.parts.push_back(block({house_.from, house_.to}, {kHalfStreet - out, kHalfStreet + 0.05}, z, reveal_));
  }

  void add_mouldings() {
    const double first = house_.base + house_.ground_floor;
    add_moulding({first - 0.15, first + 0.05}, 0.08);
    add_moulding({house_.eave() - 0.35, house_.eave() + 0.05}, 0.3);
  }

  // Adds a mansard roof: steep towards the street and the yard, flat on top.
  void add_roof() {
    const double low = house_.eave(), near_side = kHalfStreet + 0.1, far_side = kHalfStreet + kHouseDepth;
    std::vector<Vec3> ring{at(house_.from, near_side, low), at(house_.from, far_side, low),
                           at(house_.from, far_side - kRoofRun, low + kRoofRise),
                           at(house_.from, near_side + kRoofRun, low + kRoofRise)};
    const Vec3 along{house_.to - house_.from, 0, 0};
    Solid roof = prism(ring, along, reveal_);
    const Plane slope = roof.planes[3];
    std::vector<Vec3> outline{ring[3], ring[0], ring[0] + along, ring[3] + along};
    if (house_.side < 0) std::reverse(outline.begin(), outline.end());
    const std::uint32_t id = add_plane(model_, "roof", slope, outline).id;
    const SurfaceId covered = model_.scene.add_surface(label(StreetClass::roof, id, house_.roof));
    const SurfaceId rest = model_.scene.add_surface(label(StreetClass::roof, 0, house_.roof));
    roof.surfaces.fill(rest);
    roof.surfaces[3] = covered;
    model_.scene.parts.push_back(roof);
  }

  static constexpr std::size_t kNone = ~std::size_t{0};
  StreetModel& model_;
  const Street& street_;
  const StreetHouse& house_;
  std::vector<Window> windows_;  // row by row from the ground floor
  SurfaceId front_ = 0, reveal_ = 0;
  std::size_t first_strip_ = kNone;
};

}  // namespace

TruePlane& add_plane(StreetModel& model, const char* surface_class, const Plane& plane, std::vector<Vec3> ring) {
  TruePlane truth;
  truth.id = static_cast<std::uint32_t>(model.planes.size() + 1);
  truth.surface_class = surface_class;
  truth.plane = plane;
  truth.polygons.push_back({0, std::move(ring), {}});
  model.planes.push_back(std::move(truth));
  return model.planes.back();
}

void add_house(StreetModel& model, const Street& street, const StreetHouse& house) {
  HouseBuilder(model, street, house).build();
}

}  // namespace ilot::scan
