// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "engine/replay/building_shapes.h"

namespace ilot {
namespace {

std::vector<std::vector<FlatPoint>> flat(const SitePolygon& polygon) {
  std::vector<std::vector<FlatPoint>> rings;
  for (const auto& ring : polygon) {
    auto& placed = rings.emplace_back();
    for (const Point2 p : ring) placed.push_back({p.x * 0.001, p.y * 0.001});
  }
  return rings;
}

void add_outline(Picture& picture, const SitePolygon& polygon, PictureColour colour, bool dashed = false) {
  for (auto& ring : flat(polygon)) {
    ring.push_back(ring[0]);
    picture.lines.push_back({std::move(ring), colour, dashed});
  }
}

Picture begin(const BuildingReplay& b, const char* name, const std::string& title) {
  return {name, "building " + b.planned.id + ": " + title, {}, {}, {}, {}, {}, true};
}

PictureColour colour_of(const SeenPoint& p) {
  if (p.number) return kBlue;
  if (p.membership == PointMembership::ground) return kBrown;
  if (p.membership == PointMembership::held) return kRed;
  return p.role == PointRole::building ? PictureColour{150, 170, 210} : kPale;
}

Picture point_picture(const BuildingReplay& b, const std::vector<SeenPoint>& seen) {
  Picture picture = begin(b, "1-points", "points and outlines");
  for (const SeenPoint& p : seen) picture.points.push_back({{p.at.x, p.at.y}, colour_of(p)});
  for (const PlannedSite& other : b.around)
    add_outline(picture, seen_from(other.outline, b.planned.outline.x, b.planned.outline.y), kGrey, true);
  add_outline(picture, b.planned.outline.polygon, kInk);
  picture.legend = {{kBlue, "the building's"},
                    {kRed, "in its outline, of another class or too low"},
                    {kBrown, "ground that its height is taken from"},
                    {{150, 170, 210}, "of other buildings"},
                    {kPale, "others"}};
  return picture;
}

Picture plane_picture(const BuildingReplay& b) {
  Picture picture = begin(b, "2-planes", std::to_string(b.steps.roof.planes.planes.size()) + " planes");
  const RoofPlanes& planes = b.steps.roof.planes;
  const auto& points = b.steps.roof.points;
  for (std::size_t i = 0; i < planes.of_point.size(); ++i) {
    const std::uint32_t plane = planes.of_point[i];
    const PictureColour colour = plane > 0 ? colour_of_number(plane) : planes.on_wall[i] != 0 ? kInk : kGrey;
    picture.points.push_back({{points[i].x, points[i].y}, colour});
  }
  const std::vector<SitePolygon> hulls = plane_hulls(b.steps);
  for (std::size_t n = 0; n < hulls.size(); ++n) add_outline(picture, hulls[n], colour_of_number(n + 1));
  add_outline(picture, b.planned.outline.polygon, kInk);
  picture.legend = {{kInk, "points on walls"}, {kGrey, "points on no plane"}};
  return picture;
}

Picture line_picture(const BuildingReplay& b) {
  Picture picture = begin(b, "3-lines", std::to_string(b.steps.roof.lines.size()) + " lines that part the outline");
  const RoofPlanes& planes = b.steps.roof.planes;
  const auto& points = b.steps.roof.points;
  for (std::size_t i = 0; i < planes.of_point.size(); ++i)
    picture.points.push_back({{points[i].x, points[i].y}, light(colour_of_number(planes.of_point[i]))});
  add_outline(picture, b.planned.outline.polygon, kInk);
  for (const FlatEdge& e : b.steps.roof.lines) picture.lines.push_back({{e.a, e.b}, kRed, false});
  return picture;
}

void add_regions(Picture& picture, const Partition& partition, const std::function<PictureColour(std::size_t)>& colour,
                 PictureColour edge) {
  const std::vector<SitePolygon> regions = region_polygons(partition);
  for (std::size_t r = 0; r < regions.size(); ++r) picture.areas.push_back({flat(regions[r]), light(colour(r)), edge});
}

Picture cell_picture(const BuildingReplay& b) {
  const RoofSteps& roof = b.steps.roof;
  Picture picture = begin(b, "4-cells", std::to_string(roof.cells.regions) + " cells, in the colours of their planes");
  const auto colour = [&](std::size_t r) { return colour_of_number(r < roof.label.size() ? roof.label[r] : 0); };
  add_regions(picture, roof.cells, colour, kGrey);
  add_outline(picture, b.planned.outline.polygon, kInk);
  return picture;
}

Picture face_picture(const BuildingReplay& b) {
  const RoofSteps& roof = b.steps.roof;
  Picture picture = begin(b, "5-faces", std::to_string(roof.faces.regions) + " faces and the points off them");
  add_regions(
      picture, roof.faces, [](std::size_t r) { return colour_of_number(r + 1); }, kInk);
  const auto& points = b.steps.roof.points;
  const auto& faces = b.steps.face_of_point;
  for (std::size_t i = 0; i < std::min(points.size(), faces.size()); ++i)
    if (faces[i] == 0) picture.points.push_back({{points[i].x, points[i].y}, kRed});
  picture.legend = {{kRed, "points on no face"}};
  return picture;
}

// The axes of a view from the side and above, of unit length.
struct Oblique {
  Vec3 right{0.8660254037844387, -0.5, 0};
  Vec3 up{0.25, 0.4330127018922193, 0.8660254037844387};
  Vec3 towards{-0.4330127018922193, -0.75, 0.5};
};

PictureColour shaded(SurfaceKind kind, Vec3 normal) {
  const Vec3 light_from{-0.5, -0.3, 0.81};
  const double length = std::max(norm(normal), 1e-12), share = 0.72 + 0.28 * dot(normal, light_from) / length;
  const PictureColour base = kind == SurfaceKind::roof ? PictureColour{205, 95, 75} : PictureColour{225, 220, 205};
  PictureColour colour{};
  for (std::size_t c = 0; c < 3; ++c) colour[c] = static_cast<std::uint8_t>(base[c] * std::clamp(share, 0.3, 1.0));
  return colour;
}

Vec3 normal_of(const std::vector<Vec3>& ring) {
  Vec3 sum;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum = sum + cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]);
  return sum;
}

