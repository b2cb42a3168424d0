// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawing_control.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "engine/error.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kSamePlace = 1e-5, kMoved = 1e-4;  // metres
constexpr std::size_t kMostReported = 20;           // vertices in the table
constexpr std::size_t kMostCandidates = 64;         // candidates of one vertex, the nearest ones

// The different positions, sorted by x, then y.
std::vector<FlatPoint> vertices_of(const DxfDrawing& drawing, const std::set<std::string>& layers) {
  std::set<std::pair<std::int64_t, std::int64_t>> steps;
  const auto add = [&](double x, double y) {
    if (std::abs(x) < 1e9 && std::abs(y) < 1e9)
      steps.emplace(std::llround(x / kSamePlace), std::llround(y / kSamePlace));
  };
  for (const DxfEntity& e : drawing.entities) {
    if (!layers.contains(e.layer) || !e.finite || e.corners.empty()) continue;
    if (e.type == "LINE" || e.type == "LWPOLYLINE" || e.type == "POLYLINE")
      for (const DrawingCorner& c : e.corners) add(c.x, c.y);
    if (e.type != "ARC") continue;
    for (const double degrees : {e.from_deg, e.to_deg})
      add(e.corners[0].x + e.radius * cos_degrees(degrees), e.corners[0].y + e.radius * cos_degrees(degrees - 90));
  }
  std::vector<FlatPoint> places;
  for (const auto& [x, y] : steps)
    places.push_back({kSamePlace * static_cast<double>(x), kSamePlace * static_cast<double>(y)});
  return places;
}

struct CorrectedPair {
  double distance = 0;
  std::size_t ours = 0, corrected = 0;
};

std::vector<CorrectedPair> pairs_within(const std::vector<FlatPoint>& ours, const std::vector<FlatPoint>& corrected,
                                        double limit) {
  const auto before = [](const CorrectedPair& a, const CorrectedPair& b) {
    return std::tie(a.distance, a.corrected, a.ours) < std::tie(b.distance, b.corrected, b.ours);
  };
  std::vector<CorrectedPair> pairs;
  for (std::size_t c = 0; c < corrected.size(); ++c) {
    std::vector<CorrectedPair> near;
    auto at = std::lower_bound(ours.begin(), ours.end(), corrected[c].x - limit,
                               [](const FlatPoint& p, double x) { return p.x < x; });
    for (; at != ours.end() && at->x <= corrected[c].x + limit; ++at) {
      const double dx = at->x - corrected[c].x, dy = at->y - corrected[c].y, distance = std::sqrt(dx * dx + dy * dy);
      if (distance <= limit) near.push_back({distance, static_cast<std::size_t>(at - ours.begin()), c});
    }
    const std::size_t kept = std::min(near.size(), kMostCandidates);
    std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end(), before);
    pairs.insert(pairs.end(), near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept));
  }
  std::sort(pairs.begin(), pairs.end(), before);
  return pairs;
}

LayerControl evaluate_layer(const std::string& name, const std::vector<FlatPoint>& ours,
                            const std::vector<FlatPoint>& corrected, double limit) {
  LayerControl control{name, corrected.size(), 0, 0, 0, 0, {}, {}, {}, {}, {}, 0, {}};
  std::vector<char> taken_ours(ours.size()), taken(corrected.size());
  std::vector<double> dx, dz, dd, signed_dx, signed_dz;
  for (const CorrectedPair& pair : pairs_within(ours, corrected, limit)) {
    if (taken_ours[pair.ours] || taken[pair.corrected]) continue;
    taken_ours[pair.ours] = taken[pair.corrected] = 1;
    signed_dx.push_back(ours[pair.ours].x - corrected[pair.corrected].x);
    signed_dz.push_back(ours[pair.ours].y - corrected[pair.corrected].y);
    dx.push_back(std::abs(signed_dx.back()));
    dz.push_back(std::abs(signed_dz.back()));
    dd.push_back(pair.distance);
    if (pair.distance > kMoved)
      control.vertices.push_back({corrected[pair.corrected].x, corrected[pair.corrected].y, signed_dx.back(),
                                  signed_dz.back(), pair.distance});
    control.largest_m = std::max(control.largest_m, pair.distance);
  }
  std::stable_sort(control.vertices.begin(), control.vertices.end(),
                   [](const VertexControl& a, const VertexControl& b) { return a.dd > b.dd; });
  control.moved = control.vertices.size();
  control.paired = dd.size();
  control.missed = corrected.size() - dd.size();
  control.removed = ours.size() - dd.size();
  control.dx_m = mean_and_spread(dx);
  control.dz_m = mean_and_spread(dz);
  control.dd_m = mean_and_spread(dd);
  control.signed_dx_m = mean_and_spread(signed_dx);
  control.signed_dz_m = mean_and_spread(signed_dz);
  return control;
}

