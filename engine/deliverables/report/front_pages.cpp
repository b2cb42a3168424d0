// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/front_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "engine/deliverables/report/html.h"
#include "engine/report/path_text.h"
#include "engine/report/progress.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostFilesShown = 12;  // of a product; the others are folded up

std::string text_of(const Json& value) {
  return value.is_string() ? value.get<std::string>() : value.is_null() ? std::string() : value.dump();
}

const Json& part(const Json& object, const char* key) {
  static const Json none;
  return object.is_object() && object.contains(key) ? object.at(key) : none;
}

std::string plural(std::uint64_t count, const char* one, const char* many) {
  return grouped(count) + " " + (count == 1 ? one : many);
}

std::string made_line(const ResultFolder& r, const std::string& product) {
  const Json& counts = part(r.run, "counts");
  if (product == "planes") {
    const Json& planes = part(counts, "planes");
    return plural(planes.is_number() ? planes.get<std::uint64_t>() : 0, "plane", "planes");
  }
  if (product == "roofs")
    return fmt::format("{}: {} LoD2.2, {} LoD1.2, {} outline only",
                       plural(r.count("roofs", "buildings"), "building", "buildings"),
                       grouped(r.count("roofs", "lod22")), grouped(r.count("roofs", "lod12")),
                       grouped(r.count("roofs", "footprint_only")));
  if (product == "facades")
    return plural(r.count("facades", "facades"), "facade", "facades") + " with " +
           plural(r.count("facades", "elements"), "element", "elements");
  if (product == "streets")
    return plural(r.count("streets", "objects"), "object", "objects") + " and " +
           plural(r.count("streets", "blocks"), "block", "blocks") + " along the street";
  return plural(r.run.at("inputs").size(), "cloud", "clouds") + " with labels";
}

const char* use_of(const std::string& path) {
  static const std::vector<std::pair<const char*, const char*>> uses{
      {"planes.csv", "the planes as a table: normal, error, area"},
      {"planes.gpkg", "outlines of the planes, for QGIS"},
      {"planes_neighbours.csv", "which planes touch, and where"},
      {"shapes.csv", "spheres, cylinders and cones as a table"},
      {"roofs.city.jsonl", "the buildings as CityJSON, one a line"},
      {"roofs.city.json", "the buildings as one CityJSON object"},
      {"roofs.gpkg", "outlines and roof faces, for QGIS"},
      {"roofs.obj", "the solids for 3D programs"},
      {"roofs.mtl", "colours of roofs.obj"},
      {"objects.gpkg", "objects on the street, for QGIS"},
      {"blocks.gpkg", "blocks and gaps along the street, for QGIS"},
      {"trees.gpkg", "trees and their crowns, for QGIS"},
      {"kerbs.gpkg", "kerbs and the heights of their steps, for QGIS"},
      {"pavements.gpkg", "pavements and their widths, for QGIS"},
      {"range.tif", "highest height of each pixel"},
      {"accumulation.tif", "number of points of each pixel"},
      {"ground.tif", "height of the ground"},
      {"artefacts.tif", "height of objects above the ground"},
      {"streets.svg", "the map of the street"},
      {"streets.pdf", "the map of the street on sheets of A3"},
      {".dxf", "drawing for CAD"},
      {".pdf", "drawing on paper"},
      {".svg", "drawing for browsers"},
      {".json", "everything that is known of the facade"},
      {".csv", "table"},
      {".png", "image"},
      {".pgw", "place of the image"},
      {".tif", "raster"},
      {".obj", "for 3D programs"},
      {".stl", "for 3D programs"}};
  if (path.starts_with("streets/streets_")) return "a sheet of the map of the streets";
  for (const auto& [end, use] : uses)
    if (path.ends_with(end)) return use;
  return path.starts_with("points/") ? "the points of an input with labels" : "";
}

