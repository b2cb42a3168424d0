// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/deliverables/layers/gpkg_readers.h"
#include "engine/deliverables/pages/page_parts.h"
#include "engine/deliverables/report/against.h"
#include "engine/deliverables/report/building_tiles.h"
#include "engine/deliverables/report/facade_pages.h"
#include "engine/deliverables/report/front_pages.h"
#include "engine/deliverables/report/html.h"
#include "engine/deliverables/report/packed.h"
#include "engine/deliverables/report/plane_pages.h"
#include "engine/deliverables/report/report_limits.h"
#include "engine/deliverables/report/result_folder.h"
#include "engine/deliverables/report/roof_pages.h"
#include "engine/deliverables/report/scene_buildings.h"
#include "engine/deliverables/report/scene_facades.h"
#include "engine/deliverables/report/scene_points.h"
#include "engine/formats/reader.h"
#include "engine/model/point_label.h"
#include "engine/report/product_files.h"
#include "engine/report/progress.h"
#include "engine/whole_file_writer.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

Vec3 rounded_down(Vec3 p) {
  constexpr double kStep = 100;  // CRS units: an origin that people can read
  return {kStep * std::floor(p.x / kStep), kStep * std::floor(p.y / kStep), 0};
}

// The origin is near the content, so that few digits are left. What it is makes no difference to the pictures.
SceneFrame scene_frame(const ResultFolder& result, const PlanesOfReport& planes) {
  const auto usable = [](Vec3 p) { return std::abs(p.x) < 1e9 && std::abs(p.y) < 1e9; };
  for (const ResultRecord& file : result.files)
    if (file.path.starts_with("points/"))
      if (const Vec3 low = open_cloud(result.path / file.path)->info().declared_min; usable(low))
        return {rounded_down(low), result.metres_per_unit};
  if (!planes.shown.empty()) return {rounded_down(planes.shown[0].centroid), result.metres_per_unit};
  return {{}, result.metres_per_unit};
}

LargestOutlines plane_outlines(const ResultFolder& result, std::size_t most_corners) {
  LargestOutlines outlines(most_corners);
  if (result.has("planes.gpkg"))
    for_each_plane_outline(result.path / "planes.gpkg",
                           [&](const Outline& outline, double area) { outlines.add(outline, area); });
  return outlines;
}

StreetPlan street_plan(const ResultFolder& result) {
  StreetPlan plan;
  if (result.has("streets/objects.gpkg")) plan.objects = read_objects_gpkg(result.path / "streets/objects.gpkg");
  if (result.has("streets/blocks.gpkg")) read_blocks_gpkg(result.path / "streets/blocks.gpkg", plan);
  if (result.has("streets/trees.gpkg")) plan.trees = read_trees_gpkg(result.path / "streets/trees.gpkg");
  if (result.has("streets/pavements.gpkg")) {
    plan.pavements = read_pavements_gpkg(result.path / "streets/pavements.gpkg");
    plan.carriageways = read_carriageways(result.path / "streets/pavements.gpkg");
  }
  if (result.has("streets/kerbs.gpkg")) plan.kerbs = read_kerbs_gpkg(result.path / "streets/kerbs.gpkg");
  return plan;
}

std::string title_of(const ResultFolder& result) {
  std::string products;
  for (const Json& product : result.run.at("products"))
    products += (products.empty() ? "" : ", ") + product.get<std::string>();
  const Json points = result.run.value("counts", Json::object()).value("points", Json::object());
  if (!products.empty())
    products[0] = static_cast<char>(products[0] - 'a' + 'A');  // names of products are plain letters
  return products + " from " + grouped(points.value("read", std::uint64_t{0})) + " points";
}

std::string navigation(const std::vector<std::pair<std::string, std::string>>& places) {
  std::string html = "<nav>";
  for (const auto& [id, name] : places) html += fmt::format("<a href=\"#{}\">{}</a>", id, name);
  return html + "</nav>\n";
}

const char* kPlan =
    "<section id=\"plan\"><h2>Plan</h2>\n<div class=\"plan\"><canvas tabindex=\"0\" aria-label=\"plan of the result\">"
    "</canvas><div class=\"plan-tools\"></div></div><p class=\"legend\" id=\"plan-legend\"></p></section>\n";
const char* kView =
    "<section id=\"view\"><h2>View in 3D</h2>\n<div id=\"viewer\"><p class=\"note\">The view needs a browser with "
    "WebGL 2.</p></div></section>\n";
const char* kNoView =
    "<section id=\"view\"><h2>View in 3D</h2>\n<p class=\"note\">This ilot was built without its viewer: tools/setup "
    "installs what it needs (npm), then configure and build again.</p></section>\n";

// Everything that the pages and their data are made from.
struct ReportParts {
  ResultFolder result;
  ReportLimits limits;
  PlanesOfReport planes;
  SceneFrame frame;
  std::vector<BuildingRow> rows;
  DrawnBuildings drawn;
  SampledPoints sample;
  StreetPlan street;
  FacadePages facades;
  std::string against, truth;  // HTML; empty without another result, without a truth
};

