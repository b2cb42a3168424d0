// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/compare/evaluation_report.h"
#include "engine/compare/roofs/wireframe_report.h"
#include "engine/compare/streets/street_report.h"

namespace ilot {
namespace {

using Row = std::vector<std::string>;

std::string percent(std::optional<double> share) {
  return share ? fmt::format("{:.1f} %", 100 * *share) : "-";
}

std::string metres(double v) {
  return std::isfinite(v) ? fmt::format("{:.4f}", v) : "-";
}

std::string centimetres(const MeanAndSpread& v, std::uint64_t n) {
  return n ? fmt::format("{:.2f} ({:.2f})", 100 * v.mean, 100 * v.sd) : "-";
}

// The width of a cell in characters: the number of bytes that start a character.
std::size_t width_of(const std::string& cell) {
  return static_cast<std::size_t>(std::count_if(cell.begin(), cell.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

// A table whose first column is aligned to the left and the others to the right, with two blanks between columns.
std::string table(const std::vector<Row>& rows) {
  std::vector<std::size_t> widths;
  for (const Row& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], width_of(row[c]));
  }
  std::string text;
  for (const Row& row : rows) {
    std::string line = "  ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string blanks(widths[c] - width_of(row[c]), ' ');
      line += c == 0 ? row[c] + blanks : "  " + blanks + row[c];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string confusion_text(const ConfusionMatrix& m, const std::string& title) {
  Row head{"true \\ found"}, foot{"precision"};
  std::vector<Row> rows;
  for (const std::string& name : m.classes) head.push_back(name);
  for (const char* name : {"undetected", "total", "sensitivity"}) head.emplace_back(name);
  rows.push_back(head);
  std::uint64_t all = 0;
  for (std::size_t c = 0; c < m.classes.size(); ++c) {
    Row row{m.classes[c]};
    std::uint64_t total = 0;
    for (const std::uint64_t count : m.counts[c]) {
      row.push_back(fmt::format("{}", count));
      total += count;
    }
    row.push_back(fmt::format("{}", total));
    row.push_back(percent(sensitivity(m, c)));
    all += total;
    rows.push_back(row);
    foot.push_back(percent(precision(m, c)));
  }
  foot.insert(foot.end(), {"", fmt::format("{}", all), percent(global_sensitivity(m))});
  rows.push_back(foot);
  return title + "\n" + table(rows);
}

std::string sizes_text(const PlaneSizes& sizes) {
  std::string text = "sizes    matched";
  for (const PlaneSizeClass& s : sizes)
    text += fmt::format("{} from {} m2 {} of {} ({})", &s == sizes.data() ? "" : ",", s.from_m2, s.matched, s.truth,
                        s.truth ? percent(static_cast<double>(s.matched) / static_cast<double>(s.truth)) : "-");
  return text + "\n";
}

std::string planes_text(const PlaneEvaluation& p) {
  const PlaneMatching& m = p.matching;
  std::string text = fmt::format("planes   true {}  found {}  matched {}  over {}  under {}  missed {}\n",
                                 m.true_planes, m.found_planes, m.matches.size(), m.over, m.under, m.missed);
  text += fmt::format("points   {:.3f} % of {} points of true planes carry their plane\n", 100 * m.share(), m.points);
  const ForeignPoints foreign = foreign_points(m);
  if (foreign.worst)
    text += fmt::format("foreign  at most {:.3f} % (plane {} with {} points); {} found planes above 1 %\n",
                        100 * foreign.worst->foreign_share(), foreign.worst->id, foreign.worst->points, foreign.impure);
  if (p.errors && p.errors->planes > 0)
    text += fmt::format(
        "angle    mean {:.4f}, median {:.4f}, largest {:.4f} deg\n"
        "offset   mean {:.4f}, median {:.4f}, largest {:.4f} m\n",
        p.errors->angle_deg.mean, p.errors->angle_deg.median, p.errors->angle_deg.largest, p.errors->offset_m.mean,
        p.errors->offset_m.median, p.errors->offset_m.largest);
  if (p.sizes) text += sizes_text(*p.sizes);
  return text;
}

std::string boundary_text(const Evaluation& e) {
  const BoundaryCounts& b = *e.boundary;
  return fmt::format("boundary error E {}  ({} planes; true {}, found {}, common {} points)\n",
                     std::isfinite(b.error()) ? fmt::format("{:.3f}", b.error()) : "infinite", e.boundary_planes,
                     b.truth, b.found, b.common);
}

std::string control_points_text(const std::vector<ControlGroup>& groups) {
  std::vector<Row> rows{
      {"group", "n", "missed", "drawn", "dX, cm (sd)", "dZ, cm (sd)", "dD, cm (sd)", "completed", "dD, cm (sd)"}};
  for (const ControlGroup& g : groups)
    rows.push_back({g.name, fmt::format("{}", g.count), fmt::format("{}", g.missed),
                    percent(static_cast<double>(g.drawn) / static_cast<double>(g.count)), centimetres(g.dx_m, g.drawn),
                    centimetres(g.dz_m, g.drawn), centimetres(g.dd_m, g.drawn), fmt::format("{}", g.completed),
                    centimetres(g.completed_dd_m, g.completed)});
  return "control points\n" + table(rows);
}

std::string openings_text(const OpeningResult& o) {
  return fmt::format("openings  true {}  found {}  matched {}  invented {}  IoU {:.3f}  ring distance {:.4f} m\n",
                     o.truth, o.found, o.matched, o.invented, o.iou_mean, o.ring_distance_m);
}

std::string drawn_edges_text(const DrawnEdges& d) {
  std::string text = fmt::format("edges     {:.1f} m of true openings; drawn within", d.true_m);
  for (std::size_t i = 0; i < kEdgeLimitsM.size(); ++i)
    text += fmt::format("{} {:g} cm {}", i == 0 ? "" : ",", 100 * kEdgeLimitsM[i], percent(d.share(i)));
  text += " (missed openings count as wrong)\n";
  for (const StatedErrors& s : d.stated) {
    if (s.edges == 0) continue;
    text += fmt::format(
        "stated    {} of {} {} edges within their stated error ({}); median stated {:.4f}, true {:.4f} m\n", s.within,
        s.edges, s.status == DrawnStatus::seen ? "seen" : "completed",
        percent(static_cast<double>(s.within) / static_cast<double>(s.edges)), s.median_stated_m, s.median_true_m);
  }
  return text;
}

std::string roofs_text(const RoofEvaluation& r) {
  const RoofResult& result = r.result;
  std::string text =
      fmt::format("roofs    buildings {}  models {}  closed {}\n", result.true_buildings, r.models, r.closed);
  text += fmt::format("faces    true {}  found {}  matched {}\n", result.true_faces, result.found_faces,
                      result.matched_faces);
  std::vector<Row> rows{{"area, m2", "true", "matched", "", "right neighbours", ""}};
  double above = 0;
  for (const RoofSizeClass& s : result.classes) {
    const auto share = [&](std::uint64_t part) {
      return s.truth ? percent(static_cast<double>(part) / static_cast<double>(s.truth)) : "-";
    };
    rows.push_back({above == 0 ? fmt::format("from {}", s.from_m2) : fmt::format("{} to {}", s.from_m2, above),
                    fmt::format("{}", s.truth), fmt::format("{}", s.matched), share(s.matched),
                    fmt::format("{}", s.right_neighbours), share(s.right_neighbours)});
    above = s.from_m2;
  }
  return text + table(rows) +
         fmt::format("heights  RMS {} m, {} of the true roofs covered\nlargest distance {} m, outline p95 {} m\n",
                     metres(result.rms_m), percent(result.covered), metres(result.hausdorff_m),
                     metres(result.outline_p95_m)) +
         edges_text(r.edges);
}

std::string class_counts_text(const std::vector<ObjectClassCounts>& classes, const char* title) {
  std::vector<Row> rows{{title, "true", "detected", "right class", "of the detected"}};
  for (const ObjectClassCounts& c : classes)
    rows.push_back({c.name, std::to_string(c.truth), std::to_string(c.detected), std::to_string(c.right),
                    c.detected == 0 ? "-" : percent(static_cast<double>(c.right) / static_cast<double>(c.detected))});
  return table(rows);
}

std::string objects_text(const ObjectResult& o) {
  const auto share = [](std::optional<double> v) { return v ? percent(*v) : "-"; };
  return fmt::format("objects  true {}  found {}  detected {}  false {}  (unseen {})\n", o.truth, o.found, o.detected,
                     o.false_found, o.unseen) +
         fmt::format("right class, mean over classes: {} of the detected, {} of all\n", share(o.right_class),
                     share(o.detected_and_right)) +
         class_counts_text(o.classes, "class") +
         fmt::format("with four classes (car, lamppost, pedestrian, other): {} of the detected\n",
                     share(o.right_group)) +
         class_counts_text(o.groups, "group") + confusion_text(o.confusion, "classes of objects");
}

std::string probabilities_text(const ProbabilityEvaluation& p) {
  std::vector<Row> rows{{"class", "objects", "calibration error"}};
  rows.push_back({"all", fmt::format("{}", p.all.count), percent(p.all.calibration_error)});
  for (const auto& [name, r] : p.by_class)
    rows.push_back({name, fmt::format("{}", r.count), percent(r.calibration_error)});
  std::string text = "probabilities of classes\n" + table(rows);
  for (std::size_t b = 0; b < p.all.bins.size(); ++b) {
    const ReliabilityBin& bin = p.all.bins[b];
    if (bin.count > 0)
      text += fmt::format("stated {:.2f}: {} of {} objects are right\n", bin.mean_probability, percent(bin.right),
                          bin.count);
  }
  return text;
}

}  // namespace

std::string words_for(ClassSource source) {
  switch (source) {
    case ClassSource::labels:
      return "by label";
    case ClassSource::facade_labels:
      return "by label, in the words of facades";
    case ClassSource::segments:
      break;
  }
  return "by the class their segment speaks for";
}

std::string evaluation_text(const Evaluation& e) {
  std::vector<std::string> parts;
  if (e.confusion) parts.push_back(confusion_text(*e.confusion, "classes, points " + words_for(e.class_source)));
  if (e.planes) parts.push_back(planes_text(*e.planes));
  if (e.boundary) parts.push_back(boundary_text(e));
  if (e.control_points) parts.push_back(control_points_text(*e.control_points));
  if (e.openings) parts.push_back(openings_text(*e.openings));
  if (e.facade_sides && e.facade_sides->judged > 0)
    parts.push_back(fmt::format("facades   {} with true openings, {} of them mirrored\n", e.facade_sides->judged,
                                e.facade_sides->mirrored));
  if (e.drawn_edges) parts.push_back(drawn_edges_text(*e.drawn_edges));
  if (e.roofs) parts.push_back(roofs_text(*e.roofs));
  if (e.objects) parts.push_back(objects_text(*e.objects));
  if (e.probabilities) parts.push_back(probabilities_text(*e.probabilities));
  if (e.trees) parts.push_back(trees_text(*e.trees));
  if (e.kerbs) parts.push_back(kerbs_text(*e.kerbs));
  if (e.pavements) parts.push_back(pavements_text(*e.pavements));
  if (e.carriageways) parts.push_back(carriageways_text(*e.carriageways));
  for (const std::string& note : e.notes) parts.push_back("note: " + note + "\n");
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "\n") + part;
  return text;
}

}  // namespace ilot
