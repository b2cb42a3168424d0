// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/compare/evaluation_report.h"
#include "engine/compare/streets/street_report.h"
#include "engine/markup.h"

namespace ilot {
namespace {

constexpr const char* kStyle = R"(<style>
.ilot-evaluation{--ink:#1d2433;--soft:#5c667a;--line:#d5dae3;--ground:#fff;--good:29,111,165;--bad:200,85,40;
color:var(--ink);background:var(--ground);font:14px/1.45 system-ui,sans-serif;padding:1rem 1.25rem;max-width:60rem}
@media(prefers-color-scheme:dark){:root:not([data-theme="light"]) .ilot-evaluation{--ink:#e6e9f0;--soft:#9aa5b8;
--line:#39414f;--ground:#151a23;--good:96,173,224;--bad:235,137,92}}
:root[data-theme="dark"] .ilot-evaluation{--ink:#e6e9f0;--soft:#9aa5b8;--line:#39414f;--ground:#12161c;
--good:96,173,224;--bad:235,137,92}
main>.ilot-evaluation{padding:0}
.ilot-evaluation h2{font-size:1.15rem;margin:0 0 .2rem}.ilot-evaluation h3{font-size:1rem;margin:1.4rem 0 .4rem}
.ilot-evaluation p{margin:.2rem 0;color:var(--soft)}
.ilot-evaluation table{border-collapse:collapse;font-variant-numeric:tabular-nums}
.ilot-evaluation th,.ilot-evaluation td{padding:.25rem .6rem;text-align:right;border-bottom:1px solid var(--line)}
.ilot-evaluation th{font-weight:600}.ilot-evaluation td:first-child,.ilot-evaluation th:first-child{text-align:left}
.ilot-evaluation .scroll{overflow-x:auto}.ilot-evaluation svg{vertical-align:middle}
.ilot-evaluation .bar{fill:rgb(var(--good))}.ilot-evaluation .rail{fill:var(--line)}
.ilot-evaluation .spread{stroke:rgb(var(--bad));stroke-width:2}
</style>
)";

std::string percent_html(std::optional<double> share) {
  return share ? fmt::format("{:.1f}&nbsp;%", 100 * *share) : "–";
}

std::string metres_html(double v) {
  return std::isfinite(v) ? fmt::format("{:.4f}", v) : "–";
}

// A bar with a length of `share` of its rail, which is 120 pixels long.
std::string bar(double share) {
  const double length = 120 * std::clamp(share, 0.0, 1.0);
  return fmt::format(R"(<svg width="120" height="10" role="img" aria-label="{0:.1f} %"><rect class="rail" width="120" )"
                     R"(height="10" rx="2"/><rect class="bar" width="{1:.1f}" height="10" rx="2"/></svg>)",
                     100 * share, length);
}

// A bar with the length of the mean and the standard deviation on top, in a rail of `most` metres.
std::string spread_bar(const MeanAndSpread& v, double most) {
  const double scale = most > 0 ? 160 / most : 0;
  return fmt::format(R"(<svg width="160" height="12" role="img" aria-label="{0:.4f} m"><rect class="rail" width="160" )"
                     R"(height="12" rx="2"/><rect class="bar" width="{1:.1f}" height="12" rx="2"/>)"
                     R"(<line class="spread" x1="{2:.1f}" x2="{3:.1f}" y1="6" y2="6"/></svg>)",
                     v.mean, scale * v.mean, scale * std::max(0.0, v.mean - v.sd), scale * (v.mean + v.sd));
}

// A cell of the matrix. It is darker the larger its share of the row is; right and wrong results have different hues.
std::string cell(std::uint64_t count, std::uint64_t row, bool right) {
  const double share = row ? static_cast<double>(count) / static_cast<double>(row) : 0;
  if (count == 0) return "<td>0</td>";
  return fmt::format(R"x(<td style="background:rgba(var(--{}),{:.2f})">{}</td>)x", right ? "good" : "bad",
                     0.08 + 0.42 * share, count);
}

std::string confusion_html(const ConfusionMatrix& m, const std::string& title) {
  std::string html = "<h3>" + title + "</h3>\n<div class=\"scroll\"><table><tr><th>true \\ found</th>";
  for (const std::string& name : m.classes) html += "<th>" + escaped_markup(name) + "</th>";
  html += "<th>undetected</th><th>total</th><th>sensitivity</th><th></th></tr>\n";
  std::string foot;
  for (std::size_t c = 0; c < m.classes.size(); ++c) {
    std::uint64_t total = 0;
    for (const std::uint64_t count : m.counts[c]) total += count;
    html += "<tr><td>" + escaped_markup(m.classes[c]) + "</td>";
    for (std::size_t found = 0; found < m.counts[c].size(); ++found)
      html += cell(m.counts[c][found], total, c == found);
    html += fmt::format("<td>{}</td><td>{}</td><td>{}</td></tr>\n", total, percent_html(sensitivity(m, c)),
                        bar(sensitivity(m, c).value_or(0)));
    foot += "<td>" + percent_html(precision(m, c)) + "</td>";
  }
  return html + "<tr><td>precision</td>" + foot + "<td></td><td></td><td><b>" + percent_html(global_sensitivity(m)) +
         "</b></td><td>" + bar(global_sensitivity(m).value_or(0)) + "</td></tr>\n</table></div>\n";
}

std::string figures_html(const std::string& title, const std::vector<std::pair<std::string, std::string>>& figures) {
  std::string head, body;
  for (const auto& [name, value] : figures) {
    head += "<th>" + name + "</th>";
    body += "<td>" + value + "</td>";
  }
  return "<h3>" + title + "</h3>\n<div class=\"scroll\"><table><tr>" + head + "</tr><tr>" + body +
         "</tr></table></div>\n";
}

std::string text_of(std::uint64_t n) {
  return fmt::format("{}", n);
}

std::string planes_html(const PlaneEvaluation& p) {
  const PlaneMatching& m = p.matching;
  std::vector<std::pair<std::string, std::string>> figures{{"true", text_of(m.true_planes)},
                                                           {"found", text_of(m.found_planes)},
                                                           {"matched", text_of(m.matches.size())},
                                                           {"missed", text_of(m.missed)},
                                                           {"over", text_of(m.over)},
                                                           {"under", text_of(m.under)},
                                                           {"points right", percent_html(m.share())}};
  if (p.errors && p.errors->planes > 0) {
    figures.emplace_back("angle, mean / largest, deg",
                         fmt::format("{:.4f} / {:.4f}", p.errors->angle_deg.mean, p.errors->angle_deg.largest));
    figures.emplace_back("offset, mean / largest, m",
                         fmt::format("{:.4f} / {:.4f}", p.errors->offset_m.mean, p.errors->offset_m.largest));
  }
  return figures_html("Planes", figures);
}

std::string control_points_html(const std::vector<ControlGroup>& groups) {
  double most = 0;
  for (const ControlGroup& g : groups) most = std::max(most, g.dd_m.mean + g.dd_m.sd);
  std::string html =
      "<h3>Control points</h3>\n<div class=\"scroll\"><table><tr><th>group</th><th>n</th><th>missed</th><th>dX, cm</th>"
      "<th>dZ, cm</th><th>dD, cm</th><th>s.d.</th><th></th><th>completed</th></tr>\n";
  for (const ControlGroup& g : groups)
    html += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}"
        "</td><td>{}</td><td>{}</td></tr>\n",
        escaped_markup(g.name), g.count, g.missed, 100 * g.dx_m.mean, 100 * g.dz_m.mean, 100 * g.dd_m.mean,
        100 * g.dd_m.sd, spread_bar(g.dd_m, most), g.completed);
  return html + "</table></div>\n";
}

std::string roofs_html(const RoofEvaluation& r) {
  const RoofResult& result = r.result;
  std::string html = figures_html("Roofs", {{"buildings", text_of(result.true_buildings)},
                                            {"models", text_of(r.models)},
                                            {"closed", text_of(r.closed)},
                                            {"RMS, m", metres_html(result.rms_m)},
                                            {"covered", percent_html(result.covered)},
                                            {"largest distance, m", metres_html(result.hausdorff_m)},
                                            {"outline p95, m", metres_html(result.outline_p95_m)},
                                            {"F1 of edges", r.edges.f1() ? percent_html(*r.edges.f1()) : "-"}});
  html +=
      "<div class=\"scroll\"><table><tr><th>faces from, m²</th><th>true</th><th>matched</th><th></th>"
      "<th>right neighbours</th><th></th></tr>\n";
  for (const RoofSizeClass& s : result.classes) {
    const double all = s.truth ? static_cast<double>(s.truth) : 1;
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", s.from_m2,
                        s.truth, s.matched, bar(static_cast<double>(s.matched) / all), s.right_neighbours,
                        bar(static_cast<double>(s.right_neighbours) / all));
  }
  return html + "</table></div>\n";
}

