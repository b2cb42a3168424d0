// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/facade/wild_site.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "kernels/core/portable_math.h"
#include "scan/optics/exact_math.h"
#include "scan/scanners/pose.h"
#include "scan/streets/artefact.h"

namespace ilot::scan {
namespace {

constexpr double kBeyond = 12;       // metres of ground beyond the walls' ends and under the houses
constexpr double kApart = 1.2;       // metres between stations and things
constexpr double kCoarseStep = 0.1;  // degrees; fit_density() scales it

// Adds a strip of ground, a sheet with a little roughness, and its plane.
void add_strip(TerrestrialScene& scene, const WildSite& site, double out0, double out1, Material material) {
  FacadeBuilder ground(scene, site.frame, 0);
  const double x0 = -kBeyond, x1 = site.length + kBeyond, level = site.ground(0, (out0 + out1) / 2);
  const auto at = [&](double x, double out) { return site.frame.place(x, out, site.slope * x + level); };
  const std::vector<Vec3> ring{at(x0, out0), at(x0, out1), at(x1, out1), at(x1, out0)};
  const Vec3 along = ring[3] - ring[0], v = (1 / norm(along)) * along, u = site.frame.out;
  Vec3 normal = cross(u, v);
  Panel panel{ring[0], u, v, {{0, 0}, {out1 - out0, 0}, {out1 - out0, norm(along)}, {0, norm(along)}}, {}, 0};
  const auto id = static_cast<std::uint32_t>(scene.planes.size() + scene.shapes.size() + 1);
  scene.planes.push_back({id, "ground", {normal, -dot(normal, ring[0])}, 0, 0, {{0, ring, {}}}});
  if (normal.z < 0)
    std::reverse(scene.planes.back().polygons[0].ring.begin(), scene.planes.back().polygons[0].ring.end());
  panel.surface = ground.surface(wild_finish(WildClass::ground, material), id);
  WallRelief relief;
  relief.roughness = 0.004;
  relief.grain = 0.12;
  relief.key = 7;
  scene.model.parts.push_back(Sheet{std::move(panel), 0, 0, {}, relief, 0});
}

// A place on the ground, and whether a thing may stand there.
struct Stand {
  double x = 0, out = 0;
};

class Things {
 public:
  Things(TerrestrialScene& scene, Draws& draws, const WildSite& site)
      : builder_(scene, site.frame, 0), scene_(scene), draws_(draws), site_(site) {}

  void cars() {
    constexpr std::array<std::string_view, 7> kVariants{"city", "hatchback", "saloon", "estate",
                                                        "suv",  "van",       "pickup"};
    const int count = draws_.whole("cars");
    for (int i = 0; i < count; ++i) {
      Rng rng = draws_.random("car", static_cast<std::uint64_t>(i));
      const double lane = site_.court ? 1.3 + (site_.width - 2.6) * rng.uniform() : site_.pavement + 1;
      const Stand at{site_.length * rng.uniform(), lane};
      const double turn = site_.court ? 180 * rng.uniform() : (rng.uniform() < 0.5 ? 0 : 180) + 4 * rng.uniform() - 2;
      const Artefact shape = make_car(kVariants[rng.below(kVariants.size())], rng);
      add(shape, "car", at, turn, static_cast<std::uint8_t>(rng.below(256)), 2.6);
    }
  }

  void people() {
    const std::span<const std::string_view> variants = variants_of(ArtefactClass::pedestrian);
    const int count = draws_.whole("people");
    for (int i = 0; i < count; ++i) {
      Rng rng = draws_.random("person", static_cast<std::uint64_t>(i));
      const Stand at{site_.length * rng.uniform(), 0.4 + std::min(4.0, site_.width - 0.8) * rng.uniform()};
      const Artefact shape = make_pedestrian(variants[rng.below(variants.size())], rng);
      add(shape, "person", at, 360 * rng.uniform() - 180, static_cast<std::uint8_t>(rng.below(256)), 0.4);
    }
  }

