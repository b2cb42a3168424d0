// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/roof_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "engine/deliverables/drawings/building_drawing.h"
#include "engine/deliverables/report/charts.h"
#include "engine/deliverables/report/front_pages.h"
#include "engine/deliverables/report/html.h"
#include "engine/report/progress.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr std::size_t kDrawnOfAKind = 8, kMostDoubtful = 100, kShownDoubtful = 25;
constexpr std::array<const char*, 5> kQualities{"good", "check", "bad", "none", ""};
constexpr std::array<const char*, 5> kQualityNames{"good", "check", "bad", "outline only", "not judged"};

int quality_rank(const BuildingRow& row) {
  for (std::size_t i = 0; i < kQualities.size(); ++i)
    if (row.quality == kQualities[i]) return static_cast<int>(i);
  return static_cast<int>(kQualities.size()) - 1;
}

double share_off(const BuildingRow& row) {
  return std::isfinite(row.explained) ? 1 - row.explained : 0;
}

// The rank is equal for equal ids at any place.
std::uint64_t random_rank(const std::string& id) {
  std::uint64_t hash = id.size();
  for (const char c : id) hash = mix64(hash ^ static_cast<unsigned char>(c));
  return hash;
}

template <class Before>
std::vector<std::size_t> first_solids(const std::vector<BuildingRow>& rows, const Before& before) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].status != "footprint_only" && !rows[i].shape.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return before(rows[a], rows[b]); });
  order.resize(std::min(order.size(), kDrawnOfAKind));
  return order;
}

std::string quality_badge(const BuildingRow& row) {
  const int rank = quality_rank(row);
  return fmt::format("<span class=\"badge series-{}\">{}</span>", rank,
                     kQualityNames.at(static_cast<std::size_t>(rank)));
}

std::string building_link(const BuildingRow& row) {
  return fmt::format("<a href=\"#building/{}\">{}</a>", url_of_path(row.id), html_text(row.id));
}

std::string percent(double share, int digits = 1) {
  return std::isfinite(share) ? number_text(100 * share, digits) + " %" : "";
}

std::string drawings(const char* title, const std::vector<std::size_t>& chosen, const std::vector<BuildingRow>& rows,
                     const std::map<std::uint32_t, std::vector<Vec3>>& points, const SceneFrame& frame) {
  if (chosen.empty()) return {};
  std::string html = fmt::format("<h3>{}</h3>\n<div class=\"drawings\">\n", title);
  for (const std::size_t i : chosen) {
    const BuildingRow& row = rows[i];
    const auto own = points.find(row.unit);
    constexpr int kWide = 300, kHigh = 230;  // pixels
    const std::string svg = oblique_drawing(unpacked_shape(row.shape, frame),
                                            own == points.end() ? std::vector<Vec3>{} : own->second, kWide, kHigh);
    html += fmt::format("<figure>{}<figcaption>{} {} {} faces, RMSE {} m, {} of the points off</figcaption></figure>\n",
                        svg, building_link(row), quality_badge(row), row.faces, number_text(row.rmse_m, 2),
                        percent(share_off(row)));
  }
  return html + "</div>\n";
}

std::string quality_charts(const std::vector<BuildingRow>& rows) {
  std::vector<double> errors;
  std::vector<int> series;
  std::array<double, kQualities.size()> counts{};
  for (const BuildingRow& row : rows) {
    const int rank = quality_rank(row);
    counts.at(static_cast<std::size_t>(rank)) += 1;
    errors.push_back(row.status == "footprint_only" ? NAN : row.rmse_m);
    series.push_back(rank);
  }
  const std::vector<std::string> names(kQualityNames.begin(), kQualityNames.end());
  std::vector<ChartBar> bars;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    std::vector<double> parts(counts.size(), 0);
    parts[i] = counts[i];
    if (counts[i] > 0) bars.push_back({names[i], parts});
  }
  constexpr std::array<double, 8> kEdges{0.02, 0.04, 0.06, 0.1, 0.15, 0.2, 0.3, 0.5};
  return "<div class=\"charts\">" + chart_svg({"Buildings by quality", "quality", names, bars}) +
         chart_svg({"Root mean square distance of points from the solid", "cm", names,
                    histogram(errors, series, names.size(), kEdges, 100, 1)}) +
         "</div>\n";
}

