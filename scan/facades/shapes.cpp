// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr std::array kOptions = with_beam_options(std::array{
    SceneOption{"scene.step", 0.07, "deg", 0.002, 1, "angular step, horizontal and vertical; --points scales it"},
    SceneOption{"scene.distance", 13, "m", 11, 100, "of the three stations from the middle"},
    SceneOption{"scene.sizes", 6, "sizes", 1, 8, "of each kind of shape, from large to small"},
    SceneOption{"scene.tilt", 0.4, "share", 0, 1, "of shapes that do not stand upright"},
});

constexpr double kPitch = 2.4, kFloorMargin = 1.5;
constexpr double kLargest = 0.85, kShrink = 0.6;  // radius of the first size; ratio of each size to the one before

class ShapesBuilder {
 public:
  ShapesBuilder(TerrestrialScene& scene, double tilted, std::uint64_t seed)
      : scene_(scene), tilted_(tilted), rng_(seed, 0x736861706573ull) {}

  void add_floor(double x0, double y0, double x1, double y1) {
    const std::vector<Vec3> ring{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
    const SurfaceId surface = label(ShapeClass::plane, add_plane({{0, 0, 1}, 0}, ring), Material::paving);
    scene_.model.parts.push_back(Panel{
        {x0, y0, 0}, {1, 0, 0}, {0, 1, 0}, {{0, 0}, {x1 - x0, 0}, {x1 - x0, y1 - y0}, {0, y1 - y0}}, {}, surface});
  }

  void add_cylinder(Vec3 foot, double radius) {
    const Vec3 axis = draw_axis();
    const double length = 3 * radius;
    const Vec3 base = raise(foot, axis, radius);
    const Material material = draw_material();
    Solid solid = cylinder(base, axis, length, radius, 0);
    const std::uint32_t id = next_id();
    scene_.shapes.push_back({id, "cylinder", base, axis, radius, 0, length, 0});
    solid.surfaces[2] = label(ShapeClass::cylinder, id, material);
    add_end(solid, 0, base, -1.0 * axis, radius, material);
    add_end(solid, 1, base + length * axis, axis, radius, material);
    scene_.model.parts.push_back(solid);
  }

  // The cone is cut above its apex, so it ends in a disc.
  void add_cone(Vec3 foot, double radius) {
    const Vec3 up = draw_axis(), axis = -1.0 * up;
    const double tangent = tan_deg(15 + 5 * static_cast<double>(rng_.below(5)));
    const double to = radius / tangent, from = 0.25 * to;
    const Vec3 apex = raise(foot, up, radius) + to * up;
    const Material material = draw_material();
    Solid solid = cone(apex, axis, from, to, tangent, 0);
    const std::uint32_t id = next_id();
    scene_.shapes.push_back({id, "cone", apex, axis, 0, atan_deg(tangent), to, 0});
    solid.surfaces[2] = label(ShapeClass::cone, id, material);
    add_end(solid, 0, apex + from * axis, up, from * tangent, material);
    add_end(solid, 1, apex + to * axis, axis, radius, material);
    scene_.model.parts.push_back(solid);
  }

  void add_sphere(Vec3 foot, double radius) {
    const Vec3 centre = foot + Vec3{0, 0, radius};
    const std::uint32_t id = next_id();
    scene_.shapes.push_back({id, "sphere", centre, {0, 0, 1}, radius, 0, 0, 0});
    scene_.model.parts.push_back(sphere(centre, radius, label(ShapeClass::sphere, id, draw_material())));
  }

  // Adds a box that is turned about the vertical.
  void add_box(Vec3 foot, double half) {
    const SinCos turn = sin_cos_deg(5 + 80 * rng_.uniform());
    const Vec3 u{turn.cos, turn.sin, 0}, v{-turn.sin, turn.cos, 0}, up{0, 0, 2 * half};
    const std::array<Vec3, 4> ring{foot - half * u - half * v, foot + half * u - half * v, foot + half * u + half * v,
                                   foot - half * u + half * v};
    const Material material = draw_material();
    Solid solid = prism(ring, up, 0);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 a = ring[i], b = ring[(i + 1) % 4];
      solid.surfaces[i] = label(ShapeClass::plane, add_plane(solid.planes[i], {a, b, b + up, a + up}), material);
    }
    std::vector<Vec3> top;
    for (Vec3 p : ring) top.push_back(p + up);
    solid.surfaces[5] = label(ShapeClass::plane, add_plane(solid.planes[5], top), material);
    scene_.model.parts.push_back(solid);
  }

