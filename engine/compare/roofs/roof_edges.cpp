// SPDX-License-Identifier: Apache-2.0
// The edges of roof faces, of models and of the truth.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "engine/compare/roofs/wireframe.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

using Place = std::array<std::int64_t, 3>;  // steps of kSameCorner
using PlacePair = std::pair<Place, Place>;

Place place_of(Vec3 offset, double metres_per_unit) {
  const double steps = metres_per_unit / kSameCorner;
  return {std::llround(offset.x * steps), std::llround(offset.y * steps), std::llround(offset.z * steps)};
}

Place in_plan(Place p) {
  return {p[0], p[1], 0};
}

PlacePair pair_of(const Place& a, const Place& b) {
  return a < b ? PlacePair{a, b} : PlacePair{b, a};
}

// The corners of a ring without those that repeat their predecessor.
std::vector<Vec3> corners_of(const PolygonModel& model, const std::vector<std::uint32_t>& ring,
                             double metres_per_unit) {
  std::vector<Vec3> corners;
  for (const std::uint32_t i : ring) {
    const Vec3 p = model.vertices[i] - model.vertices[0];
    if (corners.empty() || place_of(corners.back(), metres_per_unit) != place_of(p, metres_per_unit))
      corners.push_back(p);
  }
  while (corners.size() > 1 && place_of(corners.front(), metres_per_unit) == place_of(corners.back(), metres_per_unit))
    corners.pop_back();
  return corners;
}

// The corners at which the ring bends; all of them where fewer than three do.
std::vector<Vec3> bends_of(const std::vector<Vec3>& corners) {
  const double straight = cos_degrees(kStraightDeg);
  std::vector<Vec3> kept;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 in = corners[i] - corners[(i + n - 1) % n], out = corners[(i + 1) % n] - corners[i];
    if (dot(in, out) < straight * norm(in) * norm(out)) kept.push_back(corners[i]);
  }
  return kept.size() < 3 ? corners : kept;
}

bool in_one_plane(const PolygonModel& model, const PolygonFace& a, const PolygonFace& b, double most) {
  const auto near = [&](const PolygonFace& plane, const PolygonFace& other) {
    const Vec3 n = face_normal(model, plane), at = model.vertices[plane.rings[0][0]];
    return std::all_of(other.rings[0].begin(), other.rings[0].end(),
                       [&](std::uint32_t i) { return std::abs(dot(n, model.vertices[i] - at)) <= most * norm(n); });
  };
  return near(a, b) && near(b, a);
}

std::set<PlacePair> ground_edges(const PolygonModel& model, double metres_per_unit) {
  std::set<PlacePair> edges;
  for (const PolygonFace& face : model.faces) {
    if (face.kind != FaceKind::ground) continue;
    for (const auto& ring : face.rings) {
      const std::vector<Vec3> corners = corners_of(model, ring, metres_per_unit);
      for (std::size_t i = 0; i < corners.size(); ++i)
        edges.insert(pair_of(in_plan(place_of(corners[i], metres_per_unit)),
                             in_plan(place_of(corners[(i + 1) % corners.size()], metres_per_unit))));
    }
  }
  return edges;
}

}  // namespace

std::vector<RoofEdge> roof_edges(const PolygonModel& model, double metres_per_unit) {
  struct Found {
    RoofEdge edge;
    std::vector<std::size_t> faces;
  };
  std::map<PlacePair, Found> found;
  const std::vector<bool> roofs = roof_faces(model, metres_per_unit);
  for (std::size_t f = 0; f < model.faces.size(); ++f) {
    if (!roofs[f]) continue;
    for (const auto& ring : model.faces[f].rings) {
      const std::vector<Vec3> corners = bends_of(corners_of(model, ring, metres_per_unit));
      for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
        const Vec3 a = corners[i], b = corners[(i + 1) % corners.size()];
        Found& entry = found[pair_of(place_of(a, metres_per_unit), place_of(b, metres_per_unit))];
        entry.edge.edge = {model.vertices[0] + a, model.vertices[0] + b};
        entry.faces.push_back(f);
      }
    }
  }
  const std::set<PlacePair> ground = ground_edges(model, metres_per_unit);
  std::vector<RoofEdge> edges;
  for (auto& [places, entry] : found) {
    if (entry.faces.size() == 2)
      entry.edge.inside_face =
          in_one_plane(model, model.faces[entry.faces[0]], model.faces[entry.faces[1]], kSameFace / metres_per_unit);
    entry.edge.of_outline = ground.contains(pair_of(in_plan(places.first), in_plan(places.second)));
    edges.push_back(entry.edge);
  }
  return edges;
}

std::vector<Wireframe> true_wireframes(std::span<const TruePlane> planes, double metres_per_unit) {
  std::map<std::uint32_t, PolygonModel> buildings;
  for (const TruePlane& plane : planes) {
    if (plane.class_name != "roof") continue;
    for (const TruePolygon& polygon : plane.polygons) {
      PolygonModel& model = buildings[polygon.building];
      PolygonFace face{{}, FaceKind::roof, 0};
      const auto add_ring = [&](const Ring3& ring) {
        face.rings.emplace_back();
        for (const Vec3& p : ring) {
          face.rings.back().push_back(static_cast<std::uint32_t>(model.vertices.size()));
          model.vertices.push_back(p);
        }
      };
      add_ring(polygon.ring);
      for (const Ring3& hole : polygon.holes) add_ring(hole);
      model.faces.push_back(std::move(face));
    }
  }
  std::vector<Wireframe> wireframes;
  for (const auto& [building, model] : buildings) {
    Wireframe& made = wireframes.emplace_back(Wireframe{std::to_string(building), {}, 0});
    for (const RoofEdge& edge : roof_edges(model, metres_per_unit)) made.edges.push_back(edge.edge);
    made.radius = radius_of(made.edges);
  }
  return wireframes;
}

}  // namespace ilot
