// SPDX-License-Identifier: Apache-2.0
// Where the objects of `street-wild` stand.
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/wild/street/wild_street.h"

namespace ilot::scan {
namespace {

constexpr double kApart = 0.25;  // metres between objects that do not touch
constexpr double kGrainS = 2.0;  // metres of street per place that is tried
constexpr int kAttempts = 12;

Box3<Vec3> box_of(const ObjectShape& shape) {
  const auto leaf_box = [](const Crown& c) { return Box3<Vec3>{c.centre - c.radii, c.centre + c.radii}; };
  Box3<Vec3> box = shape.solids.empty() ? leaf_box(shape.leaves[0]) : shape.solids[0].bounds;
  for (const Solid& solid : shape.solids) box.add_box(solid.bounds);
  for (const Crown& leaf : shape.leaves) box.add_box(leaf_box(leaf));
  return box;
}

// Returns the box that an object needs on the ground: a tree needs that of its trunk.
Box3<Vec3> foot_box(const WildObject& object) {
  if (object.shape.trunk_radius > 0) {
    const double r = object.shape.trunk_radius + 0.1;
    return {{-r, -r, 0}, {r, r, 1}};
  }
  if (object.kind->name == "wire_pole" || object.kind->name == "hung_lamp") return {{-0.2, -0.2, 0}, {0.2, 0.2, 1}};
  if (object.kind->name == "traffic_light_arm") return {{-0.3, -0.3, 0}, {0.4, 0.3, 1}};
  return object.box;
}

PlanBox plan_of(const WildObject& object, const Box3<Vec3>& box) {
  const Vec3 centre = object.pose.place({(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, 0});
  return {centre.x, centre.y, object.pose.heading, (box.max.x - box.min.x) / 2, (box.max.y - box.min.y) / 2};
}

class Placer {
 public:
  Placer(const WildStreet& street, Draws& draws, double lane)
      : street_(street), draws_(draws), lane_(lane), touching_(draws.number("street.touching")) {}

  std::vector<WildObject> place() {
    add_trees();
    for (const int side : {1, -1}) {
      along(side, ObjectPlace::parking, "street.parking");
      along(side, ObjectPlace::kerb, "street.kerb_objects");
      along(side, ObjectPlace::pavement, "street.pavement_objects");
      along(side, ObjectPlace::front, "street.front_objects");
      along(side, ObjectPlace::boundary, "street.boundaries");
      along(side, ObjectPlace::yard, "street.yard_objects");
      along(side, ObjectPlace::square, "street.square_objects");
    }
    along(1, ObjectPlace::carriageway, "street.traffic");
    along(1, ObjectPlace::ends, "street.hung_lamps");
    return std::move(objects_);
  }

 private:
  // Returns the kind for a place whose family is not left out: each family has a row "street.FAMILY" with its weight.
  const ObjectKind* draw_kind(ObjectPlace place, Rng& rng, bool trees) {
    const auto weight = [&](const ObjectKind& kind) {
      const bool fits = kind.place == place && (place != ObjectPlace::ends || (kind.family == "trees") == trees);
      return fits ? kind.frequency * draws_.number("street." + std::string(kind.family)) : 0.0;
    };
    double total = 0;
    for (const ObjectKind& kind : object_kinds()) total += weight(kind);
    double left = total * rng.uniform();
    for (const ObjectKind& kind : object_kinds()) {
      const double w = weight(kind);
      if (w > 0 && left < w) return &kind;
      left -= w;
    }
    return nullptr;
  }

  // Tries places along a side; `row` is the number of objects per 10 m.
  void along(int side, ObjectPlace place, const char* row) {
    const double per_place = draws_.number(row) * kGrainS / 10;
    const double from = -6, to = street_.length + 6;
    const auto places = static_cast<std::uint64_t>((to - from) / kGrainS);
    for (std::uint64_t i = 0; i < places; ++i) {
      Rng rng = draws_.random(row, element_index(static_cast<std::uint64_t>(side + 1), i));
      for (double due = per_place; due > 0; due -= 1)
        if (rng.uniform() < due) try_place(side, place, from + (static_cast<double>(i) + rng.uniform()) * kGrainS, rng);
    }
  }

  const StreetPlot* plot_at(int side, double s) const {
    const auto found = std::find_if(street_.plots.begin(), street_.plots.end(),
                                    [&](const StreetPlot& p) { return p.side == side && s >= p.s0 && s <= p.s1; });
    return found == street_.plots.end() ? nullptr : &*found;
  }

  // The distance from the axis and the heading of an object at a place, or nothing where it does not fit.
  struct Spot {
    double out = 0, heading = 0;
  };
  std::optional<Spot> spot_of(int side, ObjectPlace place, const StreetPlot& plot, const ObjectShape& shape, Rng& rng) {
    const Box3<Vec3> box = box_of(shape);
    const double half = (box.max.y - box.min.y) / 2, road = street_.half_road, outer = street_.half_street();
    const double front = outer + plot.setback;
    const bool open = plot.use == PlotUse::gap || plot.use == PlotUse::square;
    const double to_road = side > 0 ? -90 : 90;
    switch (place) {
      case ObjectPlace::parking:
        if (plot.use == PlotUse::cross) return std::nullopt;
        return Spot{road - half - between(rng, 0.05, 0.5), (side > 0 ? 180 : 0) + between(rng, -4, 4)};
      case ObjectPlace::carriageway:
        return Spot{between(rng, 0.5, std::max(0.6, road - 3.2)), 0};
      case ObjectPlace::kerb:
        if (plot.use == PlotUse::cross) return std::nullopt;
        return Spot{road + between(rng, 0.3, 0.8), to_road + between(rng, -8, 8)};
      case ObjectPlace::pavement:
        return Spot{between(rng, road + 0.4, std::max(road + 0.5, outer - 0.3)), between(rng, -180, 180)};
      case ObjectPlace::front:
        if (plot.use != PlotUse::house) return std::nullopt;
        return Spot{front - 0.06 - box.max.x * 0 - std::max(0.0, -box.min.x), to_road};
      case ObjectPlace::square:
        if (plot.use != PlotUse::square && street_.layout != "court") return std::nullopt;
        if (street_.layout == "court") return Spot{between(rng, 0, road), between(rng, -180, 180)};
        return Spot{between(rng, outer, outer + plot.setback + plot.depth + plot.yard), between(rng, -180, 180)};
      case ObjectPlace::yard:
        if (plot.use == PlotUse::cross || plot.use == PlotUse::square) return std::nullopt;
        if (plot.setback > 2 && rng.uniform() < 0.4)
          return Spot{between(rng, outer + 0.5, front - 0.5), between(rng, -180, 180)};
        return Spot{open ? between(rng, outer + 1, front + plot.depth + plot.yard)
                         : front + plot.depth + between(rng, 0.7, plot.yard),
                    between(rng, -180, 180)};
      case ObjectPlace::boundary:
        if (plot.use == PlotUse::gap || plot.setback > 1.5) return Spot{outer + 0.15, to_road};
        if (plot.use != PlotUse::house) return std::nullopt;
        return Spot{front + plot.depth + between(rng, 2, plot.yard), rng.uniform() < 0.5 ? to_road : 0};
      case ObjectPlace::ends:
        return Spot{0, 0};
    }
    return std::nullopt;
  }

  bool is_free(const WildObject& object, bool may_touch) {
    for (const WildObject& other : objects_) {
      const bool near = closer(object.plan, other.plan, may_touch ? -0.02 : kApart);
      if (near) return false;
    }
    return true;
  }

  void try_place(int side, ObjectPlace place, double s, Rng& rng) {
    const ObjectKind* kind = draw_kind(place, rng, false);
    if (!kind) return;
    for (int attempt = 0; attempt < kAttempts; ++attempt, s += between(rng, -1, 1)) {
      WildObject object;
      object.kind = kind;
      kind->make(object.shape, rng);
      const StreetPlot* plot = plot_at(side, s);
      if (!plot) continue;
      const auto spot = spot_of(side, place, *plot, object.shape, rng);
      if (!spot) continue;
      if (set(object, s, side * spot->out, spot->heading, rng)) return;
    }
  }

  // Puts an object down. Returns false where something is in its way.
  bool set(WildObject& object, double s, double t, double heading, Rng& rng) {
    const GroundPatch* ground = street_.patch_at(s, t);
    if (!ground && object.kind->place != ObjectPlace::ends) return false;
    object.heading_deg = std::remainder(heading, 360.0);
    const bool lengthwise =
        object.kind->place == ObjectPlace::parking || object.kind->place == ObjectPlace::carriageway;
    const SinCos way = sin_cos_deg(object.heading_deg);
    object.pose = {{s, t, street_.ground_height(s, t)}, way, {}};
    if (lengthwise) {  // wheels stand on the slope of the street
      const double rise = (street_.profile_height(s + 1.5 * way.cos) - street_.profile_height(s - 1.5 * way.cos)) / 3;
      object.pose.pitch = sin_cos_deg(atan_deg(rise));
    }
    object.box = box_of(object.shape);
    object.plan = plan_of(object, foot_box(object));
    const bool vehicle_lane =
        std::abs(t - lane_) < 1.4 + object.plan.half_width && object.kind->place != ObjectPlace::ends;
    if (vehicle_lane && street_.platform == Platform::vehicle && object.kind->place != ObjectPlace::carriageway)
      return false;
    const bool may_touch = rng.uniform() < touching_;
    if (object.kind->place != ObjectPlace::ends && !is_free(object, may_touch)) return false;
    set_in_motion(object, rng);
    add(object);
    if (object.kind->name == "walker" || object.kind->name == "standing_person") add_group(object, rng);
    return true;
  }

  void add(WildObject& object) {
    object.id = static_cast<std::uint32_t>(objects_.size() + 1);
    for (WildObject& other : objects_) {
      if (!closer(object.plan, other.plan, 0.05)) continue;
      object.touches.push_back(other.id);
      other.touches.push_back(object.id);
    }
    objects_.push_back(object);
  }

  // People come in groups: each further one stands 0.4 to 0.9 m from the first and faces it or walks with it.
  void add_group(const WildObject& first, Rng& rng) {
    if (rng.uniform() > draws_.number("street.groups")) return;
    const auto more = 1 + rng.below(4);
    for (std::uint64_t i = 0; i < more; ++i) {
      WildObject next;
      next.kind = first.kind;
      next.kind->make(next.shape, rng);
      const SinCos way = sin_cos_deg(between(rng, -180, 180));
      const double apart = between(rng, 0.45, 0.95);
      const double s = first.pose.base.x + apart * way.cos, t = first.pose.base.y + apart * way.sin;
      next.heading_deg = first.moves() ? first.heading_deg : between(rng, -180, 180);
      next.pose = {{s, t, street_.ground_height(s, t)}, sin_cos_deg(next.heading_deg), {}};
      next.box = box_of(next.shape);
      next.plan = plan_of(next, foot_box(next));
      next.velocity = first.velocity;
      next.seen_at_s = first.seen_at_s;
      if (is_free(next, true)) add(next);
    }
  }

  void set_in_motion(WildObject& object, Rng& rng) {
    const double s = object.pose.base.x;
    object.comes_and_goes = object.kind->family == "vehicles" && rng.uniform() < draws_.number("street.moved_cars");
    double speed = 0;
    if (object.kind->place == ObjectPlace::carriageway)
      speed = object.kind->name == "cyclist" ? between(rng, 2.5, 7) : between(rng, 0.5, 13);
    else if (object.kind->name == "walker" || object.kind->name == "dog" || object.kind->name == "pram")
      speed = rng.uniform() < draws_.number("street.walking") ? between(rng, 0.4, 2) : 0;
    if (speed == 0) return;
    const double ahead = object.pose.base.y < 0 ? 1 : -1;  // traffic keeps to the right
    object.heading_deg = ahead > 0 ? 0 : 180;
    object.pose.heading = sin_cos_deg(object.heading_deg);
    object.velocity = {ahead * speed, 0, 0};
    object.seen_at_s = s + between(rng, -9, 9);
    object.plan = plan_of(object, foot_box(object));
  }

  // Plants trees until their crowns cover the drawn share of the street's length.
  void add_trees() {
    const double share = draws_.number("street.crowns");
    if (share <= 0) return;
    Rng rng = draws_.random("street.trees_at");
    const ObjectKind* avenue = draw_kind(ObjectPlace::ends, rng, true);
    for (const int side : {1, -1})
      for (double s = between(rng, -4, 4); s < street_.length + 4;) {
        const ObjectKind* kind = rng.uniform() < 0.7 ? avenue : draw_kind(ObjectPlace::ends, rng, true);
        if (!kind) return;
        WildObject tree;
        tree.kind = kind;
        kind->make(tree.shape, rng);
        const Box3<Vec3> box = box_of(tree.shape);
        const double width = std::max(1.5, 0.8 * (box.max.y - box.min.y));
        const StreetPlot* plot = plot_at(side, s);
        const bool planted = rng.uniform() < share;
        if (planted && plot && plot->use != PlotUse::cross)
          set(tree, s, side * (street_.half_road + between(rng, 0.6, 1.2)), between(rng, -180, 180), rng);
        s += planted ? width : 6;
      }
  }

  const WildStreet& street_;
  Draws& draws_;
  double lane_, touching_;
  std::vector<WildObject> objects_;
};

}  // namespace

std::vector<WildObject> place_wild_objects(const WildStreet& street, Draws& draws, double lane) {
  return Placer(street, draws, lane).place();
}

}  // namespace ilot::scan
