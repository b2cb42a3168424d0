// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_objects.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/error.h"

namespace ilot::scan {
namespace {

struct Wanted {
  ArtefactClass artefact_class;
  std::string_view variant;
};

enum class Side : std::uint8_t { ahead, beside };

// One object, or two objects that touch.
struct Group {
  std::vector<Wanted> members;
  Side side = Side::beside;
};

template <class T>
void shuffle(std::vector<T>& list, Rng& rng) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[rng.below(i)]);
}

// Returns `count` objects of a class. Each variant occurs in the proportion of the list of variants.
std::vector<Wanted> deal(ArtefactClass artefact_class, std::uint64_t count, Rng& rng) {
  const auto variants = variants_of(artefact_class);
  std::vector<Wanted> dealt;
  while (dealt.size() < count) {
    std::vector<std::string_view> round(variants.begin(), variants.end());
    shuffle(round, rng);
    for (std::string_view variant : round) dealt.push_back({artefact_class, variant});
  }
  dealt.resize(count);
  return dealt;
}

// Takes the last object that fits beside another anywhere on a pavement. If there is none, takes the last object.
Wanted take_small(std::vector<Wanted>& list) {
  constexpr std::array<std::string_view, 5> kLarge{"bus_shelter", "advert_column", "bench", "motorbike", "bicycle"};
  const auto small = std::find_if(list.rbegin(), list.rend(), [&](const Wanted& w) {
    return std::find(kLarge.begin(), kLarge.end(), w.variant) == kLarge.end();
  });
  const auto taken = small == list.rend() ? list.end() - 1 : small.base() - 1;
  const Wanted wanted = *taken;
  list.erase(taken);
  return wanted;
}

// Makes pairs of the classes in turn until the requested share touches another object.
std::vector<Group> group(const Street& street, Rng& rng) {
  constexpr auto kPerson = static_cast<std::size_t>(ArtefactClass::pedestrian);
  constexpr auto kOther = static_cast<std::size_t>(ArtefactClass::other);
  constexpr auto kCar = static_cast<std::size_t>(ArtefactClass::car);
  constexpr std::array<std::pair<std::size_t, std::size_t>, 6> kTurns{
      {{kPerson, kPerson}, {kOther, kOther}, {kPerson, kOther}, {kPerson, kPerson}, {kCar, kCar}, {kPerson, kPerson}}};
  const std::array<std::uint64_t, 4> counts = object_counts(street.params.blocks);
  std::array<std::vector<Wanted>, 4> left;
  std::uint64_t total = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    left[c] = deal(static_cast<ArtefactClass>(c), counts[c], rng);
    total += counts[c];
  }
  const auto pairs = static_cast<std::uint64_t>(std::llround(street.params.touching * static_cast<double>(total) / 2));
  std::vector<Group> groups;
  for (std::uint64_t turn = 0; groups.size() < pairs && turn < 6 * pairs; ++turn) {
    const auto [a, b] = kTurns[turn % kTurns.size()];
    if (left[a].size() < (a == b ? 2u : 1u) || left[b].empty()) continue;
    Group pair{{take_small(left[a])}, a == kCar ? Side::ahead : Side::beside};
    pair.members.push_back(take_small(left[b]));
    groups.push_back(std::move(pair));
  }
  std::vector<Group> rest;
  for (const auto& wanted : left)
    for (const Wanted& w : wanted) rest.push_back({{w}, Side::beside});
  shuffle(rest, rng);
  // Large objects come first, while there is room.
  std::stable_partition(rest.begin(), rest.end(), [](const Group& g) {
    return g.members[0].artefact_class == ArtefactClass::car || g.members[0].variant == "bus_shelter";
  });
  groups.insert(groups.end(), rest.begin(), rest.end());
  return groups;
}

// The position of an object of this kind: distance from the axis, and direction.
struct Placement {
  double t = 0, heading_deg = 0;
};

