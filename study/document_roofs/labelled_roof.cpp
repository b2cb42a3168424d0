// SPDX-License-Identifier: Apache-2.0
#include "study/document_roofs/labelled_roof.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/compare/truth.h"
#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/proof/point_stream.h"
#include "study/document_roofs/roof_graph.h"

namespace ilot::bench {

namespace {

constexpr double kMillimetres = 1000;

bool crosses(Vec3 a, Vec3 b, Vec3 p) {
  return (a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y);
}

bool contains(const Ring3& ring, Vec3 p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (crosses(ring[i], ring[(i + 1) % ring.size()], p)) inside = !inside;
  return inside;
}

double squared_to_ring(const Ring3& ring, Vec3 p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = ring[i], b = ring[(i + 1) % ring.size()];
    nearest = std::min(nearest, squared_distance({p.x, p.y}, {{a.x, a.y}, {b.x, b.y}}));
  }
  return nearest;
}

// Returns the polygon of a plane that contains the point in plan, else the nearest polygon. Adjoining buildings may
// share one plane.
std::size_t polygon_of(const TruePlane& plane, Vec3 p) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; plane.polygons.size() > 1 && i < plane.polygons.size(); ++i) {
    const double d = contains(plane.polygons[i].ring, p) ? -1 : squared_to_ring(plane.polygons[i].ring, p);
    if (d < least) {
      least = d;
      best = i;
    }
  }
  return best;
}

// Reads the kinds of roofs from the truth, in the order of buildings.
void read_kinds(const std::filesystem::path& truth, std::vector<LabelledRoof>& buildings) {
  std::ifstream in(truth);
  const nlohmann::json kinds = nlohmann::json::parse(in).at("buildings");
  for (std::size_t i = 0; i < buildings.size(); ++i) buildings[i].complex = kinds.at(i).at("roof") == "complex";
}

}  // namespace

Point2 place_of(Vec3 p) {
  return lattice_point({p.x, p.y}, kMillimetres);
}

std::vector<LabelledRoof> read_buildings(const std::string& file) {
  std::filesystem::path beside = file;
  beside.replace_extension(".truth.json");
  const Truth truth = read_truth(beside);
  std::map<std::uint32_t, const TruePlane*> planes;
  std::map<std::uint32_t, std::size_t> rank;
  for (const std::uint32_t id : truth.buildings) rank.emplace(id, rank.size());
  std::vector<LabelledRoof> buildings(rank.size());
  read_kinds(beside, buildings);
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> label;
  for (const TruePlane& p : truth.planes) {
    if (p.class_name != "roof") continue;
    planes[p.id] = &p;
    for (std::size_t i = 0; i < p.polygons.size(); ++i)
      label[{p.id, i}] = ++buildings[rank.at(p.polygons[i].building)].labels;
  }
  const auto reader = open_cloud(file);
  const ExtraField field = require_field(reader->info(), "true_plane", FieldType::u32);
  for_each_record(*reader, [&](const std::byte* record) {
    const auto plane = planes.find(static_cast<std::uint32_t>(integer_of(record, field)));
    if (plane == planes.end()) return;
    const Vec3 p = position_of(record, reader->info().layout);
    const std::size_t polygon = polygon_of(*plane->second, p);
    LabelledRoof& b = buildings[rank.at(plane->second->polygons[polygon].building)];
    if (b.points.empty()) b.anchor = p;
    b.points.push_back(p - b.anchor);
    b.label.push_back(label.at({plane->first, polygon}));
  });
  return buildings;
}

LabelledRoof relabelled(const LabelledRoof& truth, double alpha, std::uint32_t least) {
  RoofSite site;
  site.points = truth.points;
  const RoofPlanes planes = find_roof_planes(site, {});
  LabelledRoof on{truth.anchor, {}, {}, 0, truth.complex};
  for (std::size_t i = 0; i < truth.points.size(); ++i)
    if (planes.of_point[i] != 0) {
      on.points.push_back(truth.points[i]);
      on.label.push_back(planes.of_point[i]);
    }
  const Mesh m = eroded(on.points, alpha, Distance::kPlan);
  std::vector<std::vector<std::uint32_t>> near(on.points.size());
  for (std::uint32_t e = 0; e < m.t.corner.size(); ++e) {
    const std::uint32_t p = m.t.corner[e], q = m.t.corner[next_edge(e)];
    if (!m.kept(e) || on.label[p] != on.label[q]) continue;
    near[p].push_back(q);
    near[q].push_back(p);
  }
  LabelledRoof result{truth.anchor, {}, {}, 0, truth.complex};
  std::vector<std::uint8_t> seen(on.points.size());
  for (std::uint32_t s = 0; s < on.points.size(); ++s) {
    if (seen[s] != 0) continue;
    std::vector<std::uint32_t> piece{s};
    seen[s] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (const std::uint32_t q : near[piece[i]])
        if (seen[q] == 0) {
          seen[q] = 1;
          piece.push_back(q);
        }
    if (piece.size() < least) continue;
    ++result.labels;
    for (const std::uint32_t p : piece) {
      result.points.push_back(on.points[p]);
      result.label.push_back(result.labels);
    }
  }
  return result;
}

}  // namespace ilot::bench
