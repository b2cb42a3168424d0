// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facade_sheets.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/deliverables/drawings/facade_drawing.h"
#include "engine/deliverables/drawings/facade_evidence.h"
#include "engine/deliverables/pages/facade_files.h"
#include "engine/markup.h"
#include "engine/model/stated_errors.h"

namespace ilot {
namespace {

constexpr std::size_t kMostListed = 200, kMostEvidence = 1000;

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

std::string links(const Facade& facade, const std::string& folder) {
  const std::string name = facade_name(facade.id);
  std::string list;
  for (const char* extension : {"dxf", "pdf", "svg", "csv", "json"})
    list += fmt::format("<a href=\"{2}{0}.{1}\">{0}.{1}</a> ", name, extension, folder);
  return list;
}

}  // namespace

void FacadeSheets::count(const Facade& facade) {
  ++facades_;
  for (const FacadeElement& e : facade.elements) {
    ++elements_;
    ++by_kind_[e.kind][e.status];
    edges_ += e.edges.size();
    completed_edges_ += edges_of(e, DrawnStatus::completed);
    occluded_edges_ += edges_of(e, DrawnStatus::occluded);
  }
}

std::string FacadeSheets::summary_of(const Facade& facade) const {
  const double error = seen_error_95(facade);
  return fmt::format("<summary>Facade {0}: {1} x {2} m, {3} {4}{5}</summary>\n<p>{6}</p>\n", facade.id,
                     decimal(facade.width_m, 2), decimal(facade.height_m, 2), facade.elements.size(),
                     facade.elements.size() == 1 ? "element" : "elements",
                     error > 0 ? fmt::format(", 95 % of seen edges within {} mm", decimal(1000 * error, 1)) : "",
                     links(facade, params_.folder));
}

void FacadeSheets::add_link(const Facade& facade) {
  count(facade);
  body_ +=
      "<details class=\"sheet\" id=\"facade/" + std::to_string(facade.id) + "\">" + summary_of(facade) + "</details>\n";
}

void FacadeSheets::add(const Facade& facade, const Drawing& drawing, const std::optional<SvgUnderlay>& image,
                       double metres_per_unit) {
  count(facade);
  std::vector<FlatElement> flat;
  std::vector<SvgNote> notes;
  for (const FacadeElement& e : facade.elements) {
    flat.push_back(flat_element(facade, e, metres_per_unit));
    const std::vector<SvgNote> own = edge_notes(e, flat.back());
    notes.insert(notes.end(), own.begin(), own.end());
  }
  std::stable_sort(notes.begin(), notes.end(), [](const SvgNote& a, const SvgNote& b) { return a.worth > b.worth; });
  body_ += "<details class=\"sheet\" id=\"facade/" + std::to_string(facade.id) + "\"" + (facades_ == 1 ? " open" : "") +
           ">" + summary_of(facade);
  const std::string svg = drawing_svg(drawing, params_.layers, SvgPart::plan, image, notes);
  if (body_.size() + svg.size() <= params_.most_bytes) {
    ++drawn_;
    body_ += "<figure>\n" + svg + switches(flattened(drawing), params_.layers, image.has_value(), !notes.empty()) +
             "</figure>\n";
  }
  for (const std::string& table : {doubtful_table(facade), evidence_table(facade, flat)})
    if (body_.size() + table.size() <= params_.most_bytes) body_ += table;
  body_ += "</details>\n";
}

std::string FacadeSheets::html() const {
  std::string html = fmt::format(
      "<p>{} {}, {} edges, of them {} completed and {} occluded.{}</p>\n", elements_,
      elements_ == 1 ? "element" : "elements", edges_, completed_edges_, occluded_edges_,
      drawn_ < facades_ ? fmt::format(" {} of {} facades are shown; the files have all.", drawn_, facades_) : "");
  std::vector<DrawnStatus> columns{DrawnStatus::seen, DrawnStatus::completed, DrawnStatus::occluded};
  if (std::any_of(by_kind_.begin(), by_kind_.end(),
                  [](const auto& kind) { return kind.second.contains(DrawnStatus::by_hand); }))
    columns.push_back(DrawnStatus::by_hand);
  html += "<table><thead><tr><th>kind</th>";
  for (const DrawnStatus status : columns) html += fmt::format("<th class=\"n\">{}</th>", ilot::name_of(status));
  html += "</tr></thead><tbody>\n";
  for (const auto& [kind, counts] : by_kind_) {
    html += "<tr><td>" + escaped_markup(clean_text(kind)) + "</td>";
    for (const DrawnStatus status : columns)
      html += fmt::format("<td class=\"n\">{}</td>", counts.contains(status) ? counts.at(status) : 0);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n" + body_;
}

}  // namespace ilot