Placement draw_placement(const Wanted& wanted, int side, double lane, Rng& rng) {
  const double to_road = side > 0 ? -90 : 90, along = rng.uniform() < 0.5 ? 0 : 180;
  const double wobble = 6 * (2 * rng.uniform() - 1);
  if (wanted.artefact_class == ArtefactClass::car) return {side * (kHalfRoad - 1.15), along + 0.2 * wobble};
  if (wanted.artefact_class == ArtefactClass::lamppost) return {side * (kHalfRoad + 0.45), to_road};
  if (wanted.artefact_class == ArtefactClass::pedestrian) {
    // Some cross the road, away from the lane of the vehicle.
    const double away = lane < 0 ? 1 : -1, across = rng.uniform(), place = rng.uniform();
    const double t = across < 0.08 ? lane + away * (2.2 + 1.6 * place) : side * (kHalfRoad + 0.6 + 2.6 * place);
    return {t, 360 * rng.uniform() - 180};
  }
  if (wanted.variant == "motorbike")
    return rng.uniform() < 0.5 ? Placement{side * (kHalfRoad - 1.2), to_road + 2 * wobble}
                               : Placement{side * (kHalfRoad + 1.4), along + wobble};
  if (wanted.variant == "bicycle") return {side * (kHalfRoad + 0.8), along + wobble};
  if (wanted.variant == "bus_shelter") return {side * (kHalfRoad + 1.2), to_road};
  if (wanted.variant == "bench") return {side * (kHalfStreet - 0.8), to_road};
  if (wanted.variant == "advert_column") return {side * (kHalfRoad + 1.3), to_road};
  return {side * (kHalfRoad + 0.55 + 0.15 * rng.uniform()), to_road + wobble};
}

// A box with the height of its object above its base.
struct Obstacle {
  PlanBox plan;
  double foot = 0, height = 0;
};

Obstacle obstacle_of(const StreetObject& object) {
  return {object.plan, object.pose.base.z, object.box.max.z};
}

// Returns whether an obstacle leaves the line from a head of the scanner to a position free.
bool passes(Vec3 head, Vec3 place, const Obstacle& obstacle) {
  constexpr int kSteps = 40;
  for (int step = 1; step < kSteps; ++step) {
    const Vec3 p = head + static_cast<double>(step) / kSteps * (place - head);
    const PlanBox grain{p.x, p.y, {}, 0.02, 0.02};
    if (p.z < obstacle.foot + obstacle.height && closer(obstacle.plan, grain, 0)) return false;
  }
  return true;
}

class Placer {
 public:
  explicit Placer(const Street& street) : street_(street), rng_(street.params.seed, 0x6f626a65637473ull) {
    for (const StreetTree& tree : street.trees) trees_.push_back({tree.foot.x, tree.foot.y, {}, 0.2, 0.2});
  }