std::string product_of(const std::string& path) {
  for (const char* folder : {"roofs", "facades", "streets", "points"})
    if (path.starts_with(std::string(folder) + "/")) return folder;
  return "planes";
}

std::string file_row(const ResultRecord& file) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n",
                     file_link(file.path, path_text(file.path)), use_of(file.path), bytes_text(file.bytes));
}

// The files of one facade are one line: their ends are the links.
std::string facade_rows(const std::vector<const ResultRecord*>& files) {
  std::map<std::string, std::vector<const ResultRecord*>> by_stem;
  for (const ResultRecord* file : files) by_stem[file->path.substr(0, file->path.rfind('.'))].push_back(file);
  std::string rows;
  for (const auto& [stem, own] : by_stem) {
    std::string links;
    std::uint64_t bytes = 0;
    for (const ResultRecord* file : own) {
      links += file_link(file->path, file->path.substr(stem.size() + 1)) + " ";
      bytes += file->bytes;
    }
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"n\">{}</td></tr>\n", html_text(path_text(stem)), links,
                        bytes_text(bytes));
  }
  return rows;
}

std::string files_table(const std::string& rows) {
  return "<div class=\"wide\"><table><thead><tr><th>file</th><th>what for</th><th class=\"n\">size</th></tr></thead>"
         "<tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string files_of_product(const std::string& product, const std::vector<const ResultRecord*>& files) {
  std::uint64_t bytes = 0;
  std::string rows;
  for (const ResultRecord* file : files) bytes += file->bytes;
  if (product == "facades")
    rows = facade_rows(files);
  else
    for (const ResultRecord* file : files) rows += file_row(*file);
  const bool folded = files.size() > kMostFilesShown;
  return folded ? fmt::format("<details><summary>{}, {}</summary>{}</details>\n", plural(files.size(), "file", "files"),
                              bytes_text(bytes), files_table(rows))
                : files_table(rows);
}

// Reasons of one kind, with what they are about.
struct ReasonGroup {
  std::string what, first;
  std::vector<std::string> where;
};

std::string where_text(const std::vector<std::string>& where) {
  constexpr std::size_t kMostNamed = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(where.size(), kMostNamed); ++i) text += (i > 0 ? ", " : "") + where[i];
  return where.size() > kMostNamed ? text + ", ..." : text;
}

void add_reason(std::map<std::string, ReasonGroup>& groups, const std::string& what, const std::string& where,
                const std::string& reason) {
  ReasonGroup& group = groups[what + ": " + reason_kind(reason)];
  if (group.first.empty()) group = {what, reason, {}};
  group.where.push_back(where);
}

std::string reasons_table(const std::map<std::string, ReasonGroup>& groups) {
  std::vector<const ReasonGroup*> order;
  for (const auto& [kind, group] : groups) order.push_back(&group);
  std::stable_sort(order.begin(), order.end(),
                   [](const ReasonGroup* a, const ReasonGroup* b) { return a->where.size() > b->where.size(); });
  HtmlTable table({{"how many", true}, {"what"}, {"why"}, {"where"}});
  for (const ReasonGroup* group : order)
    table.add({grouped(group->where.size()), html_text(group->what),
               html_text(group->where.size() > 1 ? "for example: " + group->first : group->first),
               html_text(where_text(group->where))});
  return table.html();
}

}  // namespace

std::string reason_kind(const std::string& reason) {
  std::string kind;
  for (const char c : reason) {
    const bool digit = (c >= '0' && c <= '9') || ((c == '.' || c == ',') && kind.ends_with('#'));
    if (!digit)
      kind += c;
    else if (!kind.ends_with('#'))
      kind += '#';
  }
  return kind;
}