 private:
  std::uint32_t next_id() const { return static_cast<std::uint32_t>(scene_.planes.size() + scene_.shapes.size() + 1); }

  SurfaceId label(ShapeClass shape, std::uint32_t id, Material material) {
    return scene_.model.add_surface({static_cast<std::uint8_t>(shape), id, 0, material});
  }

  std::uint32_t add_plane(const Plane& plane, std::vector<Vec3> ring) {
    const std::uint32_t id = next_id();
    scene_.planes.push_back({id, "plane", plane, 0, 0, {{0, std::move(ring), {}}}});
    return id;
  }

  void add_end(Solid& solid, std::size_t face, Vec3 centre, Vec3 normal, double radius, Material material) {
    const Vec3 any = std::abs(normal.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
    const Vec3 side = cross(any, normal), u = (1 / norm(side)) * side, v = cross(normal, u);
    std::vector<Vec3> ring;
    for (int i = 0; i < 48; ++i) {
      const SinCos angle = sin_cos_deg(7.5 * i - 180);
      ring.push_back(centre + radius * angle.cos * u + radius * angle.sin * v);
    }
    solid.surfaces[face] =
        label(ShapeClass::plane, add_plane({normal, -dot(normal, centre)}, std::move(ring)), material);
  }

  // Draws an axis that is approximately vertical.
  Vec3 draw_axis() {
    const bool upright = rng_.uniform() >= tilted_;
    const double tilt = 15 + 60 * rng_.uniform(), turn = 360 * rng_.uniform() - 180;
    if (upright) return {0, 0, 1};
    const SinCos t = sin_cos_deg(tilt), a = sin_cos_deg(turn);
    return {t.sin * a.cos, t.sin * a.sin, t.cos};
  }

  // Raises a shape so that a disc of the given radius across the axis does not reach below the floor.
  static Vec3 raise(Vec3 foot, Vec3 axis, double radius) {
    return foot + Vec3{0, 0, radius * std::sqrt(std::max(0.0, 1 - axis.z * axis.z))};
  }

  Material draw_material() {
    constexpr std::array kMaterials{Material::limestone, Material::render, Material::tile, Material::wood,
                                    Material::mortar};
    return kMaterials[rng_.below(kMaterials.size())];
  }

  TerrestrialScene& scene_;
  double tilted_;
  Rng rng_;
};

}  // namespace

std::span<const SceneOption> shapes_options() {
  return kOptions;
}

TerrestrialScan plan_shapes(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan = empty_scan(values, seed);
  scan.scene.classes = {{0, "mixed"}, {1, "plane"}, {2, "cylinder"}, {3, "sphere"}, {4, "cone"}};
  const int sizes = static_cast<int>(values.get("scene.sizes"));
  ShapesBuilder builder(scan.scene, values.get("scene.tilt"), seed);
  const double half_x = kPitch * (sizes - 1) / 2.0, half_y = kPitch * 1.5;
  builder.add_floor(-half_x - kFloorMargin, -half_y - kFloorMargin, half_x + kFloorMargin, half_y + kFloorMargin);
  double radius = kLargest;
  for (int size = 0; size < sizes; ++size, radius *= kShrink) {
    // Each row of shapes begins at a different position, so that the large ones are not all in one corner.
    const auto foot = [&](int row) {
      const int column = (size + row * sizes / 4) % sizes;
      return Vec3{kPitch * column - half_x, kPitch * row - half_y, 0};
    };
    builder.add_cylinder(foot(0), radius);
    builder.add_sphere(foot(1), radius);
    builder.add_cone(foot(2), radius);
    builder.add_box(foot(3), radius);
  }
  const Box3<Vec3> all = bounds_of(scan.scene.model.parts);
  const Vec3 margin{0.2, 0.2, 0.2};
  scan.scene.keep = {all.min - margin, all.max + margin};
  for (std::uint16_t i = 0; i < 3; ++i) {
    const SinCos angle = sin_cos_deg(120.0 * i - 100);
    const double distance = values.get("scene.distance");
    scan.scene.stations.push_back(station_towards(static_cast<std::uint16_t>(i + 1),
                                                  {distance * angle.cos, distance * angle.sin, 3.2}, all,
                                                  values.get("scene.step")));
  }
  return scan;
}

}  // namespace ilot::scan
