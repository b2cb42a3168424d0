// SPDX-License-Identifier: Apache-2.0
#include "scan/facades/stones.h"

#include <array>

#include "scan/facades/facade_builder.h"
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr std::array kOptions = with_beam_options(std::array{
    SceneOption{"scene.step", 0.0312, "deg", 0.001, 1, "angular step, horizontal and vertical; --points scales it"},
    SceneOption{"scene.distance", 8, "m", 2, 100, "from the station to the stones"},
    SceneOption{"scene.angle", 40, "deg", 5, 80, "of the line of sight to the stones' normal"},
    SceneOption{"scene.joint_width", 0.035, "m", 0.005, 0.2, "between two stones"},
    SceneOption{"scene.joint_depth", 0.02, "m", 0.002, 0.2, "of the joints behind the stones"},
    SceneOption{"scene.stone_width", 0.6, "m", 0.1, 3, "of each stone"},
    SceneOption{"scene.stone_height", 0.4, "m", 0.1, 2, "of each stone"},
    SceneOption{"scene.side_1", 0.965, "m", 0.05, 5, "how far the left wall stands out from the stones"},
    SceneOption{"scene.side_2", 0.11, "m", 0.02, 5, "how far the right wall runs back from them"},
});

constexpr double kFloor = 1.2;  // height of the lower stones above the ground

Finish finish(StonesClass surface_class, std::uint32_t element, Material material) {
  return {static_cast<std::uint8_t>(surface_class), element, material};
}

// The positions of all parts along the facade.
struct Layout {
  double width, height, joint, depth, total, top;
  explicit Layout(const SceneValues& v)
      : width(v.get("scene.stone_width")),
        height(v.get("scene.stone_height")),
        joint(v.get("scene.joint_width")),
        depth(v.get("scene.joint_depth")),
        total(2 * width + joint),
        top(kFloor + 2 * height + joint) {}
};

TrueElement element(const FacadeBuilder& facade, const char* kind, const Opening& place, double depth) {
  TrueElement e;
  e.kind = kind;
  e.ring = facade.outline(place, 0);
  e.width = place.right - place.left;
  e.height = place.springing - place.bottom;
  e.depth = depth;
  return e;
}

void add_stones(FacadeBuilder& facade, const Layout& at) {
  for (std::uint32_t row = 0; row < 2; ++row)
    for (std::uint32_t column = 0; column < 2; ++column) {
      const double x = column * (at.width + at.joint), z = kFloor + row * (at.height + at.joint);
      const Opening place{x, x + at.width, z, z + at.height, 0};
      TrueElement stone = element(facade, "stone", place, at.depth);
      stone.row = row + 1;
      stone.column = column + 1;
      const std::uint32_t id = facade.add_element(stone);
      facade.wall(place.left, place.right, place.bottom, place.springing, 0, {},
                  finish(StonesClass::stones, id, Material::limestone));
    }
}

// Adds the ground of the joints and the edges of the stones along them.
void add_joints(FacadeBuilder& facade, const Layout& at) {
  const double x0 = at.width, x1 = at.width + at.joint, z0 = kFloor + at.height, z1 = z0 + at.joint;
  TrueElement joint = element(facade, "joint", {0, at.total, z0, z1, 0}, -at.depth);
  joint.ring.clear();  // the joint is a cross; its arms are the polygons of its plane
  for (const auto& [x, z] : {std::pair{x0, kFloor},
                             {x1, kFloor},
                             {x1, z0},
                             {at.total, z0},
                             {at.total, z1},
                             {x1, z1},
                             {x1, at.top},
                             {x0, at.top},
                             {x0, z1},
                             {0.0, z1},
                             {0.0, z0},
                             {x0, z0}})
    joint.ring.push_back(facade.frame().place(x, 0, z));
  joint.width = joint.height = at.joint;
  const Finish mortar = finish(StonesClass::joint, facade.add_element(joint), Material::mortar);
  facade.wall(x0, x1, kFloor, z0, -at.depth, {}, mortar);
  facade.wall(0, at.total, z0, z1, -at.depth, {}, mortar);
  facade.wall(x0, x1, z1, at.top, -at.depth, {}, mortar);
  const Finish edge = finish(StonesClass::joint, mortar.element, Material::limestone);
  const double d = -at.depth;
  for (const auto& [low, high] : {std::pair{kFloor, z0}, {z1, at.top}}) {
    facade.plate({{x0, d, low}, {x0, d, high}, {x0, 0, high}, {x0, 0, low}}, edge);
    facade.plate({{x1, 0, low}, {x1, 0, high}, {x1, d, high}, {x1, d, low}}, edge);
  }
  for (const auto& [left, right] : {std::pair{0.0, x0}, {x1, at.total}}) {
    facade.plate({{left, d, z0}, {left, 0, z0}, {right, 0, z0}, {right, d, z0}}, edge);
    facade.plate({{left, d, z1}, {right, d, z1}, {right, 0, z1}, {left, 0, z1}}, edge);
  }
}

}  // namespace

std::span<const SceneOption> stones_options() {
  return kOptions;
}

TerrestrialScan plan_stones(const SceneValues& values, std::uint64_t seed) {
  TerrestrialScan scan = empty_scan(values, seed);
  scan.scene.classes = {{0, "mixed"}, {1, "stones"}, {2, "joint"}, {3, "side 1"}, {4, "side 2"}};
  const Layout at(values);
  FacadeBuilder facade(scan.scene, {}, 1);
  add_stones(facade, at);
  add_joints(facade, at);
  const double side_1 = values.get("scene.side_1"), side_2 = values.get("scene.side_2");
  facade.plate({{0, 0, kFloor}, {0, 0, at.top}, {0, side_1, at.top}, {0, side_1, kFloor}},
               finish(StonesClass::side_1, 0, Material::limestone));
  facade.plate({{at.total, -side_2, kFloor}, {at.total, -side_2, at.top}, {at.total, 0, at.top}, {at.total, 0, kFloor}},
               finish(StonesClass::side_2, 0, Material::limestone));
  const SinCos angle = sin_cos_deg(values.get("scene.angle"));
  const double distance = values.get("scene.distance");
  const Vec3 eye = facade.frame().place(at.total / 2 + distance * angle.sin, distance * angle.cos, 1.6);
  scan.scene.stations = {station_towards(1, eye, bounds_of(scan.scene.model.parts), values.get("scene.step"))};
  const Vec3 margin{0.1, 0.1, 0.1};
  const Box3<Vec3> all = bounds_of(scan.scene.model.parts);
  scan.scene.keep = {all.min - margin, all.max + margin};
  return scan;
}

}  // namespace ilot::scan