std::string openings_html(const OpeningResult& o) {
  return figures_html("Openings", {{"true", text_of(o.truth)},
                                   {"found", text_of(o.found)},
                                   {"matched", text_of(o.matched)},
                                   {"invented", text_of(o.invented)},
                                   {"IoU", fmt::format("{:.3f}", o.iou_mean)},
                                   {"ring distance, m", metres_html(o.ring_distance_m)}});
}

std::string drawn_edges_html(const DrawnEdges& d) {
  std::vector<std::pair<std::string, std::string>> figures{{"true edges, m", fmt::format("{:.1f}", d.true_m)}};
  for (std::size_t i = 0; i < kEdgeLimitsM.size(); ++i)
    figures.emplace_back(fmt::format("drawn within {:.0f} cm", 100 * kEdgeLimitsM[i]), percent_html(d.share(i)));
  std::string html = figures_html("Edges of openings, missed ones counted as wrong", figures);
  for (const StatedErrors& s : d.stated)
    if (s.edges > 0)
      html += fmt::format(
          "<p>{} of {} {} edges are within their stated 95&nbsp;% error; median stated {} m, true {} m</p>\n", s.within,
          s.edges, s.status == DrawnStatus::seen ? "seen" : "completed", metres_html(s.median_stated_m),
          metres_html(s.median_true_m));
  return html;
}

