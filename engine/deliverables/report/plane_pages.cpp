// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/plane_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/deliverables/maps/street_map.h"
#include "engine/deliverables/report/charts.h"
#include "engine/deliverables/report/html.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/model/street_areas.h"
#include "engine/report/progress.h"

namespace ilot {
namespace {

constexpr std::size_t kListedPlanes = 150, kListedObjects = 100, kMostOnMap = 8000;

bool is_larger(const Segment& a, const Segment& b) {
  return std::pair(-a.area_m2, a.id) < std::pair(-b.area_m2, b.id);
}

void keep_largest(std::vector<Segment>& planes, std::size_t most) {
  if (planes.size() <= most) return;
  std::nth_element(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(most), planes.end(), is_larger);
  planes.resize(most);
}

std::string plane_charts(const PlanesOfReport& planes, const SampledPoints& sample) {
  const std::vector<int> one(planes.rms_m.size(), 0);
  constexpr std::array<double, 7> kRms{0.002, 0.005, 0.01, 0.02, 0.03, 0.05, 0.1};
  constexpr std::array<double, 6> kArea{0.1, 1, 5, 20, 100, 500};
  std::string html =
      chart_svg({"Planes by the root mean square distance of their points",
                 "cm",
                 {"planes"},
                 histogram(planes.rms_m, one, 1, kRms, 100, 1)}) +
      chart_svg({"Planes by area of the outline", "m²", {"planes"}, histogram(planes.area_m2, one, 1, kArea, 1, 1)});
  std::vector<double> residuals;
  for (const ScenePoint& p : sample.points)
    if (p.plane > 0) residuals.push_back(p.residual_m);
  constexpr std::array<double, 8> kResiduals{-0.05, -0.02, -0.01, -0.003, 0.003, 0.01, 0.02, 0.05};
  if (!residuals.empty())
    html += chart_svg(
        {fmt::format("Distances of points from their planes ({} points drawn at random)", grouped(residuals.size())),
         "cm, positive above the plane",
         {"points"},
         histogram(residuals, std::vector<int>(residuals.size(), 0), 1, kResiduals, 100, 1)});
  return "<div class=\"charts\">" + html + "</div>\n";
}

std::string planes_table(const std::vector<Segment>& planes, const char* title) {
  HtmlTable table({{"plane"},
                   {"area, m²", true},
                   {"points", true},
                   {"RMS, mm", true},
                   {"within, mm", true},
                   {"slope, °", true},
                   {"confidence", true},
                   {"neighbours", true}},
                  true);
  for (const Segment& s : planes) {
    constexpr double kDegrees = 57.29577951308232;
    table.add({fmt::format("<a href=\"#plane/{0}\">{0}</a>", s.id), number_text(s.area_m2, 2), grouped(s.points),
               number_text(1000 * s.rms_m, 1), number_text(1000 * s.epsilon_m, 0),
               number_text(kDegrees * std::acos(std::clamp(std::abs(s.plane.n.z), 0.0, 1.0)), 1),
               number_text(s.confidence, 2), grouped(s.neighbours)});
  }
  return fmt::format("<h3>{}</h3>\n", title) + table.html();
}

}  // namespace

PlanesOfReport planes_of_report(const ResultFolder& result, std::size_t most_shown) {
  PlanesOfReport planes;
  if (!result.has("planes.csv")) return planes;
  for_each_plane(result.path / "planes.csv", [&](const Segment& s) {
    ++planes.planes;
    planes.rms_m.push_back(s.rms_m);
    planes.confidence.push_back(s.confidence);
    planes.area_m2.push_back(s.area_m2);
    planes.shown.push_back(s);
    if (planes.shown.size() >= 2 * most_shown) keep_largest(planes.shown, most_shown);
  });
  keep_largest(planes.shown, most_shown);
  std::sort(planes.shown.begin(), planes.shown.end(), [](const Segment& a, const Segment& b) { return a.id < b.id; });
  return planes;
}

std::string planes_section(const PlanesOfReport& planes, const SampledPoints& sample) {
  std::vector<Segment> largest = planes.shown, doubtful;
  std::sort(largest.begin(), largest.end(), is_larger);
  constexpr double kDoubt = 0.5;  // Choice: confidence of noise alone is about 0.9 and of chance below 0.1
  for (const Segment& s : largest)
    if (s.confidence < kDoubt && doubtful.size() < kListedPlanes) doubtful.push_back(s);
  largest.resize(std::min(largest.size(), kListedPlanes));
  std::string content = plane_charts(planes, sample) + planes_table(largest, "The largest, plane by plane");
  if (!doubtful.empty())
    content += "<details><summary>Doubtful ones: confidence below 0.5, the largest first</summary>" +
               planes_table(doubtful, "") + "</details>\n";
  return html_section("planes", fmt::format("Planes: {}", grouped(planes.planes)), content);
}

std::string streets_section(const StreetPlan& plan, double metres_per_unit) {
  std::string content = street_legend_html(plan);
  if (plan.objects.size() <= kMostOnMap)
    for (const StreetPlan& area : street_areas(plan, metres_per_unit))
      content += "<figure class=\"map paper\">" + street_map_svg(area, metres_per_unit) + "</figure>\n";
  else
    content += html_note("The map has too many objects for this page: see the plan above, or streets.pdf.");
  std::vector<StreetObject> doubtful = plan.objects;
  std::stable_sort(doubtful.begin(), doubtful.end(),
                   [](const StreetObject& a, const StreetObject& b) { return a.probability < b.probability; });
  doubtful.resize(std::min(doubtful.size(), kListedObjects));
  HtmlTable table({{"object"},
                   {"class"},
                   {"probability, %", true},
                   {"height, m", true},
                   {"length, m", true},
                   {"width, m", true},
                   {"points", true},
                   {"block"}},
                  true);
  for (const StreetObject& o : doubtful)
    table.add({fmt::format("<a href=\"#object/{0}\">{0}</a>", o.id), html_text(o.class_name),
               o.by_hand ? "by hand" : number_text(100 * o.probability, 0), number_text(o.height_m, 2),
               number_text(o.length_m, 2), number_text(o.width_m, 2), grouped(o.points),
               o.stretch == 0 ? "" : fmt::format("{}.{}", o.stretch, o.block)});
  if (!doubtful.empty()) content += "<h3>Objects, the least certain first</h3>\n" + table.html();
  return html_section(
      "streets",
      fmt::format("Streets: {} {}", grouped(plan.objects.size()), plan.objects.size() == 1 ? "object" : "objects"),
      content);
}

}  // namespace ilot