// Returns a surface as it is seen; nullopt when it faces away.
std::optional<PictureArea> seen_area(const Building& level, const BuildingSurface& surface, Vec3 anchor,
                                     double metres) {
  const Oblique view;
  PictureArea area;
  std::vector<Vec3> outer;
  for (const auto& ring : surface.rings) {
    auto& drawn = area.rings.emplace_back();
    for (const std::uint32_t v : ring) {
      const Vec3 p = metres * (level.vertices[v] - anchor);
      drawn.push_back({dot(p, view.right), dot(p, view.up)});
      if (&ring == &surface.rings[0]) outer.push_back(p);
    }
  }
  const Vec3 normal = normal_of(outer);
  const double facing = dot(normal, view.towards);
  if (facing <= 1e-6 * norm(normal)) return std::nullopt;
  area.depth = {-dot(normal, view.right) / facing, -dot(normal, view.up) / facing, dot(normal, outer[0]) / facing};
  area.colour = shaded(surface.kind, normal);
  area.edge = kInk;
  return area;
}

Picture solid_picture(const BuildingReplay& b) {
  const Building& level = b.result.levels.back();
  Picture picture = begin(b, "6-solid", "the solid, LoD " + level.lod);
  for (const BuildingSurface& surface : level.surfaces)
    if (auto area = seen_area(level, surface, b.steps.gathered.site.anchor, b.file.metres_per_unit))
      picture.areas.push_back(std::move(*area));
  return picture;
}

}  // namespace

std::vector<Picture> pictures_of(const BuildingReplay& b) {
  return {point_picture(b, seen_points(b)),
          plane_picture(b),
          line_picture(b),
          cell_picture(b),
          face_picture(b),
          solid_picture(b)};
}

}  // namespace ilot
