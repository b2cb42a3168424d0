// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facades_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/deliverables/drawings/facade_evidence.h"
#include "engine/deliverables/pages/facade_files.h"
#include "engine/markup.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

constexpr std::size_t kMostListed = 200, kMostEvidence = 1000;
constexpr std::array<const char*, 3> kStatus{"seen", "completed", "occluded"};

constexpr const char* kFacadesHead = R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Facades</title><style>
body{font:14px/1.45 system-ui,sans-serif;color:#1d2433;background:#fff;margin:1.5rem auto;max-width:80rem;padding:0 1rem}
h1{font-size:1.4rem;margin:0 0 .3rem}h2{font-size:1.1rem;margin:2rem 0 .3rem}p{margin:.2rem 0;color:#5c667a}
figure{margin:.5rem 0}figure svg{width:100%;height:auto;max-height:90vh;border:1px solid #d5dae3}
figure svg text{paint-order:stroke;stroke:#fff;stroke-width:.7px;stroke-linejoin:round}
label{margin-right:.9rem;white-space:nowrap}
.notes path:hover,.proof .notes path{stroke-opacity:.75}
.notes .note-good{stroke:#1a8f3c}.notes .note-weak{stroke:#e08a00}.notes .note-none{stroke:#d3202b}
table{border-collapse:collapse;margin:.6rem 0}td,th{padding:.15rem .7rem;text-align:left;border-bottom:1px solid #d5dae3}
td.n,th.n{text-align:right}
</style></head><body>
)";

// One handler serves all drawings: a box shows or hides the groups of its class within its own figure.
constexpr const char* kTail = R"(<script>
document.querySelectorAll("figure input").forEach(function (box) {
  box.addEventListener("change", function () {
    if (box.value === "proof") box.closest("figure").classList.toggle("proof", box.checked);
    box.closest("figure").querySelectorAll("." + box.value).forEach(function (part) {
      part.style.display = box.checked ? "inline" : "none";
    });
  });
});
</script></body></html>
)";

std::string name_of(DrawnStatus status) {
  return kStatus.at(static_cast<std::size_t>(status));
}

std::string switches(const Drawing& drawing, const DrawingLayers& layers, bool has_image, bool has_proof) {
  std::string boxes;
  const auto box = [&](const std::string& value, const std::string& words, bool on) {
    boxes +=
        fmt::format("<label><input type=\"checkbox\" value=\"{}\"{}> {}</label>\n", value, on ? " checked" : "", words);
  };
  if (has_image) box("underlay", "image", true);
  if (has_proof) box("proof", "proof", false);
  for (std::size_t i = 0; i < kDrawingRoles; ++i) {
    const auto role = static_cast<DrawingRole>(i);
    const auto is_of = [&](const auto& piece) { return piece.role == role; };
    if (role == DrawingRole::frame || role == DrawingRole::title) continue;
    if (std::any_of(drawing.lines.begin(), drawing.lines.end(), is_of) ||
        std::any_of(drawing.arcs.begin(), drawing.arcs.end(), is_of) ||
        std::any_of(drawing.texts.begin(), drawing.texts.end(), is_of))
      box(std::string("role-") + ilot::name_of(role), ilot::name_of(role), layers[role].shown);
  }
  return "<figcaption>" + boxes + "</figcaption>\n";
}

std::size_t edges_of(const FacadeElement& e, DrawnStatus status) {
  return static_cast<std::size_t>(
      std::count_if(e.edges.begin(), e.edges.end(), [&](const FacadeEdge& edge) { return edge.status == status; }));
}

// Returns a sentence with the number of edges whose evidence is not good; empty when no edge was compared with points.
std::string doubtful_edges(const Facade& facade) {
  std::size_t doubtful = 0;
  bool held = false;
  for (const FacadeElement& e : facade.elements)
    for (const FacadeEdge& edge : e.edges) {
      doubtful += evidence_grade(edge) != EvidenceGrade::good;
      held |= edge.points > 0 && edge.covered_share > 0;
    }
  return held && doubtful > 0
             ? fmt::format(" Of {} edges half has no points, or no station saw it: see proof.", doubtful)
             : std::string();
}

// Returns the table of elements that are not completely seen, which a surveyor has to check.
std::string doubtful_table(const Facade& facade) {
  std::string rows;
  std::size_t listed = 0, all = 0;
  for (const FacadeElement& e : facade.elements) {
    const std::size_t completed = edges_of(e, DrawnStatus::completed), occluded = edges_of(e, DrawnStatus::occluded);
    if (e.status == DrawnStatus::seen && completed + occluded == 0) continue;
    if (all++ >= kMostListed) continue;
    ++listed;
    rows += fmt::format(
        "<tr><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td><td "
        "class=\"n\">{}"
        "</td><td class=\"n\">{}</td><td class=\"n\">{}</td><td>{}</td></tr>\n",
        e.id, escaped_markup(clean_text(e.kind)), e.row, e.column, name_of(e.status), e.edges.size(), completed,
        occluded, escaped_markup(clean_text(e.reason)));
  }
  if (rows.empty()) return "<p>Everything drawn was seen." + doubtful_edges(facade) + "</p>\n";
  return "<table><tr><th class=\"n\">id</th><th>kind</th><th class=\"n\">row</th><th class=\"n\">column</th><th>status"
         "</th><th class=\"n\">edges</th><th class=\"n\">completed</th><th "
         "class=\"n\">occluded</th><th>reason</th></tr>\n" +
         rows + "</table>\n" + (listed < all ? fmt::format("<p>{} of {} are listed.</p>\n", listed, all) : "");
}

// Returns the table of the evidence for each edge and face.
std::string evidence_table(const Facade& facade, const std::vector<FlatElement>& flat) {
  std::string rows;
  std::size_t listed = 0, all = 0;
  for (std::size_t i = 0; i < flat.size(); ++i) {
    const std::size_t here = add_evidence_rows(facade.elements[i], flat[i], kMostEvidence - listed, rows);
    listed += std::min(here, kMostEvidence - listed);
    all += here;
  }
  if (rows.empty()) return "";
  return "<details><summary>What speaks for each edge and face</summary><table><tr><th class=\"n\">id</th><th>kind</th>"
         "<th>edge</th><th>status</th><th class=\"n\">points</th><th class=\"n\">RMS, mm</th><th class=\"n\">within, "
         "mm</th><th class=\"n\">covered, %</th><th class=\"n\">occluded, %</th></tr>\n" +
         rows + "</table>\n" +
         (listed < all ? fmt::format("<p>{} of {} are listed; all are in the JSON.</p>\n", listed, all) : "") +
         "</details>\n";
}

std::string links(const Facade& facade) {
  const std::string name = facade_name(facade.id);
  std::string list;
  for (const char* extension : {"dxf", "pdf", "svg", "csv", "json"})
    list += fmt::format("<a href=\"{0}.{1}\">{0}.{1}</a> ", name, extension);
  return list;
}

}  // namespace

void FacadesPage::add(const Facade& facade, const Drawing& drawing, const std::optional<SvgUnderlay>& image,
                      double metres_per_unit) {
  ++facades_;
  std::vector<FlatElement> flat;
  std::vector<SvgNote> notes;
  for (const FacadeElement& e : facade.elements) {
    ++elements_;
    flat.push_back(flat_element(facade, e, metres_per_unit));
    const std::vector<SvgNote> own = edge_notes(e, flat.back());
    notes.insert(notes.end(), own.begin(), own.end());
    ++by_kind_[e.kind][e.status];
    edges_ += e.edges.size();
    completed_edges_ += edges_of(e, DrawnStatus::completed);
    occluded_edges_ += edges_of(e, DrawnStatus::occluded);
  }
  std::stable_sort(notes.begin(), notes.end(), [](const SvgNote& a, const SvgNote& b) { return a.worth > b.worth; });
  const double error = edge_error_95(facade);
  body_ += fmt::format("<h2>Facade {}</h2>\n<p>{} x {} m, {} elements{}. {}</p>\n", facade.id,
                       decimal(facade.width_m, 2), decimal(facade.height_m, 2), facade.elements.size(),
                       error > 0 ? fmt::format(", 95 % of edges within {} mm", decimal(1000 * error, 1)) : "",
                       links(facade));
  const std::string svg = drawing_svg(drawing, layers_, SvgPart::plan, image, notes);
  if (body_.size() + svg.size() <= most_bytes_) {
    ++drawn_;
    body_ += "<figure>\n" + svg + switches(drawing, layers_, image.has_value(), !notes.empty()) + "</figure>\n";
  }
  body_ += doubtful_table(facade) + evidence_table(facade, flat);
}

void FacadesPage::finish() {
  std::string html = kFacadesHead;
  html += fmt::format("<h1>Facades: {}</h1>\n<p>{} elements, {} edges, of them {} completed and {} occluded.{}</p>\n",
                      facades_, elements_, edges_, completed_edges_, occluded_edges_,
                      drawn_ < facades_ ? fmt::format(" {} of {} facades are shown.", drawn_, facades_) : "");
  html +=
      "<table><tr><th>kind</th><th class=\"n\">seen</th><th class=\"n\">completed</th><th "
      "class=\"n\">occluded</th></tr>\n";
  for (const auto& [kind, counts] : by_kind_) {
    html += "<tr><td>" + escaped_markup(clean_text(kind)) + "</td>";
    for (const DrawnStatus status : {DrawnStatus::seen, DrawnStatus::completed, DrawnStatus::occluded})
      html += fmt::format("<td class=\"n\">{}</td>", counts.contains(status) ? counts.at(status) : 0);
    html += "</tr>\n";
  }
  write_whole_file(path_, html + "</table>\n" + body_ + kTail);
}

}  // namespace ilot