std::string rows_table(const std::vector<BuildingRow>& rows, std::span<const std::size_t> order) {
  HtmlTable table({{"building"},
                   {"quality"},
                   {"why"},
                   {"RMSE, m", true},
                   {"95 % within, m", true},
                   {"points off, %", true},
                   {"area, m²", true},
                   {"faces", true},
                   {"points", true}},
                  true);
  for (const std::size_t i : order) {
    const BuildingRow& row = rows[i];
    table.add({building_link(row), quality_badge(row), html_text(row.reason), number_text(row.rmse_m, 3),
               number_text(row.p95_m, 3), number_text(100 * share_off(row), 1), number_text(row.area_m2, 1),
               grouped(row.faces), grouped(row.points)});
  }
  return table.html();
}

std::string doubtful_table(const std::vector<BuildingRow>& rows) {
  const std::vector<std::size_t> order = most_doubtful(rows, kMostDoubtful);
  if (order.empty()) return {};
  const std::span<const std::size_t> all(order);
  std::string html =
      "<h3>The most doubtful first</h3>\n" + rows_table(rows, all.first(std::min(all.size(), kShownDoubtful)));
  if (all.size() > kShownDoubtful)
    html += fmt::format("<details><summary>The next {}</summary>{}</details>\n", all.size() - kShownDoubtful,
                        rows_table(rows, all.subspan(kShownDoubtful)));
  return html;
}

std::string reasons(const std::vector<BuildingRow>& rows) {
  std::map<std::string, std::vector<std::size_t>> of_reason;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].status != "lod22") of_reason[rows[i].status + ": " + reason_kind(rows[i].reason)].push_back(i);
  if (of_reason.empty()) return {};
  HtmlTable table({{"buildings", true}, {"why"}, {"which"}});
  constexpr std::size_t kNamed = 8;
  for (const auto& [reason, of] : of_reason) {
    std::string which;
    for (std::size_t i = 0; i < std::min(of.size(), kNamed); ++i) which += building_link(rows[of[i]]) + " ";
    table.add({grouped(of.size()), html_text(rows[of[0]].status + ": " + rows[of[0]].reason),
               which + (of.size() > kNamed ? "..." : "")});
  }
  return "<h3>Not as LoD2.2</h3>\n" + table.html();
}

}  // namespace

std::set<std::uint32_t> DrawnBuildings::units(const std::vector<BuildingRow>& rows) const {
  std::set<std::uint32_t> units;
  for (const auto* chosen : {&worst, &most_faces, &random})
    for (const std::size_t i : *chosen) units.insert(rows[i].unit);
  return units;
}

DrawnBuildings choose_drawn(const std::vector<BuildingRow>& rows) {
  return {first_solids(rows, [](const BuildingRow& a, const BuildingRow& b) { return share_off(a) > share_off(b); }),
          first_solids(rows, [](const BuildingRow& a, const BuildingRow& b) { return a.faces > b.faces; }),
          first_solids(
              rows, [](const BuildingRow& a, const BuildingRow& b) { return random_rank(a.id) < random_rank(b.id); })};
}

std::vector<std::size_t> most_doubtful(const std::vector<BuildingRow>& rows, std::size_t most) {
  constexpr std::array<int, kQualities.size()> kDoubt{0, 2, 3, 1, 0};  // good, check, bad, outline only, not judged
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].points > 0) order.push_back(i);
  const auto key = [&](std::size_t i) {
    return std::pair(-kDoubt.at(static_cast<std::size_t>(quality_rank(rows[i]))), -share_off(rows[i]));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  order.resize(std::min(order.size(), most));
  return order;
}

std::string roofs_section(const std::vector<BuildingRow>& rows, const DrawnBuildings& drawn,
                          const std::map<std::uint32_t, std::vector<Vec3>>& points, const SceneFrame& frame) {
  return html_section("roofs",
                      fmt::format("Roofs: {} {}", grouped(rows.size()), rows.size() == 1 ? "building" : "buildings"),
                      quality_charts(rows) + doubtful_table(rows) + reasons(rows) +
                          drawings("Most points off their faces", drawn.worst, rows, points, frame) +
                          drawings("Most faces", drawn.most_faces, rows, points, frame) +
                          drawings("Chosen at random", drawn.random, rows, points, frame));
}

}  // namespace ilot
