// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/facade_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/deliverables/facade_plan.h"

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

}  // namespace

std::string facade_table(const Facade& facade, double metres_per_unit) {
  constexpr std::array<const char*, 3> kStatus{"seen", "completed", "occluded"};
  std::string table =
      "facade,id,kind,family,row,column,status,width_m,height_m,depth_m,width_error_m,height_error_m,depth_error_m,"
      "x_m,bottom_m,top_m,edges,edges_completed,edges_occluded,edge_error_m,edge_rms_m,moved_m,arcs,points,reason\n";
  for (const FacadeElement& e : facade.elements) {
    const FlatElement flat = flat_element(facade, e, metres_per_unit);
    const auto d = [](double v) { return decimal(v, 4); };
    table += fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", facade.id, e.id, cell(e.kind),
        e.family, e.row, e.column, kStatus[static_cast<std::size_t>(e.status)], d(e.width_m), d(e.height_m),
        d(e.depth_m), d(e.width_error_m), d(e.height_error_m), d(e.depth_error_m), d(flat.box.min_x), d(flat.box.min_y),
        d(flat.box.max_y), e.edges.size(), count_edges(e, DrawnStatus::completed),
        count_edges(e, DrawnStatus::occluded), d(largest(e, [](const FacadeEdge& edge) { return edge.error_m; })),
        d(largest(e, [](const FacadeEdge& edge) { return edge.rms_m; })),
        d(largest(e, [](const FacadeEdge& edge) { return edge.moved_m; })), e.arcs.size(), e.points, cell(e.reason));
  }
  return table;
}

}  // namespace ilot