  void poles() {
    const std::span<const std::string_view> lamps = variants_of(ArtefactClass::lamppost);
    const std::span<const std::string_view> others = variants_of(ArtefactClass::other);
    const int count = draws_.whole("poles");
    for (int i = 0; i < count; ++i) {
      Rng rng = draws_.random("pole", static_cast<std::uint64_t>(i));
      const Stand at{site_.length * rng.uniform(), 0.35 + std::max(0.1, site_.pavement - 0.6) * rng.uniform()};
      const bool lamp = rng.uniform() < 0.5;
      const Artefact shape = lamp ? make_lamppost(lamps[rng.below(lamps.size())], rng)
                                  : make_furniture(others[rng.below(others.size())], rng);
      add(shape, lamp ? "lamppost" : "furniture", at, 360 * rng.uniform() - 180, 0, 0.6);
    }
  }

  void trees() {
    const int count = draws_.whole("trees");
    for (int i = 0; i < count; ++i) {
      Rng rng = draws_.random("tree", static_cast<std::uint64_t>(i));
      const Stand at{site_.length * rng.uniform(), 1 + std::max(0.5, std::min(5.0, site_.width - 2)) * rng.uniform()};
      const double z = site_.ground(at.x, at.out), trunk = 1.8 + 1.6 * rng.uniform(),
                   radius = 0.9 + 1.4 * rng.uniform();
      const double high = 1.5 + 3 * rng.uniform();
      if (!free(at, 0.4)) continue;
      const Block box{at.x - radius, at.x + radius, at.out - radius, at.out + radius, z + trunk, z + trunk + high};
      const std::uint32_t id = add_thing(builder_, "tree", box);
      builder_.post(at.x, at.out, z - 0.2, z + trunk + 0.5 * high, 0.06 + 0.14 * rng.uniform(),
                    wild_finish(WildClass::vegetation, Material::wood, id, 0xd2));
      constexpr int kTufts = 14;
      for (int k = 0; k < kTufts; ++k) {
        const double r = radius * (0.4 + 0.25 * rng.uniform());
        const double x = at.x + (radius - r) * (2 * rng.uniform() - 1),
                     o = at.out + (radius - r) * (2 * rng.uniform() - 1);
        const double up = z + trunk + (high - r) * rng.uniform();
        const auto tone = static_cast<std::uint8_t>(16 * (6 + rng.below(6)) + rng.below(10));
        add_leaves(builder_, {x - r, x + r, std::max(0.1, o - r), std::max(0.3, o + r), up, up + 1.5 * r}, Tuft::round,
                   {420, 0.08}, wild_finish(WildClass::vegetation, Material::foliage, id, tone), rng);
      }
    }
  }

  void hedges() {
    const int count = draws_.whole("hedges");
    for (int i = 0; i < count; ++i) {
      const auto index = static_cast<std::uint64_t>(i);
      Rng rng = draws_.random("hedge", index);
      const double x = site_.length * rng.uniform(), long_ = 1 + 4 * rng.uniform(), thick = 0.3 + 0.5 * rng.uniform();
      const double out = 0.3 + 1.5 * rng.uniform(), z = site_.ground(x, out),
                   high = draws_.number("hedge_height", index);
      if (!free({x + long_ / 2, out}, long_ / 2)) continue;
      const Block box{x, std::min(x + long_, site_.length + 2), out, out + thick, z, z + high};
      const Finish green =
          wild_finish(WildClass::vegetation, Material::foliage, add_thing(builder_, "hedge", box), 0x94);
      add_leaves(builder_, box, Tuft::square, {700, 0.05}, green, rng);
    }
  }

  void cables() {
    const int count = draws_.whole("street_cables");
    for (int i = 0; i < count; ++i) {
      Rng rng = draws_.random("street cable", static_cast<std::uint64_t>(i));
      const bool across = rng.uniform() < 0.5;
      const double z = 4.5 + 4 * rng.uniform(), radius = 0.005 + 0.01 * rng.uniform(),
                   far = std::min(site_.width, 14.0);
      const double x = site_.length * rng.uniform(), out = 0.5 + (far - 1) * rng.uniform();
      const Vec3 from = across ? Vec3{x, 0, z} : Vec3{-3, out, z};
      const Vec3 to = across ? Vec3{x + 2 * rng.uniform() - 1, far, z} : Vec3{site_.length + 3, out, z};
      const Block box{
          std::min(from.x, to.x), std::max(from.x, to.x) + 0.02, 0, std::max(from.y, to.y), z - 0.5, z + 0.05};
      const SurfaceId black =
          builder_.surface(wild_finish(WildClass::object, Material::iron, add_thing(builder_, "cable", box)));
      constexpr int kPieces = 10;
      const auto at = [&](int k) {
        const double s = static_cast<double>(k) / kPieces;
        const Vec3 p = from + s * (to - from);
        return site_.frame.place(p.x, p.y, p.z + site_.slope * p.x - 2 * s * (1 - s));
      };
      for (int k = 0; k < kPieces; ++k) {
        const Vec3 way = at(k + 1) - at(k);
        builder_.add(cylinder(at(k), (1 / norm(way)) * way, norm(way), radius, black));
      }
    }
  }