  std::vector<StreetObject> place() {
    const std::vector<Group> groups = group(street_, rng_);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      // Objects are spread over the blocks. If a block is full, the next one is used.
      const std::size_t first = rng_.below(street_.blocks.size());
      bool done = false;
      for (std::size_t k = 0; k < street_.blocks.size() && !done; ++k)
        done = place_in(street_.blocks[(first + k) % street_.blocks.size()], groups[i]);
      if (!done) throw Error("The street has no room for all objects; set fewer trees or a smaller scene.touching");
    }
    return std::move(objects_);
  }

 private:
  bool place_in(const StreetBlock& block, const Group& group) {
    for (int attempt = 0; attempt < 60; ++attempt) {
      const int side = rng_.uniform() < 0.5 ? 1 : -1;
      const Placement spot = draw_placement(group.members[0], side, street_.params.scanner.lane, rng_);
      const double s = block.from + 3 + (block.to - block.from - 6) * rng_.uniform();
      StreetObject first = make(group.members[0], s, spot.t, spot.heading_deg);
      if (!fits(first) || !all_seen(first)) continue;
      if (group.members.size() == 1) {
        accept(std::move(first));
        return true;
      }
      StreetObject second = make(group.members[1], s, spot.t, spot.heading_deg);
      put_against(first, second, group.side);
      if (!fits(second) || !all_seen(second) || !seen(first, second) || !seen(second, first)) continue;
      const auto id = static_cast<std::uint32_t>(objects_.size() + 1);
      first.touches = {id + 1};
      second.touches = {id};
      accept(std::move(first));
      accept(std::move(second));
      return true;
    }
    return false;
  }

  StreetObject make(const Wanted& wanted, double s, double t, double heading_deg) {
    StreetObject object;
    object.artefact_class = wanted.artefact_class;
    object.variant = wanted.variant;
    object.shape = make_artefact(wanted.artefact_class, wanted.variant, rng_);
    object.heading_deg = heading_deg > 180 ? heading_deg - 360 : heading_deg;
    object.pose.heading = sin_cos_deg(object.heading_deg);
    if (wanted.artefact_class == ArtefactClass::car) {
      const double rise = street_.slope * object.pose.heading.cos, length = std::sqrt(1 + rise * rise);
      object.pose.pitch = {rise / length, 1 / length};
    }
    const Pose upright{{0, 0, 0}, {}, object.pose.pitch};
    Artefact pitched;
    for (const Solid& solid : object.shape.solids) pitched.solids.push_back(placed(solid, upright));
    object.box = bounds_of(pitched);
    place_object(object, s, t);
    return object;
  }

  void place_object(StreetObject& object, double s, double t) const {
    object.pose.base = {s, t, street_.ground_height(s, t)};
    const Vec3 middle = 0.5 * (object.box.min + object.box.max);
    const SinCos h = object.pose.heading;
    object.plan = {s + middle.x * h.cos - middle.y * h.sin, t + middle.x * h.sin + middle.y * h.cos, h,
                   (object.box.max.x - object.box.min.x) / 2, (object.box.max.y - object.box.min.y) / 2};
  }

  // Places the second object so that the sides of the boxes touch, and the shapes touch where they project most.
  void put_against(const StreetObject& first, StreetObject& second, Side side) const {
    const Vec3 offset = side == Side::ahead ? Vec3{first.box.max.x - second.box.min.x, 0, 0}
                                            : Vec3{0, first.box.max.y - second.box.min.y, 0};
    const SinCos h = first.pose.heading;
    place_object(second, first.pose.base.x + offset.x * h.cos - offset.y * h.sin,
                 first.pose.base.y + offset.x * h.sin + offset.y * h.cos);
  }

  // Returns whether the object is in the street, not on a cross street, and clear of the kerb's edge and of all other
  // objects.
  bool fits(const StreetObject& object) const {
    const PlanBox& plan = object.plan;
    const double across = std::abs(plan.half_length * plan.heading.sin) + std::abs(plan.half_width * plan.heading.cos);
    const double inner = std::abs(plan.y) - across, outer = std::abs(plan.y) + across;
    const bool road = outer<kHalfRoad - 0.02, pavement = inner> kHalfRoad + 0.02 && outer < kHalfStreet - 0.35;
    // The arms of lampposts project over the road.
    if (!road && !pavement && object.artefact_class != ArtefactClass::lamppost) return false;
    const bool clear =
        std::none_of(trees_.begin(), trees_.end(), [&](const PlanBox& tree) { return closer(plan, tree, kClearance); });
    return clear && std::none_of(objects_.begin(), objects_.end(), [&](const StreetObject& other) {
             return near_each_other(object, other) && closer(plan, other.plan, kClearance);
           });
  }

  static bool near_each_other(const StreetObject& a, const StreetObject& b) {
    return std::abs(a.plan.x - b.plan.x) < 14;
  }

  // Returns whether at least one head sees the upper part of an object past all others and past `more`.
  bool seen(const StreetObject& object, const StreetObject& more) const {
    const Viewpoint& scanner = street_.params.scanner;
    const Vec3 top{object.plan.x, object.plan.y, object.pose.base.z + 0.75 * object.box.max.z};
    for (double turn : {-1.0, 1.0}) {
      const double s = top.x + turn * (top.y - scanner.lane) * tan_deg(scanner.turned_deg);
      const Vec3 head{s, scanner.lane, street_.road_height(s) + scanner.height};
      const auto hides = [&](const StreetObject& other) {
        return &other != &object && near_each_other(object, other) && !passes(head, top, obstacle_of(other));
      };
      if (!hides(more) && std::none_of(objects_.begin(), objects_.end(), hides)) return true;
    }
    return false;
  }

  bool all_seen(const StreetObject& fresh) const {
    return seen(fresh, fresh) && std::all_of(objects_.begin(), objects_.end(), [&](const StreetObject& other) {
             return !near_each_other(fresh, other) || seen(other, fresh);
           });
  }

  void accept(StreetObject object) {
    object.id = static_cast<std::uint32_t>(objects_.size() + 1);
    objects_.push_back(std::move(object));
  }

  const Street& street_;
  Rng rng_;
  std::vector<PlanBox> trees_;
  std::vector<StreetObject> objects_;
};

}  // namespace

std::array<std::uint64_t, 4> object_counts(std::uint64_t blocks) {
  std::array<std::uint64_t, 4> counts{67, 33, 198, 144};
  for (std::uint64_t& count : counts) count = (count * blocks + 15) / 30;
  return counts;
}

std::vector<StreetObject> place_objects(const Street& street) {
  return Placer(street).place();
}

}  // namespace ilot::scan