nlohmann::ordered_json spread_json(const MeanAndSpread& v) {
  return {{"mean_m", v.mean}, {"sd_m", v.sd}};
}

nlohmann::ordered_json control_json(const std::vector<VertexControl>& vertices) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const VertexControl& v : vertices)
    list.push_back({{"x", v.x}, {"z", v.z}, {"dx_m", v.dx}, {"dz_m", v.dz}, {"dd_m", v.dd}});
  return list;
}

}  // namespace

void check_drawing_units(const DxfDrawing& drawing, const char* which) {
  constexpr std::int64_t kMetres = 6;
  if (drawing.units.value_or(0) != kMetres)
    throw Error(std::string(which) + " is not in metres ($INSUNITS 6): scale it first", ExitCode::usage);
}

std::vector<LayerControl> compare_drawings(const DxfDrawing& ours, const DxfDrawing& corrected,
                                           const DrawingControlParams& params) {
  check_drawing_units(ours, "our drawing");
  check_drawing_units(corrected, "the corrected drawing");
  std::vector<LayerControl> layers;
  std::set<std::string> all;
  for (auto role = DrawingRole::outline; role <= DrawingRole::completed;
       role = static_cast<DrawingRole>(static_cast<int>(role) + 1)) {
    const std::string& name = params.layers[role].name;
    if (!all.insert(name).second) continue;
    const auto a = vertices_of(ours, {name}), b = vertices_of(corrected, {name});
    if (!a.empty() || !b.empty()) layers.push_back(evaluate_layer(name, a, b, params.limit_m));
  }
  layers.push_back(evaluate_layer("", vertices_of(ours, all), vertices_of(corrected, all), params.limit_m));
  return layers;
}

std::string drawing_control_text(const std::vector<LayerControl>& layers) {
  std::string text =
      fmt::format("{:<16}{:>9}{:>8}{:>8}{:>8}{:>8}{:>16}{:>16}{:>16}{:>10}\n", "layer", "corrected", "paired", "missed",
                  "removed", "moved", "dX cm (s.d.)", "dZ cm (s.d.)", "dD cm (s.d.)", "most cm");
  const auto cm = [](const MeanAndSpread& v) { return fmt::format("{:.2f} ({:.2f})", 100 * v.mean, 100 * v.sd); };
  for (const LayerControl& c : layers)
    text += fmt::format("{:<16}{:>9}{:>8}{:>8}{:>8}{:>8}{:>16}{:>16}{:>16}{:>10.2f}\n",
                        c.layer.empty() ? "all" : c.layer, c.corrected, c.paired, c.missed, c.removed, c.moved,
                        cm(c.dx_m), cm(c.dz_m), cm(c.dd_m), 100 * c.largest_m);
  const std::vector<VertexControl>& moved = layers.back().vertices;
  if (!moved.empty()) text += fmt::format("\n{:>12}{:>12}{:>10}{:>10}{:>10}\n", "x", "z", "dX cm", "dZ cm", "dD cm");
  for (std::size_t i = 0; i < std::min(moved.size(), kMostReported); ++i)
    text += fmt::format("{:>12.3f}{:>12.3f}{:>10.2f}{:>10.2f}{:>10.2f}\n", moved[i].x, moved[i].z, 100 * moved[i].dx,
                        100 * moved[i].dz, 100 * moved[i].dd);
  return text;
}

std::string drawing_control_json(const std::vector<LayerControl>& layers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const LayerControl& c : layers)
    list.push_back({{"layer", c.layer.empty() ? "all" : c.layer},
                    {"corrected", c.corrected},
                    {"paired", c.paired},
                    {"missed", c.missed},
                    {"removed", c.removed},
                    {"moved", c.moved},
                    {"dx", spread_json(c.dx_m)},
                    {"dz", spread_json(c.dz_m)},
                    {"dd", spread_json(c.dd_m)},
                    {"signed_dx", spread_json(c.signed_dx_m)},
                    {"signed_dz", spread_json(c.signed_dz_m)},
                    {"largest_m", c.largest_m},
                    {"vertices", control_json(c.vertices)}});
  const nlohmann::ordered_json whole{{"drawing", std::move(list)}};
  return whole.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace ilot