 private:
  bool free(Stand at, double radius) const {
    const Vec3 place = site_.frame.place(at.x, at.out, 0);
    if (site_.court &&
        (at.out < radius || at.out > site_.width - radius || at.x < radius || at.x > site_.length - radius))
      return false;
    return std::none_of(scene_.stations.begin(), scene_.stations.end(), [&](const StationParams& s) {
      const Vec3 d = s.position - place;
      return d.x * d.x + d.y * d.y < (kApart + radius) * (kApart + radius);
    });
  }

  void add(const Artefact& shape, const char* kind, Stand at, double turn_deg, std::uint8_t tone, double radius) {
    if (!free(at, radius)) return;
    const double turn = turn_deg > 180 ? turn_deg - 360 : turn_deg, z = site_.ground(at.x, at.out);
    const SinCos own = sin_cos_deg(turn);
    const Vec3 ahead = own.cos * site_.frame.along + own.sin * site_.frame.out;
    const Pose pose{site_.frame.place(at.x, at.out, z), {ahead.y, ahead.x}, {0, 1}};
    const Block box{at.x - radius, at.x + radius, at.out - radius, at.out + radius, z, z + 1.5};
    const std::uint32_t id = add_thing(builder_, kind, box);
    std::map<SurfaceId, SurfaceId> surface_of;  // by material
    for (const Solid& local : shape.solids) {
      Solid solid = placed(local, pose);
      for (SurfaceId& surface : solid.surfaces) {
        const auto [entry, fresh] = surface_of.try_emplace(surface, 0);
        if (fresh)
          entry->second = builder_.surface(wild_finish(WildClass::object, static_cast<Material>(surface), id, tone));
        surface = entry->second;
      }
      builder_.add(solid);
    }
  }

