// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "engine/replay/cell_replay.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {
namespace {

Layer cell_layer(const CellReplay& r) {
  Layer layer{"cell",
              LayerShape::polygon,
              true,
              {"points", "planes", "seen_from", "epsilon_m", "connectivity_m", "min_points", "normal_angle_deg",
               "step_m", "noise_m"},
              {}};
  const double x = static_cast<double>(r.corner.x) * r.unit, y = static_cast<double>(r.corner.y) * r.unit, e = r.edge;
  const double metres = r.unit * r.metres_per_unit;
  const CellSummary& s = r.summary;
  layer.features.push_back(
      {{{{x, y, 0}, {x + e, y, 0}, {x + e, y + e, 0}, {x, y + e, 0}}},
       {whole(r.points.size()), whole(s.plane_count), std::string(s.from == SeenFrom::air ? "air" : "ground"),
        s.epsilon * metres, static_cast<double>(s.connectivity) * metres, whole(s.min_points), s.normal_angle,
        s.step * metres, s.noise * metres}});
  return layer;
}

Layer point_layer(const CellReplay& r) {
  Layer layer{"points", LayerShape::point, false, {"segment", "plane", "nx", "ny", "nz", "curvature"}, {}};
  for (const CellPoint& p : r.points)
    layer.features.push_back(
        {{{p.at}}, {whole(p.segment), whole(p.plane), p.normal.x, p.normal.y, p.normal.z, p.curvature}});
  return layer;
}

// Returns the planes before the join, each at the middle of its points, with the final plane of most of these points.
Layer segment_layer(const CellReplay& r) {
  Layer layer{"segments", LayerShape::point, false, {"segment", "points", "nx", "ny", "nz", "rms_m", "plane"}, {}};
  std::vector<std::map<std::uint32_t, std::uint64_t>> ends(r.planes.size() + 1);
  for (const CellPoint& p : r.points) ++ends[p.segment][p.plane];
  const auto lattice = [&](std::int64_t corner, double offset) {
    return (static_cast<double>(corner) + offset) * r.unit;
  };
  for (std::size_t n = 0; n < r.planes.size(); ++n) {
    const CellPlane& p = r.planes[n];
    const Vec3 c = centroid(p.moments);
    const auto& of = ends[n + 1];
    const auto most =
        std::max_element(of.begin(), of.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    layer.features.push_back(
        {{{{lattice(r.corner.x, c.x), lattice(r.corner.y, c.y), lattice(r.corner.z, c.z)}}},
         {whole(n + 1), whole(static_cast<std::uint64_t>(p.moments.n)), p.plane.n.x, p.plane.n.y, p.plane.n.z,
          rms_to_plane(p.moments, p.plane) * r.unit * r.metres_per_unit, whole(most == of.end() ? 0 : most->first)}});
  }
  return layer;
}

using ColourOfPoint = std::function<PictureColour(const CellPoint&)>;

PictureColour colour_of_normal(const CellPoint& p) {
  if (norm(p.normal) == 0) return kInk;
  const auto channel = [](double v) { return static_cast<std::uint8_t>(40 + 200 * std::abs(v)); };
  return {channel(p.normal.x), channel(p.normal.y), channel(p.normal.z)};
}

// In a view from the side and above the nearest points are drawn last; in a view from above, the highest ones.
Picture picture_of(const CellReplay& r, const char* name, const std::string& title, bool oblique,
                   const ColourOfPoint& colour) {
  const Vec3 right = oblique ? Vec3{0.8660254037844387, -0.5, 0} : Vec3{1, 0, 0};
  const Vec3 up = oblique ? Vec3{0.25, 0.4330127018922193, 0.8660254037844387} : Vec3{0, 1, 0};
  const Vec3 towards = oblique ? Vec3{-0.4330127018922193, -0.75, 0.5} : Vec3{0, 0, 1};
  const Vec3 corner{static_cast<double>(r.corner.x) * r.unit, static_cast<double>(r.corner.y) * r.unit,
                    static_cast<double>(r.corner.z) * r.unit};
  Picture picture{name, title, {}, {}, {}, {}, {}, true};
  std::vector<std::pair<double, PicturePoint>> points;
  for (const CellPoint& p : r.points) {
    const Vec3 at = r.metres_per_unit * (p.at - corner);
    points.push_back({dot(at, towards), {{dot(at, right), dot(at, up)}, colour(p)}});
  }
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [depth, point] : points) picture.points.push_back(point);
  return picture;
}

}  // namespace

std::vector<Layer> layers_of(const CellReplay& r) {
  return {cell_layer(r), point_layer(r), segment_layer(r)};
}

std::vector<Picture> pictures_of(const CellReplay& r) {
  const auto segment = [](const CellPoint& p) { return colour_of_number(p.segment); };
  const auto plane = [](const CellPoint& p) { return colour_of_number(p.plane); };
  const std::string found = std::to_string(r.planes.size()) + " planes of the cell before the join";
  std::vector<Picture> pictures{
      picture_of(r, "1-normals", "normals: red east, green north, blue up", true, colour_of_normal),
      picture_of(r, "2-segments", found, true, segment),
      picture_of(r, "3-segments-above", found + ", from above", false, segment),
      picture_of(r, "4-planes", "planes after the join and the labels", true, plane),
      picture_of(r, "5-planes-above", "planes after the join and the labels, from above", false, plane)};
  pictures[0].legend = {{kInk, "no normal"}};
  for (std::size_t i = 1; i < pictures.size(); ++i) pictures[i].legend = {{colour_of_number(0), "on no plane"}};
  return pictures;
}

}  // namespace ilot
