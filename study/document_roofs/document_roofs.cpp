// SPDX-License-Identifier: Apache-2.0
// Tests Boltcheva's roof polygons [D5 to D9] as they are described, on the scene `roofs`. Prints the share of buildings
// whose polygons close before vertices are projected, and the share that is still right afterwards. Our own models are
// measured in the same way.
//
// The document counts a roof as done when the walk around the polygon of each label returns to its first vertex and the
// polygon is not degenerate. After projection, a roof is done when no vertex was put in a wrong position. The document
// does not define degenerate and wrong. Here, a polygon must have at least three corners and an area, and must not
// touch itself in plan. After projection the same conditions apply, and the polygon must keep its sense of rotation.
// Every vertex must be within 1 cm of the planes of all its faces and must have moved by less than --move (1 m) in
// plan. Planes without a common point are a failure. Outlines of windows that meet no other line get no polygon. The
// document leaves them out on purpose, so they are counted separately ("no face lost"). A dormer at the eaves or the
// ridge meets other lines in only two vertices, so its polygon is a line. It is open by the definition of the document,
// and a second count leaves it out like a window ("lines left out").
//
// Where the document is ambiguous, the reading that fails less is taken: its longest boundary chain is used, vertices
// where planes meet are never removed, and the line between two faces ends in the middle of the boundary's edge. Its
// walk takes any unvisited neighbour that has the label ("by vertex"); "by edge" requires that the edge has it, too.
// Planes are fitted by least squares to the points of a label. Labels are the true faces or come from our own plane
// search. In the second case each piece of a plane that is connected in the mesh is a face, and pieces of fewer than
// --least points are left out.
//
// Usage: study_document_roofs ROOFS.laz [--models ROOFS.city.jsonl] [--alpha M] [--radius M] [--move M] [--least N]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/deliverables/solids/model_file.h"
#include "kernels/outlines/simple_ring.h"
#include "study/document_roofs/roof_polygons.h"