// What is stated of objects beside what is true.
std::string reliability_html(const Reliability& r) {
  std::string html =
      "<h3>Probabilities of classes</h3>\n<div class=\"scroll\"><table><tr><th>stated "
      "probability</th><th>objects</th><th>right</th><th></th></tr>\n";
  for (const ReliabilityBin& bin : r.bins)
    if (bin.count > 0)
      html += fmt::format("<tr><td>{:.2f}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", bin.mean_probability,
                          bin.count, percent_html(bin.right), bar(bin.right));
  return html + fmt::format("</table></div>\n<p>Calibration error {:.3f}</p>\n", r.calibration_error);
}

std::string class_counts_html(const std::vector<ObjectClassCounts>& classes, const char* title) {
  std::string html = fmt::format(
      "<h3>{}</h3>\n<div class=\"scroll\"><table><tr><th>class</th><th>true</th><th>detected</th><th>with the right "
      "class</th></tr>\n",
      title);
  for (const ObjectClassCounts& c : classes)
    html += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped_markup(c.name), c.truth,
                        c.detected, c.right);
  return html + "</table></div>\n";
}

std::string objects_html(const ObjectResult& o) {
  return figures_html("Objects", {{"true", text_of(o.truth)},
                                  {"found", text_of(o.found)},
                                  {"detected", text_of(o.detected)},
                                  {"false", text_of(o.false_found)},
                                  {"unseen", text_of(o.unseen)}}) +
         class_counts_html(o.classes, "Objects by class") + class_counts_html(o.groups, "Objects by four classes") +
         confusion_html(o.confusion, "Classes of objects");
}

std::string boundary_html(const Evaluation& e) {
  const BoundaryCounts& b = *e.boundary;
  return figures_html("Boundaries", {{"E", std::isfinite(b.error()) ? fmt::format("{:.3f}", b.error()) : "∞"},
                                     {"planes", text_of(e.boundary_planes)},
                                     {"true points", text_of(b.truth)},
                                     {"found", text_of(b.found)},
                                     {"common", text_of(b.common)}});
}

}  // namespace

std::string evaluation_html(const Evaluation& e) {
  std::string html =
      "<section id=\"truth\" class=\"ilot-evaluation\">\n" + std::string(kStyle) + "<h2>Against the truth</h2>\n";
  html += fmt::format("<p>{} against {}, {} points</p>\n", escaped_markup(e.result), escaped_markup(e.truth), e.points);
  if (e.confusion) html += confusion_html(*e.confusion, "Classes, points " + words_for(e.class_source));
  if (e.planes) html += planes_html(*e.planes);
  if (e.boundary) html += boundary_html(e);
  if (e.control_points) html += control_points_html(*e.control_points);
  if (e.openings) html += openings_html(*e.openings);
  if (e.drawn_edges) html += drawn_edges_html(*e.drawn_edges);
  if (e.roofs) html += roofs_html(*e.roofs);
  if (e.objects) html += objects_html(*e.objects);
  if (e.probabilities) html += reliability_html(e.probabilities->all);
  if (e.trees) html += "<h3>Trees</h3>\n<pre>" + escaped_markup(trees_text(*e.trees)) + "</pre>\n";
  if (e.pavements) html += "<h3>Pavements</h3>\n<pre>" + escaped_markup(pavements_text(*e.pavements)) + "</pre>\n";
  if (e.carriageways)
    html += "<h3>Carriageways</h3>\n<pre>" + escaped_markup(carriageways_text(*e.carriageways)) + "</pre>\n";
  if (e.kerbs) html += "<h3>Kerbs</h3>\n<pre>" + escaped_markup(kerbs_text(*e.kerbs)) + "</pre>\n";
  for (const std::string& note : e.notes) html += "<p>" + escaped_markup(note) + "</p>\n";
  return html + "</section>\n";
}

}  // namespace ilot
