// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/facade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/deliverables/drawings/facade_plan.h"

namespace ilot {
namespace {

std::string cell(const std::string& given) {
  std::string text = clean_text(given);
  if (!text.empty() && std::string_view("=+-@").find(text[0]) != std::string_view::npos) text.insert(0, 1, '\'');
  if (text.find_first_of(",\"'") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

std::size_t count_edges(const FacadeElement& e, DrawnStatus status) {
  return static_cast<std::size_t>(
      std::count_if(e.edges.begin(), e.edges.end(), [&](const FacadeEdge& edge) { return edge.status == status; }));
}

template <class Get>
double largest(const FacadeElement& e, Get get) {
  double most = 0;
  for (const FacadeEdge& edge : e.edges) most = std::max(most, get(edge));
  return most;
}

// The largest error of an element's edges, or "by hand" where a person drew one of them.
std::string edge_error_text(const FacadeElement& e) {
  if (count_edges(e, DrawnStatus::by_hand) > 0) return name_of(DrawnStatus::by_hand);
  return decimal(largest(e, [](const FacadeEdge& edge) { return edge.error_m; }), 4);
}

// An error of a size. A size between edges that a person drew has none.
std::string size_error_text(const FacadeElement& e, double error_m) {
  const bool by_hand = error_m == 0 && count_edges(e, DrawnStatus::by_hand) > 0;
  return by_hand ? name_of(DrawnStatus::by_hand) : decimal(error_m, 4);
}

std::uint64_t least_support(const FacadeElement& e) {
  std::uint64_t least = e.edges.empty() ? 0 : e.edges[0].points;
  for (const FacadeEdge& edge : e.edges) least = std::min(least, edge.points);
  return least;
}

// Returns the covered and the occluded share of the length of all edges; empty when no station is known.
std::string shares_of(const FacadeElement& e, double metres_per_unit) {
  double covered = 0, hidden = 0, whole = 0;
  bool known = true;
  for (std::size_t i = 0; i < e.edges.size() && i < e.ring.size(); ++i) {
    const double length = metres_per_unit * norm(e.ring[(i + 1) % e.ring.size()] - e.ring[i]);
    covered += length * e.edges[i].covered_share;
    hidden += length * e.edges[i].occluded_share.value_or(0);
    known &= e.edges[i].occluded_share.has_value();
    whole += length;
  }
  if (!(whole > 0)) return ",";
  return decimal(covered / whole, 3) + "," + (known ? decimal(hidden / whole, 3) : "");
}

}  // namespace

std::string facade_table(const Facade& facade, double metres_per_unit) {
  std::string table =
      "facade,id,kind,family,row,column,status,width_m,height_m,depth_m,width_error_m,height_error_m,depth_error_m,"
      "x_m,bottom_m,top_m,edges,edges_completed,edges_occluded,edge_error_m,edge_points,edge_rms_m,covered_share,"
      "occluded_share,"
      "moved_m,arcs,points,reason\n";
  for (const FacadeElement& e : facade.elements) {
    const FlatElement flat = flat_element(facade, e, metres_per_unit);
    const auto d = [](double v) { return decimal(v, 4); };
    table += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", facade.id, e.id,
        cell(e.kind), e.family, e.row, e.column, name_of(e.status), d(e.width_m), d(e.height_m), d(e.depth_m),
        size_error_text(e, e.width_error_m), size_error_text(e, e.height_error_m), size_error_text(e, e.depth_error_m),
        d(flat.box.min.x), d(flat.box.min.y), d(flat.box.max.y), e.edges.size(), count_edges(e, DrawnStatus::completed),
        count_edges(e, DrawnStatus::occluded), edge_error_text(e), least_support(e),
        d(largest(e, [](const FacadeEdge& edge) { return edge.rms_m; })), shares_of(e, metres_per_unit),
        d(largest(e, [](const FacadeEdge& edge) { return edge.moved_m; })), e.arcs.size(), e.points, cell(e.reason));
  }
  return table;
}

}  // namespace ilot