std::string made_section(const ResultFolder& result) {
  std::map<std::string, std::vector<const ResultRecord*>> of_product;
  for (const ResultRecord& file : result.files) of_product[product_of(file.path)].push_back(&file);
  std::string content = html_note("Links open the files where they are: keep this page in its folder.");
  for (const char* product : {"roofs", "facades", "streets", "planes", "points"}) {
    const auto files = of_product.find(product);
    if (files == of_product.end() && !result.makes(product)) continue;
    content += fmt::format("<h3>{}: {}</h3>\n", product, html_text(made_line(result, product)));
    content += files == of_product.end() ? html_note("no file: see what was left out")
                                         : files_of_product(product, files->second);
  }
  return html_section("made", "What was made", content);
}

std::string left_out_section(const ResultFolder& result) {
  std::map<std::string, ReasonGroup> skipped, warnings;
  for (const Json& s : part(result.run, "skipped"))
    add_reason(skipped, text_of(part(s, "what")), text_of(part(s, "where")), text_of(part(s, "reason")));
  for (const Json& warning : part(result.run, "warnings")) {
    const std::string text = text_of(warning);
    const std::size_t colon = text.find(": ");
    const bool named = colon < 40;  // a text without a colon gives npos
    add_reason(warnings, "warning", named ? text.substr(0, colon) : "", text);
  }
  const Json& rejected = part(result.run, "rejected");
  const Json& outside = part(part(result.run, "footprints"), "outside");
  std::string content;
  if (!skipped.empty()) content += "<h3>Skipped</h3>\n" + reasons_table(skipped);
  if (!rejected.empty()) {
    HtmlTable table({{"points", true}, {"why they were left out"}});
    for (const auto& [reason, points] : rejected.items())
      table.add({grouped(points.get<std::uint64_t>()), html_text(reason)});
    content += "<h3>Points left out</h3>\n" + table.html();
  }
  if (outside.is_array() && !outside.empty())
    content += html_note(plural(outside.size(), "footprint is", "footprints are") +
                         " outside the extent of the cloud; that is no fault.");
  const Json& without_model = part(part(result.run, "clusters"), "without_model");
  if (!without_model.empty()) {
    HtmlTable table({{"outlines", true}, {"found in the cloud, without a model"}});
    for (const auto& [reason, outlines] : without_model.items())
      table.add({grouped(outlines.get<std::uint64_t>()), html_text(reason)});
    content += "<h3>Outlines without a model</h3>\n" + table.html();
  }
  if (!warnings.empty()) content += "<h3>Warnings</h3>\n" + reasons_table(warnings);
  if (content.empty()) content = html_note("Nothing was skipped, left out or warned of.");
  return html_section("left-out", "What was left out, and why", content);
}

std::string inputs_section(const ResultFolder& result) {
  HtmlTable table({{"cloud"}, {"format"}, {"CRS in the file"}, {"points", true}, {"size", true}, {"with labels"}});
  for (const Json& input : result.run.at("inputs")) {
    const std::string output = text_of(part(input, "output"));
    table.add({html_text(text_of(part(input, "path"))), html_text(text_of(part(input, "format"))),
               html_text(text_of(part(input, "crs"))), grouped(input.value("points", std::uint64_t{0})),
               bytes_text(input.value("bytes", std::uint64_t{0})),
               output.empty() ? "" : file_link(path_of_text(output).string(), output)});
  }
  std::string content = table.html();
  const Json& counts = part(part(result.run, "counts"), "points");
  if (counts.is_object())
    content += html_note(fmt::format(
        "{} points read: {} with a label, {} without, {} left out.", grouped(counts.value("read", std::uint64_t{0})),
        grouped(counts.value("labelled", std::uint64_t{0})), grouped(counts.value("unlabelled", std::uint64_t{0})),
        grouped(counts.value("rejected", std::uint64_t{0}))));
  if (const Json& f = part(result.run, "footprints"); f.is_object()) {
    content += fmt::format(
        "<p>Footprints: {}, {}, ids from <code>{}</code>; {} of the building points around them are inside, {} % if "
        "they were moved by {} m, {} m.</p>\n",
        html_text(text_of(part(f, "path"))), grouped(f.value("footprints", std::uint64_t{0})),
        html_text(text_of(part(f, "id_attribute"))), number_text(100 * f.value("points_inside", 0.0), 1) + " %",
        number_text(100 * f.value("points_inside_shifted", 0.0), 1), number_text(f.at("shift_m").at(0), 2),
        number_text(f.at("shift_m").at(1), 2));
  }
  return html_section("inputs", "Inputs", content);
}

