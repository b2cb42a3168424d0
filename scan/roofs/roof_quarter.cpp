// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_quarter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "scan/roofs/roof_neighbours.h"
#include "scan/roofs/roof_wings.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr std::array<double, 4> kHeadings{8, 27, 51, 72};
constexpr double kRich = 0.25;              // share of detached complex roofs that must have more than ten faces
constexpr Integer kLongestTerrace = 60000;  // millimetres, without the last house
constexpr double kLeastEdge = 0.12, kLeastWidth = 0.4;  // metres

class QuarterBuilder {
 public:
  QuarterBuilder(const RoofTownParams& params, const Ground& ground, std::size_t index, double side,
                 std::span<const RoofKind> kinds)
      : params_(params),
        ground_(ground),
        quarter_(make_quarter(index, side)),
        kinds_(kinds),
        rng_(params.seed ^ 0x726f6f6673ull, index) {}

  // Fills rows from the middle outwards until all buildings are placed. Places fewer when there is no room.
  std::vector<RoofBuilding> build() {
    const double reach = 0.75 * (quarter_.area.x1 - quarter_.area.x0);
    const int rows = static_cast<int>(reach / kStreetPitch) + 1;
    for (int row = 0; row <= rows; ++row)
      for (int street : {row, -row})
        for (int side : {1, -1})
          if (row > 0 || street == row) add_row(street * kStreetPitch, side, reach);
    return std::move(buildings_);
  }

 private:
  bool all_placed() const { return buildings_.size() == kinds_.size(); }
  RoofKind next_kind() const { return kinds_[buildings_.size()]; }

  void add_row(double street, int side, double reach) {
    double u = -reach + 6 * rng_.uniform();
    adjoins_ = false;
    while (u < reach && !all_placed()) {
      const double gap = 2.5 + 0.5 * static_cast<double>(rng_.below(9));
      const std::optional<double> end = add_building(street, side, adjoins_ ? u : u + gap);
      u = end ? *end : u + gap + 2;
      const bool can_go_on = end && terraced_ && next_u_ < kLongestTerrace && !all_placed();
      adjoins_ = can_go_on && next_kind() != RoofKind::hip && rng_.uniform() < 0.75;
    }
  }

  // Returns where the building ends along the street. Returns nothing when there is no room for it.
  std::optional<double> add_building(double street, int side, double u) {
    const RoofKind kind = next_kind();
    if (!adjoins_) terraced_ = kind != RoofKind::hip && rng_.uniform() < params_.adjoining;
    const bool rich = kind == RoofKind::complex && !terraced_ && rng_.uniform() < kRich;
    for (int attempt = 0; attempt < 24; ++attempt) {
      RoofDesign design = draw(kind, attempt);
      const GridRect bounds = bounds_of(design.wings);
      if (!adjoins_) start_group(street, side, u, bounds);
      const Integer across = continues_ ? 0 : place_across(side, bounds), up = continues_ ? 0 : foot_;
      for (Wing& wing : design.wings) wing = moved(wing, next_u_ - bounds.u0, across, up);
      least_faces_ = kind != RoofKind::complex ? 2 : rich && attempt < 18 ? 11 : 3;
      if (try_building(kind, std::move(design.wings))) return u + kUnit * static_cast<double>(bounds.u1 - bounds.u0);
    }
    return std::nullopt;
  }

  // Sometimes a gable continues its neighbour's roof.
  RoofDesign draw(RoofKind kind, int attempt) {
    RoofDesign design = draw_roof(rng_, kind, terraced_ ? BuiltForm::terraced : BuiltForm::detached,
                                  attempt < 12 ? params_.chimneys : 0);
    continues_ = adjoins_ && kind == RoofKind::gable && buildings_.back().kind == RoofKind::gable &&
                 buildings_.back().wings.size() == 1 && design.wings.size() == 1 && rng_.uniform() < 0.3;
    if (continues_) {
      const GridRect before = buildings_.back().wings[0].rect, own = design.wings[0].rect;
      design.wings[0] = buildings_.back().wings[0];
      design.wings[0].rect = {own.u0, before.v0, own.u1, before.v1};
    }
    return design;
  }

  Integer place_across(int side, const GridRect& bounds) {
    const Integer setback = 250 * static_cast<Integer>(rng_.below(adjoins_ ? 4 : 9));
    return side > 0 ? setback - bounds.v0 : -setback - bounds.v1;
  }

  // Makes a frame and a base height for a building and for those that will adjoin it.
  void start_group(double street, int side, double u, const GridRect& bounds) {
    const double v = street + side * (kRoofHalfStreet + 2);
    const Vec3 start = quarter_.frame.to_town({u, v, 0});
    frame_ = {start.x, start.y, quarter_.frame.heading};
    const double length = kUnit * static_cast<double>(bounds.u1 - bounds.u0);
    const Vec3 middle = quarter_.frame.to_town({u + length / 2, v + side * 5.0, 0});
    foot_ = std::llround(ground_.height(middle.x, middle.y) / kUnit);
    next_u_ = 0;
  }