ReportParts gather(const std::filesystem::path& folder) {
  ReportParts parts;
  parts.result = open_result(folder);
  parts.limits = report_limits(parts.result.memory_bytes);
  parts.planes = planes_of_report(parts.result, parts.limits.planes);
  parts.frame = scene_frame(parts.result, parts.planes);
  parts.rows = building_rows(parts.result, parts.frame);
  parts.drawn = choose_drawn(parts.rows);
  SampleParams wanted;
  wanted.most_points = parts.limits.points;
  wanted.tasks = parts.limits.tasks;
  wanted.units = parts.drawn.units(parts.rows);
  parts.sample = sample_points(parts.result, wanted);
  parts.street = street_plan(parts.result);
  parts.facades = facade_pages(parts.result, parts.frame, parts.limits);
  return parts;
}

using Put = std::function<void(std::string_view)>;

// Writes the pages one after the other.
void put_sections(const ReportParts& p, bool viewer, const Put& put) {
  std::vector<std::pair<std::string, std::string>> places{{"made", "Made"}, {"view", "3D"}, {"plan", "Plan"}};
  const bool roofs = p.result.makes("roofs"), facades = p.result.makes("facades"), streets = p.result.makes("streets"),
             planes = p.result.has("planes.csv");
  if (!p.truth.empty()) places.emplace_back("truth", "Truth");
  if (!p.against.empty()) places.emplace_back("against", "Against");
  if (roofs) places.emplace_back("roofs", "Roofs");
  if (facades) places.emplace_back("facades", "Facades");
  if (streets) places.emplace_back("streets", "Streets");
  if (planes) places.emplace_back("planes", "Planes");
  for (const auto& [id, name] : {std::pair("inputs", "Inputs"), std::pair("parameters", "Parameters"),
                                 std::pair("lineage", "Lineage"), std::pair("stages", "Stages")})
    places.emplace_back(id, name);
  const std::string title = title_of(p.result);
  put(page_head("ilot: " + title) + "<header><h1>" + html_text(title) + "</h1>" + navigation(places) +
      "</header>\n<main>\n");
  put(made_section(p.result));
  put(left_out_section(p.result));
  put(viewer ? kView : kNoView);
  put(kPlan);
  put(p.truth);
  put(p.against);
  if (roofs) put(roofs_section(p.rows, p.drawn, p.sample.of_unit, p.frame));
  if (facades) put(p.facades.html);
  if (streets) put(streets_section(p.street, p.frame.metres_per_unit));
  if (planes) put(planes_section(p.planes, p.sample));
  put(inputs_section(p.result));
  put(parameters_section(p.result));
  put(lineage_section(p.result));
  put(stages_section(p.result));
  put("</main>\n<aside id=\"unit\" hidden></aside>\n");
}

Json scene_about(const ReportParts& p) {
  Json labels = Json::object();
  for (const auto& [value, name] : point_label_names()) labels[std::to_string(value)] = name;
  for (const StreetObject& o : p.street.objects)
    if (is_own_class(o.label)) labels[std::to_string(static_cast<std::uint32_t>(o.label))] = o.class_name;
  return {{"origin", {p.frame.origin.x, p.frame.origin.y, p.frame.origin.z}},
          {"metres_per_unit", p.frame.metres_per_unit},
          {"labels", labels}};
}

}  // namespace

void remove_report(const std::filesystem::path& folder) {
  std::filesystem::remove(folder / kReportFile);
  remove_building_tiles(folder);
}

ReportSummary write_report(const std::filesystem::path& folder, const ReportAdditions& additions) {
  ReportParts parts = gather(folder);
  parts.truth = additions.truth;
  if (!additions.against.empty())
    parts.against = against_section(parts.result, parts.rows, parts.frame, additions.against);
  const bool viewer = !viewer_script().empty();
  ReportSummary summary{0, viewer};
  WholeFileWriter file(folder / kReportFile);
  const auto put = [&](std::string_view text) {
    file.append(text);
    summary.bytes += text.size();
  };
  const auto put_json = [&](const char* name, const Json& json) {
    put(packed_element(name, json.dump(-1, ' ', false, Json::error_handler_t::replace)));
  };
  put_sections(parts, viewer, put);
  Json scene = scene_about(parts);
  put(packed_element("points", packed_points(parts.sample, parts.frame, scene["points"])));
  if (!parts.rows.empty()) {
    put_json("buildings", building_columns(parts.rows));
    const BuildingTiles tiles = write_building_tiles(folder, parts.rows);
    put(packed_element("outlines", tiles.outlines));
    put(tiles.elements);
    scene["building_tiles"] = tiles.about;
    summary.bytes += tiles.bytes_beside;
  }
  if (!parts.facades.scene.empty()) put_json("facades", parts.facades.scene);
  if (parts.result.makes("streets")) put_json("street", scene_street(parts.street, parts.frame));
  if (parts.planes.planes > 0) {
    put_json("planes", scene_planes(parts.planes.shown, parts.frame));
    put(packed_element("plane-outlines",
                       packed_outlines(plane_outlines(parts.result, parts.limits.outline_corners), parts.frame)));
  }
  put_json("scene", scene);
  put(page_tail(viewer_script()));
  file.finish();
  return summary;
}

}  // namespace ilot