std::string parameters_section(const ResultFolder& result) {
  HtmlTable chosen({{"parameter"}, {"chosen", true}, {"why"}});
  for (const Json& c : part(result.run, "chosen")) {
    const Json& value = part(c, "value");
    chosen.add({"<code>" + html_text(text_of(part(c, "key"))) + "</code>",
                value.is_number() ? number_text(value.get<double>(), 4) : html_text(text_of(value)),
                html_text(text_of(part(c, "why")))});
  }
  HtmlTable all({{"parameter"}, {"value"}}, true);
  for (const auto& [key, value] : part(result.run, "parameters").items())
    all.add({"<code>" + html_text(key) + "</code>", html_text(text_of(value))});
  std::string content;
  if (!chosen.empty()) content += "<h3>Chosen for <code>auto</code></h3>\n" + chosen.html();
  content += "<details><summary>All parameters as they were set</summary>" + all.html() + "</details>\n";
  return html_section("parameters", "Parameters", content);
}

std::string lineage_section(const ResultFolder& result) {
  HtmlTable table({{"what"}, {"value"}});
  const auto row = [&](const char* what, const std::string& value) {
    if (!value.empty()) table.add({what, "<code>" + html_text(value) + "</code>"});
  };
  row("ilot", text_of(part(result.run, "version")) + ", commit " + text_of(part(result.run, "git_hash")));
  row("products", part(result.run, "products").dump());
  row("hash of the parameters", text_of(part(result.run, "parameters_hash")));
  row("hash of the result (SHA-256)", text_of(part(result.run, "result_hash")));
  const Json& crs = part(result.run, "crs");
  row("coordinate system", text_of(part(crs, "name")));
  row("unit of coordinates", crs.is_object() ? number_text(result.metres_per_unit, 9) + " m" +
                                                   (result.run.value("unit_assumed", false) ? " (assumed)" : "")
                                             : "");
  return html_section("lineage", "Lineage",
                      table.html() + html_note("Two runs with the same inputs, version and parameters have the same "
                                               "hash of the result, whatever the machine."));
}

std::string stages_section(const ResultFolder& result) {
  double total = 0;
  for (const Json& stage : part(result.run, "stages")) total += stage.value("seconds", 0.0);
  HtmlTable table({{"stage"},
                   {"seconds", true},
                   {"of the time"},
                   {"processor seconds", true},
                   {"points", true},
                   {"points per second", true}});
  for (const Json& stage : part(result.run, "stages")) {
    const double seconds = stage.value("seconds", 0.0);
    table.add(
        {html_text(text_of(part(stage, "name"))), fmt::format("{:.1f}", seconds),
         fmt::format("<span class=\"bar\" style=\"width:{:.1f}%\"></span>", total > 0 ? 100 * seconds / total : 0),
         fmt::format("{:.1f}", stage.value("cpu_seconds", 0.0)), grouped(stage.value("points", std::uint64_t{0})),
         grouped(static_cast<std::uint64_t>(stage.value("points_per_second", 0.0)))});
  }
  const std::string line = fmt::format("{:.1f} s in all with {} threads; peak of memory {} of {} allowed; {} blocks.",
                                       result.run.value("seconds", 0.0), result.run.value("threads", 0),
                                       bytes_text(result.run.value("peak_rss_bytes", std::uint64_t{0})),
                                       bytes_text(result.run.value("memory_bytes", std::uint64_t{0})),
                                       grouped(result.run.value("blocks", std::uint64_t{0})));
  return html_section("stages", "Stages, time and memory", html_note(line) + table.html());
}

}  // namespace ilot
