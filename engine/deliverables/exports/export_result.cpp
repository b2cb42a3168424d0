// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/export_result.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "engine/deliverables/exports/facade_ifc.h"
#include "engine/deliverables/exports/new_folder.h"
#include "engine/deliverables/exports/roofs_glb.h"
#include "engine/deliverables/exports/roofs_gml.h"
#include "engine/deliverables/exports/roofs_ifc.h"
#include "engine/deliverables/exports/roofs_meshes.h"
#include "engine/deliverables/exports/tileset.h"
#include "engine/deliverables/layers/gpkg_readers.h"
#include "engine/deliverables/report/result_folder.h"
#include "engine/deliverables/solids/roofs_reader.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/model/building_geometry.h"
#include "engine/pass/stop.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRoofsFile = "roofs/roofs.city.jsonl";
constexpr const char* kObjectsFile = "streets/objects.gpkg";
constexpr std::array kFormats{
    ExportFormat{"glb", "roofs", "buildings as glTF, one binary file"},
    ExportFormat{"stl", "roofs", "buildings as triangles, binary STL"},
    ExportFormat{"ply", "roofs", "buildings as triangles in full coordinates, binary PLY"},
    ExportFormat{"citygml", "roofs", "buildings as CityGML 2.0"},
    ExportFormat{"ifc", "roofs or facades", "envelopes of buildings, and each facade, as IFC 4.3"},
    ExportFormat{"3dtiles", "roofs or streets", "buildings and objects of streets as 3D Tiles 1.1"},
};

// A format while it is written.
struct Sink {
  std::function<void(const BuildingModel&)> add;
  std::function<void()> finish;
};

template <class Writer, class... Arguments>
Sink sink_of(const Arguments&... arguments) {
  const auto writer = std::make_shared<Writer>(arguments...);
  return {[writer](const BuildingModel& model) { writer->add(model); }, [writer] { writer->finish(); }};
}

const ExportFormat& format_named(const std::string& name) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const auto& f) { return name == f.name; });
  if (found != kFormats.end()) return *found;
  std::string names;
  for (const ExportFormat& format : kFormats) names += (names.empty() ? "" : ", ") + std::string(format.name);
  throw Error("--to " + name + ": there is no such format; there are " + names, ExitCode::usage);
}

// A product of those that the format names, with " or " between them.
bool has_any(const ResultFolder& result, std::string_view products) {
  for (const char* product : {"roofs", "facades", "streets"})
    if (products.find(product) != products.npos && result.makes(product)) return true;
  return false;
}

void check_formats(const ResultFolder& result, const ExportParams& params) {
  for (const std::string& name : params.formats) {
    const ExportFormat& format = format_named(name);
    if (!has_any(result, format.product))
      throw Error(result.path.string() + ": was made without " + format.product + ", which " + name +
                      " needs; run again with --products",
                  ExitCode::usage);
  }
}

bool wants(const ExportParams& params, const char* format) {
  return std::find(params.formats.begin(), params.formats.end(), format) != params.formats.end();
}

// The CRS that --crs names. The coordinates of a result are in the unit of the run.
Crs given_crs(const std::string& text, double metres_per_unit) {
  constexpr double kSameUnit = 1e-4;  // international and US survey foot differ less
  Crs crs = crs_from_text(text);
  if (crs.geographic) throw Error("--crs " + text + ": is no system of plane coordinates", ExitCode::usage);
  if (std::abs(crs.metres_per_unit / metres_per_unit - 1) > kSameUnit)
    throw Error(fmt::format("--crs {}: its unit is {} m, that of the result is {} m", text, crs.metres_per_unit,
                            metres_per_unit),
                ExitCode::usage);
  return crs;
}

ExportFrame frame_of(const ResultFolder& result, const ExportParams& params) {
  ExportFrame frame;
  frame.metres_per_unit = result.metres_per_unit;
  if (!params.crs.empty()) {
    frame.crs = given_crs(params.crs, result.metres_per_unit);
    frame.crs_name = frame.crs.epsg != 0 ? "EPSG:" + std::to_string(frame.crs.epsg) : frame.crs.name;
  } else {
    const auto record = result.run.value("crs", nlohmann::ordered_json::object());
    frame.crs_name = record.value("name", "none");
    if (frame.crs_name == "none") frame.crs_name.clear();
    const std::string wkt = record.value("wkt", "");
    if (!wkt.empty())
      frame.crs = crs_from_text(wkt);
    else if (frame.crs_name.starts_with("EPSG:"))
      frame.crs = crs_from_text(frame.crs_name);
  }
  // Heads of files have the name on one line.
  std::replace_if(
      frame.crs_name.begin(), frame.crs_name.end(), [](unsigned char c) { return c < 32; }, ' ');
  return frame;
}

// Everything of the result that is exported, read once.
struct Scene {
  const ResultFolder& result;
  std::vector<StreetObject> objects;
  std::vector<fs::path> facades;  // facade-NNN.json, in their order
  bool roofs = false;