  FacadeBuilder builder_;
  TerrestrialScene& scene_;
  Draws& draws_;
  const WildSite& site_;
};

// The window of angles in which a station sees something of the crop below `reach`.
AngleWindow window_of(const StationParams& station, const WildCrop& crop, double reach) {
  AngleWindow w{-179.9, 179.9, -65, 0};
  const Vec3 d = station.position - crop.origin;
  const double x = dot(crop.along, d), out = dot(crop.out, d);
  const double dx = std::max({crop.x0 - x, x - crop.x1, 0.0}), dout = std::max({crop.out0 - out, out - crop.out1, 0.0});
  const double nearest = std::max(1.0, std::min(std::sqrt(dx * dx + dout * dout), std::abs(out)));
  const double up = direction_degrees(nearest, std::max(0.1, reach - station.position.z));
  w.high = std::min(88.0, up + 1);
  if (dx == 0 && dout == 0) return w;
  w.left = 180;
  w.right = -180;
  const Vec3 right{station.forward.y, -station.forward.x, 0};
  for (double cx : {crop.x0, crop.x1})
    for (double co : {crop.out0, crop.out1}) {
      const Vec3 corner = crop.origin + cx * crop.along + co * crop.out - station.position;
      const double turn = direction_degrees(dot(corner, station.forward), dot(corner, right));
      const double azimuth = turn > 180 ? turn - 360 : turn;
      w.left = std::min(w.left, azimuth);
      w.right = std::max(w.right, azimuth);
    }
  return w;
}

void place_stations(WildScan& scan, Draws& draws, const WildSite& site, double reach) {
  const int count = draws.whole("stations");
  const double most = site.opposite ? site.width - 1 : 1e9, distance = draws.number("station_distance");
  for (int i = 1; i <= count; ++i) {
    const auto id = static_cast<std::uint64_t>(i);
    Rng rng = draws.random("station", id);
    double x = draws.number("station_along", id) * site.length;
    double out = std::max(1.0, std::min(distance * (0.8 + 0.4 * rng.uniform()), most));
    if (site.court) {
      x = std::clamp(x, std::min(1.0, site.length / 2), std::max(site.length - 1, site.length / 2));
      out = 1 + (site.width - 2) * rng.uniform();
    }
    const double z = site.ground(x, out) + draws.number("station_height", id);
    StationParams station{static_cast<std::uint16_t>(i),
                          site.frame.place(x, out, z),
                          -1.0 * site.frame.out,
                          kCoarseStep,
                          kCoarseStep,
                          {}};
    // A station looks at the middle of the crop, so that its window does not reach around behind it.
    const Vec3 middle = scan.crop.origin + (scan.crop.x0 + scan.crop.x1) / 2 * scan.crop.along +
                        (scan.crop.out0 + scan.crop.out1) / 2 * scan.crop.out - station.position;
    const Vec3 flat{middle.x, middle.y, 0};
    if (norm(flat) > 0.1) station.forward = (1 / norm(flat)) * flat;
    station.window = window_of(station, scan.crop, reach);
    scan.scene.stations.push_back(station);
  }
}

}  // namespace

void add_ground(TerrestrialScene& scene, const WildSite& site) {
  const double far = site.court ? site.width + kBeyond : std::max(site.width, 45.0);
  if (!(site.kerb > 0)) return add_strip(scene, site, -kBeyond, far, Material::paving);
  const double road = site.pavement + site.road;
  add_strip(scene, site, -kBeyond, site.pavement, Material::paving);
  add_strip(scene, site, site.pavement, road, Material::asphalt);
  if (far > road) add_strip(scene, site, road, far, Material::paving);
  FacadeBuilder ground(scene, site.frame, 0);
  const double x0 = -kBeyond, x1 = site.length + kBeyond;
  for (double out : {site.pavement, road})
    ground.plate({{x0, out, site.slope * x0 - site.kerb},
                  {x1, out, site.slope * x1 - site.kerb},
                  {x1, out, site.slope * x1},
                  {x0, out, site.slope * x0}},
                 wild_finish(WildClass::ground, Material::limestone), Faces::unnamed);
}

void add_street_things(TerrestrialScene& scene, Draws& draws, const WildSite& site) {
  Things things(scene, draws, site);
  things.cars();
  things.people();
  things.poles();
  things.trees();
  things.hedges();
  things.cables();
}

void place_scanner(WildScan& scan, Draws& draws, const WildSite& site, double reach) {
  if (site.court || draws.is("platform", "stations")) return place_stations(scan, draws, site, reach);
  constexpr double kRunUp = 10;  // metres
  WildDrive drive;
  const double out = site.pavement + std::min(2.5, site.road / 2);
  drive.start = site.frame.place(-kRunUp, out, site.ground(-kRunUp, out) + draws.number("vehicle_height"));
  const Vec3 way = site.frame.along + Vec3{0, 0, site.slope};
  drive.way = (1 / norm(way)) * way;
  drive.length = site.length + 2 * kRunUp;
  drive.turned_deg = draws.number("vehicle_turned");
  drive.speed = draws.number("vehicle_speed");
  scan.drive = drive;
}

void drop_cropped(TerrestrialScene& scene, const WildCrop& crop) {
  const auto outside = [&](const std::vector<Vec3>& ring) {
    return std::any_of(ring.begin(), ring.end(), [&](Vec3 p) { return !crop.contains(p); });
  };
  std::map<std::uint32_t, bool> dropped;
  std::erase_if(scene.elements, [&](const TrueElement& e) {
    return e.facade != 0 && e.kind != "joint" && outside(e.ring) && (dropped[e.id] = true);
  });
  std::erase_if(scene.openings, [&](const TrueOpening& o) { return dropped.count(o.element) != 0 || outside(o.ring); });
  std::erase_if(scene.control_points,
                [&](const TrueControlPoint& p) { return dropped.count(p.element) != 0 || !crop.contains(p.position); });
}

}  // namespace ilot::scan