  bool try_building(RoofKind kind, std::vector<Wing> wings) {
    RoofBuilding building;
    building.kind = kind;
    building.wings = std::move(wings);
    building.frame = frame_;
    const GridRect bounds = bounds_of(building.wings);
    if (!has_room(bounds)) return false;
    const Integer floor = lowest_ground(bounds);
    building.solid = build_solid(partition_roof(building.wings), floor);
    if (fault_of(building.solid, kLeastEdge, kLeastWidth) || too_simple(building)) return false;
    if (doubtful(building, building) || (adjoins_ && doubtful(building, buildings_.back()))) return false;
    measure(building, floor);
    dress(building);
    next_u_ = bounds.u1;
    rooms_.push_back(room_of(bounds));
    buildings_.push_back(std::move(building));
    return true;
  }

  bool too_simple(const RoofBuilding& building) const {
    return least_faces_ > std::count_if(building.solid.faces.begin(), building.solid.faces.end(),
                                        [](const RoofFace& f) { return f.part == RoofPart::roof; });
  }

  // Returns the rectangle in the coordinates of the quarter.
  Rect room_of(const GridRect& bounds) const {
    const Vec3 low = quarter_.frame.to_local(
        frame_.to_town({kUnit * static_cast<double>(bounds.u0), kUnit * static_cast<double>(bounds.v0), 0}));
    return {low.x, low.y, low.x + kUnit * static_cast<double>(bounds.u1 - bounds.u0),
            low.y + kUnit * static_cast<double>(bounds.v1 - bounds.v0)};
  }

  bool has_room(const GridRect& bounds) const {
    const Rect room = room_of(bounds), area = quarter_.area;
    for (double u : {room.x0, room.x1})
      for (double v : {room.y0, room.y1}) {
        const Vec3 corner = quarter_.frame.to_town({u, v, 0});
        if (corner.x < area.x0 || corner.x > area.x1 || corner.y < area.y0 || corner.y > area.y1) return false;
        const double street = std::abs(v - kStreetPitch * std::round(v / kStreetPitch));
        if (street < kRoofHalfStreet) return false;
      }
    for (std::size_t i = 0; i < rooms_.size(); ++i) {
      const bool neighbour = adjoins_ && i + 1 == rooms_.size();
      const double apart = neighbour ? -1e-6 : 2;
      const Rect& other = rooms_[i];
      if (room.x0 < other.x1 + apart && other.x0 < room.x1 + apart && room.y0 < other.y1 + apart &&
          other.y0 < room.y1 + apart)
        return false;
    }
    return true;
  }

  Integer lowest_ground(const GridRect& bounds) const {
    double lowest = 1e9;
    for (Integer u : {bounds.u0, bounds.u1})
      for (Integer v : {bounds.v0, bounds.v1}) {
        const Vec3 p = frame_.to_town({kUnit * static_cast<double>(u), kUnit * static_cast<double>(v), 0});
        lowest = std::min(lowest, ground_.height(p.x, p.y));
      }
    return static_cast<Integer>(std::floor(lowest / kUnit));
  }

  static void measure(RoofBuilding& building, Integer floor) {
    building.floor = kUnit * static_cast<double>(floor);
    building.eave = 1e9;
    building.ridge = -1e9;
    for (const RoofFace& face : building.solid.faces) {
      if (face.part != RoofPart::roof) continue;
      for (std::uint32_t v : face.rings[0]) {
        building.eave = std::min(building.eave, building.solid.vertices[v].z);
        building.ridge = std::max(building.ridge, building.solid.vertices[v].z);
      }
    }
  }

  void dress(RoofBuilding& building) {
    const bool flat = building.wings[0].planes.size() == 1;
    const double roof = rng_.uniform(), wall = rng_.uniform();
    building.roof = flat ? Material::zinc : roof < 0.6 ? Material::tile : Material::slate;
    building.wall = wall < 0.6 ? Material::render : wall < 0.8 ? Material::brick : Material::limestone;
  }

  const RoofTownParams& params_;
  const Ground& ground_;
  Quarter quarter_;
  std::span<const RoofKind> kinds_;
  Rng rng_;
  std::vector<RoofBuilding> buildings_;
  std::vector<Rect> rooms_;
  RoofFrame frame_;
  Integer foot_ = 0, next_u_ = 0;
  std::ptrdiff_t least_faces_ = 2;  // fewest faces of the roof that is being drawn
  bool terraced_ = false, adjoins_ = false, continues_ = false;
};

}  // namespace

Quarter make_quarter(std::size_t index, double side) {
  const double east = index % 2 == 0 ? 0 : side, north = index < 2 ? 0 : side;
  static const std::array<SinCos, 4> headings{sin_cos_deg(kHeadings[0]), sin_cos_deg(kHeadings[1]),
                                              sin_cos_deg(kHeadings[2]), sin_cos_deg(kHeadings[3])};
  return {{east + side / 2, north + side / 2, headings[index]},
          {east + kHalfAvenue, north + kHalfAvenue, east + side - kHalfAvenue, north + side - kHalfAvenue}};
}

std::vector<RoofBuilding> fill_quarter(const RoofTownParams& params, const Ground& ground, std::size_t index,
                                       double side, std::span<const RoofKind> kinds) {
  return QuarterBuilder(params, ground, index, side, kinds).build();
}

}  // namespace ilot::scan