namespace {

using namespace ilot;
using namespace ilot::bench;

struct Options {
  std::string cloud, models;
  double alpha = 0.6;   // metres; the document's longest edge
  double radius = 0.4;  // metres; one vertex within it: the width of the narrowest wall of the scene
  double move = 1;      // metres in plan
  std::uint32_t least = 12;
};

struct Row {
  std::string labels, distance, walk;
  std::size_t buildings = 0, faces = 0, polygons = 0, open = 0, degenerate = 0, lost = 0;
  std::size_t closed = 0, closed_all = 0, right = 0, right_all = 0;
  std::size_t lines = 0, other_closed = 0, other_right = 0;  // polygons of two corners; results without these polygons
  std::size_t complex = 0, complex_closed = 0, complex_right = 0;
  std::size_t parallel = 0, moved = 0, not_planar = 0, crossed = 0;  // buildings, by the first fault
};

void count_without_lines(const LabelledRoof& b, const Graph& g, std::vector<FacePolygon> polygons, double move,
                         Row& row) {
  const std::size_t all = polygons.size();
  std::erase_if(polygons, [](const FacePolygon& p) { return p.corners.size() <= 2; });
  row.lines += all - polygons.size();
  if (!all_closed(g, polygons)) return;
  ++row.other_closed;
  row.other_right += projected(g, polygons, planes_of(b), move) == Fault::kNone;
}

void count(const LabelledRoof& b, const Graph& g, Walk walk, double move, Row& row) {
  const std::vector<FacePolygon> polygons = polygons_of(g, b.labels, walk);
  std::vector<Vec3> at;
  for (const Corner& c : g.corners) at.push_back(c.at);
  std::size_t open = 0, degenerate = 0;
  for (const FacePolygon& p : polygons) {
    open += !p.closed;
    degenerate += p.closed && area_of(p, at) == 0;
  }
  const std::size_t lost = b.labels - polygons.size();
  const bool closed = all_closed(g, polygons);
  count_without_lines(b, g, polygons, move, row);
  ++row.buildings;
  row.faces += b.labels;
  row.polygons += polygons.size();
  row.open += open;
  row.degenerate += degenerate;
  row.lost += lost;
  row.closed += closed;
  row.closed_all += closed && lost == 0;
  row.complex += b.complex;
  row.complex_closed += b.complex && closed;
  if (!closed) return;
  const Fault fault = projected(g, polygons, planes_of(b), move);
  row.right += fault == Fault::kNone;
  row.right_all += fault == Fault::kNone && lost == 0;
  row.complex_right += b.complex && fault == Fault::kNone;
  row.parallel += fault == Fault::kParallel;
  row.moved += fault == Fault::kMoved;
  row.not_planar += fault == Fault::kNotPlanar;
  row.crossed += fault == Fault::kCrossed;
}

std::vector<Row> measure(const std::string& name, const std::vector<LabelledRoof>& buildings, const Options& options) {
  std::vector<Row> rows;
  for (const auto& [distance, distance_name] : {std::pair(Distance::kPlan, "I"), std::pair(Distance::kSpace, "II")}) {
    Row by_vertex{name, distance_name, "by vertex"}, by_edge{name, distance_name, "by edge"};
    for (const LabelledRoof& b : buildings) {
      const Graph g = graph_of(eroded(b.points, options.alpha, distance), b, options.radius);
      count(b, g, Walk::kByVertex, options.move, by_vertex);
      count(b, g, Walk::kByEdge, options.move, by_edge);
    }
    rows.push_back(by_vertex);
    rows.push_back(by_edge);
  }
  return rows;
}

struct Ours {
  std::size_t models = 0, closed = 0, right = 0, faces = 0;
};

// Returns whether a roof face of a model is right: its corners are within 1 cm of one plane, and its outer ring is
// simple in plan.
bool is_right(const PolygonModel& m, const PolygonFace& face) {
  const auto& ring = face.rings.at(0);
  const Vec3 first = m.vertices[ring[0]];
  std::vector<Point2> plan;
  Vec3 centre;
  for (const std::uint32_t v : ring) {
    plan.push_back(place_of(m.vertices[v] - first));
    centre = centre + (1.0 / static_cast<double>(ring.size())) * (m.vertices[v] - first);
  }
  const Vec3 normal = face_normal(m, face);
  const double length = norm(normal);
  if (length == 0 || !is_simple_ring(plan)) return false;
  for (const auto& r : face.rings)
    for (const std::uint32_t v : r)
      if (std::abs(dot(normal, m.vertices[v] - first - centre)) > kPlanar * length) return false;
  return true;
}

Ours evaluate_building_models(const std::string& file) {
  Ours ours;
  for (const PolygonModel& m : read_models(file).models) {
    const std::vector<bool> roof = roof_faces(m);
    bool right = true;
    for (std::size_t i = 0; i < m.faces.size(); ++i)
      if (roof[i]) {
        ++ours.faces;
        right = right && is_right(m, m.faces[i]);
      }
    ++ours.models;
    const bool closed = is_closed(m);
    ours.closed += closed;
    ours.right += closed && right;
  }
  return ours;
}

double percent(std::size_t n, std::size_t of) {
  return of == 0 ? 0 : 100 * static_cast<double>(n) / static_cast<double>(of);
}

// Returns the percentages of all roofs, of gables and hips, and of complex roofs.
std::string shares(const Row& r, std::size_t all, std::size_t complex) {
  return fmt::format("{:.1f} ({:.1f}, {:.1f})", percent(all, r.buildings),
                     percent(all - complex, r.buildings - r.complex), percent(complex, r.complex));
}

void print_row(const Row& r) {
  fmt::print("| {} | {} | {} | {} | {} | {} | ", r.labels, r.distance, r.walk, r.buildings,
             shares(r, r.closed, r.complex_closed), shares(r, r.right, r.complex_right));
  for (const std::size_t n : {r.closed_all, r.right_all, r.other_closed, r.other_right})
    fmt::print("{:.1f} | ", percent(n, r.buildings));
  fmt::print("{} / {} / {} / {} | {} / {} / {} / {} |\n", r.open, r.lines, r.degenerate, r.lost, r.parallel, r.moved,
             r.not_planar, r.crossed);
}

nlohmann::ordered_json json_of(const Row& r) {
  return {{"labels", r.labels},
          {"erosion", r.distance},
          {"walk", r.walk},
          {"buildings", r.buildings},
          {"faces", r.faces},
          {"polygons", r.polygons},
          {"closed", r.closed},
          {"closed_no_face_lost", r.closed_all},
          {"projected", r.right},
          {"projected_no_face_lost", r.right_all},
          {"complex", r.complex},
          {"complex_closed", r.complex_closed},
          {"complex_projected", r.complex_right},
          {"closed_lines_left_out", r.other_closed},
          {"projected_lines_left_out", r.other_right},
          {"faces_line", r.lines},
          {"faces_open", r.open},
          {"faces_degenerate", r.degenerate},
          {"faces_lost", r.lost},
          {"failed_parallel", r.parallel},
          {"failed_moved", r.moved},
          {"failed_not_planar", r.not_planar},
          {"failed_crossed", r.crossed}};
}

Options options_of(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    if (key.rfind("--", 0) != 0) {
      o.cloud = key;
      continue;
    }
    if (i + 1 == argc) throw std::runtime_error(key + " needs a value");
    const std::string value = argv[++i];
    if (key == "--models")
      o.models = value;
    else if (key == "--alpha")
      o.alpha = std::stod(value);
    else if (key == "--radius")
      o.radius = std::stod(value);
    else if (key == "--move")
      o.move = std::stod(value);
    else if (key == "--least")
      o.least = static_cast<std::uint32_t>(std::stoul(value));
    else
      throw std::runtime_error("no option " + key);
  }
  if (o.cloud.empty())
    throw std::runtime_error(
        "usage: study_document_roofs ROOFS.laz [--models ROOFS.city.jsonl] [--alpha M] [--radius M] [--move M] "
        "[--least POINTS]");
  return o;
}

}  // namespace