  fs::path roofs_path() const { return result.path / kRoofsFile; }
};

Scene scene_of(const ResultFolder& result) {
  Scene scene{result, {}, {}, result.has(kRoofsFile)};
  for (const ResultRecord& file : result.files)
    if (file.path.starts_with("facades/facade-") && file.path.ends_with(".json"))
      scene.facades.push_back(result.path / file.path);
  if (result.has(kObjectsFile)) scene.objects = read_objects_gpkg(result.path / kObjectsFile);
  return scene;
}

// The origin is that of the first building with a solid, where the reader ends, else of the first object, else
// of the first facade.
void place_origin(const Scene& scene, ExportFrame& frame) {
  struct Found {};
  if (!scene.facades.empty()) frame.origin = export_origin(read_facade_json(scene.facades[0]).origin);
  if (!scene.objects.empty()) frame.origin = export_origin(scene.objects[0].base);
  try {
    if (scene.roofs)
      for_each_roof(scene.roofs_path(), [&](const BuildingModel& model) {
        const Building* solid = finest_solid(model.levels);
        if (!solid || solid->vertices.empty()) return;
        frame.origin = export_origin(solid->vertices[0]);
        throw Found();
      });
  } catch (const Found&) {
  }
}

void add_tiles(const Scene& scene, const fs::path& folder, const ExportParams& params, const ExportFrame& frame,
               std::vector<Sink>& sinks, ExportSummary& summary) {
  const auto tiles = std::make_shared<Tileset>(folder / "3dtiles", frame, params.geoid_m);
  for (const StreetObject& object : scene.objects) tiles->add(object);
  summary.objects = scene.objects.size();
  if (!tiles->on_earth())
    summary.notes.push_back(
        "3dtiles: the coordinate system is unknown, so the tiles are not placed on the earth (--crs EPSG:n)");
  else if (params.geoid_m == 0)
    summary.notes.push_back("3dtiles: heights became heights above the ellipsoid as PROJ knows it for " +
                            frame.crs_name +
                            "; where its geoid is missing they stand too low or high (--geoid-height)");
  sinks.push_back({[tiles](const BuildingModel& model) { tiles->add(model); }, [tiles] { tiles->finish(); }});
}

std::vector<Sink> sinks_of(const Scene& scene, const fs::path& folder, const ExportParams& params,
                           const ExportFrame& frame, ExportSummary& summary) {
  std::vector<Sink> sinks;
  if (wants(params, "glb")) sinks.push_back(sink_of<RoofsGlb>(folder / "roofs.glb", frame));
  if (wants(params, "stl")) sinks.push_back(sink_of<RoofsStl>(folder / "roofs.stl", frame));
  if (wants(params, "ply")) sinks.push_back(sink_of<RoofsPly>(folder / "roofs.ply", frame));
  if (wants(params, "citygml")) sinks.push_back(sink_of<RoofsGml>(folder / "roofs.gml", frame));
  if (wants(params, "ifc") && scene.roofs) sinks.push_back(sink_of<RoofsIfc>(folder / "roofs.ifc", frame));
  if (wants(params, "3dtiles")) add_tiles(scene, folder, params, frame, sinks, summary);
  return sinks;
}

void export_facades(const Scene& scene, const fs::path& folder, const ExportFrame& frame, ExportSummary& summary) {
  for (const fs::path& path : scene.facades) {
    if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
    write_facade_ifc(folder / path.filename().replace_extension(".ifc"), read_facade_json(path), frame);
    ++summary.facades;
  }
}

void export_models(const Scene& scene, const fs::path& folder, const ExportParams& params, ExportFrame frame,
                   ExportSummary& summary) {
  if (wants(params, "ifc") && !scene.roofs && scene.facades.empty())
    throw Error(scene.result.path.string() + ": has neither a roof nor a facade, so there is nothing for ifc to write",
                ExitCode::usage);
  place_origin(scene, frame);
  const std::vector<Sink> sinks = sinks_of(scene, folder, params, frame, summary);
  if (scene.roofs)
    for_each_roof(scene.roofs_path(), [&](const BuildingModel& model) {
      if (stop_requested()) throw Error("interrupted: nothing was written", ExitCode::interrupted);
      ++summary.buildings;
      if (!finest_solid(model.levels)) ++summary.without_model;
      for (const Sink& sink : sinks) sink.add(model);
    });
  for (const Sink& sink : sinks) sink.finish();
  if (wants(params, "ifc")) export_facades(scene, folder, frame, summary);
}

}  // namespace

std::span<const ExportFormat> export_formats() {
  return kFormats;
}

ExportSummary export_result(const fs::path& path, const fs::path& folder, const ExportParams& params) {
  const ResultFolder result = open_result(path);
  check_formats(result, params);
  const ExportFrame frame = frame_of(result, params);
  NewFolder files(folder);
  ExportSummary summary;
  export_models(scene_of(result), files.part(), params, frame, summary);
  files.commit();
  return summary;
}

}  // namespace ilot