int main(int argc, char** argv) try {
  const Options options = options_of(argc, argv);
  const std::vector<LabelledRoof> truth = read_buildings(options.cloud);
  std::vector<LabelledRoof> found;
  for (const LabelledRoof& b : truth) found.push_back(relabelled(b, options.alpha, options.least));
  std::vector<Row> rows = measure("true faces", truth, options);
  for (Row& r : measure("our planes", found, options)) rows.push_back(std::move(r));
  fmt::print(
      "| labels | erosion | walk | buildings | closed, % (gables and hips, complex) | after projection | closed and no "
      "face lost, % | after projection | closed, lines left out, % | after projection | faces open / of these lines / "
      "degenerate / lost | buildings failed: parallel / moved / not planar / crossed |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  nlohmann::ordered_json line{{"bench", "document_roofs"},
                              {"alpha_m", options.alpha},
                              {"radius_m", options.radius},
                              {"move_m", options.move},
                              {"rows", nlohmann::ordered_json::array()}};
  for (const Row& r : rows) {
    print_row(r);
    line["rows"].push_back(json_of(r));
  }
  if (!options.models.empty()) {
    const Ours ours = evaluate_building_models(options.models);
    fmt::print("| our models | | | {} | {:.1f} | {:.1f} | | | | | | |\n", ours.models,
               percent(ours.closed, ours.models), percent(ours.right, ours.models));
    line["models"] = {
        {"models", ours.models}, {"roof_faces", ours.faces}, {"closed", ours.closed}, {"closed_planar", ours.right}};
  }
  fmt::print("{}\n", line.dump());
} catch (const std::exception& fault) {
  fmt::print(stderr, "study_document_roofs: {}\n", fault.what());
  return 1;
}
