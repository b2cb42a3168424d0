// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/pass/measure.h"
#include "engine/run/inputs/inputs.h"
#include "engine/run/suitability.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/units.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDegrees = 180 / std::numbers::pi;

struct InfoArguments {
  std::vector<std::string> inputs;
  std::string dialect;
  bool json = false, quiet = false;
};

std::string stray_text(const CloudMeasure& m) {
  return grouped(m.strays) + (m.strays == 1 ? " point stands alone" : " points stand alone");
}

Json vector_json(Vec3 v) {
  return Json::array({v.x, v.y, v.z});
}

Json crs_json(const Crs& crs) {
  return {{"name", crs.name},
          {"epsg", crs.epsg == 0 ? Json() : Json(crs.epsg)},
          {"geographic", crs.geographic},
          {"metres_per_unit", crs.metres_per_unit},
          {"metres_per_unit_z", crs.metres_per_unit_z},
          {"unit_assumed", crs.unit_assumed}};
}

Json info_json(const CloudInfo& info, const CloudMeasure& m) {
  Json j{{"path", info.path.string()},
         {"format", info.format},
         {"dialect", info.dialect.empty() ? Json() : Json(info.dialect)},
         {"version", fmt::format("{}.{}", info.version_major, info.version_minor)},
         {"point_format", info.layout.point_format},
         {"record_length", info.layout.record_length},
         {"scale", info.layout.scale},
         {"offset", info.layout.offset},
         {"crs", crs_json(info.crs)}};
  j["extra_bytes"] = Json::array();
  for (const ExtraField& field : info.layout.extra) {
    j["extra_bytes"].push_back({{"name", field.name}, {"description", field.description}, {"bytes", field.size}});
  }
  j["points"] = {{"declared", info.declared_points}, {"read", m.points}, {"rejected", m.rejected}};
  j["bounds"] = {{"min", vector_json(m.min)}, {"max", vector_json(m.max)}};
  j["strays"] = {{"points", m.strays},
                 {"bounds_with_them", {{"min", vector_json(m.all_min)}, {"max", vector_json(m.all_max)}}}};
  j["declared_bounds"] = {{"min", vector_json(info.declared_min)}, {"max", vector_json(info.declared_max)}};
  j["classes"] = Json::object();
  for (std::size_t code = 0; code < m.classes.size(); ++code) {
    if (m.classes[code] > 0) j["classes"][std::to_string(code)] = m.classes[code];
  }
  j["area_m2"] = m.occupied_area;
  j["density_per_m2"] = {{"all_returns", m.density}, {"last_returns", m.last_return_density}};
  j["sampling_step_m"] = m.sampling_step;
  j["points_with_colour"] = m.with_colour;
  j["scans"] = Json::array();
  for (const ScanPart& scan : info.scans) j["scans"].push_back({{"name", scan.name}, {"points", scan.points}});
  j["stations"] = Json::array();
  for (const Station& station : info.stations) {
    j["stations"].push_back({{"name", station.name},
                             {"position", vector_json(station.position)},
                             {"azimuth_step_deg", station.azimuth_step * kDegrees},
                             {"elevation_step_deg", station.elevation_step * kDegrees}});
  }
  for (const CloudSuitability& s : suitability(info, m)) j["suits"][s.product] = {{"yes", s.yes}, {"reason", s.reason}};
  j["warnings"] = cloud_warnings(info, m);
  return j;
}

std::string crs_text(const Crs& crs) {
  std::string text = crs.name.empty() ? "unknown" : crs.name;
  if (crs.epsg != 0) text += fmt::format(" (EPSG:{})", crs.epsg);
  if (crs.geographic) return text + ", degrees";
  if (crs.unit_assumed) return text + ", unit unknown, metres assumed";
  return text + fmt::format(", {} m per unit, {} m in z", crs.metres_per_unit, crs.metres_per_unit_z);
}

std::string box_text(Vec3 min, Vec3 max) {
  return fmt::format("{:.3f} {:.3f} {:.3f} to {:.3f} {:.3f} {:.3f}", min.x, min.y, min.z, max.x, max.y, max.z);
}

std::string info_text(const CloudInfo& info, const CloudMeasure& m) {
  std::string out = info.path.string() + "\n";
  const auto row = [&](const char* name, const std::string& value) {
    out += fmt::format("  {:<14} {}\n", name, value);
  };
  const bool las = !info.header.empty();
  const std::string version = las ? fmt::format(" {}.{}", info.version_major, info.version_minor) : "";
  row("format", fmt::format("{}{}, point format {}, {} bytes per point", info.format, version, info.layout.point_format,
                            info.layout.record_length));
  if (!info.dialect.empty()) row("text", info.dialect);
  for (const ExtraField& field : info.layout.extra) row("extra bytes", field.name + "  " + field.description);
  row("CRS", crs_text(info.crs));
  row("points", fmt::format("{} ({} in the header)", grouped(m.points), grouped(info.declared_points)));
  row("bounds", box_text(m.min, m.max));
  if (m.strays > 0) row("strays", stray_text(m) + "; bounds with strays " + box_text(m.all_min, m.all_max));
  for (std::size_t code = 0; code < m.classes.size(); ++code) {
    if (m.classes[code] == 0) continue;
    const double share = 100.0 * static_cast<double>(m.classes[code]) / static_cast<double>(m.points);
    row(fmt::format("class {}", code).c_str(), fmt::format("{} ({:.1f} %)", grouped(m.classes[code]), share));
  }
  row("area", fmt::format("{:.0f} m2 with points", m.occupied_area));
  row("density", fmt::format("{:.2f} points/m2, last returns {:.2f}", m.density, m.last_return_density));
  row("sampling step", fmt::format("{:.3g} m", m.sampling_step));
  if (m.with_colour > 0) row("colour", grouped(m.with_colour) + " points");
  for (const ScanPart& scan : info.scans) row("scan", scan.name + ": " + grouped(scan.points) + " points");
  for (const Station& station : info.stations) {
    const Vec3 at = station.position;
    const bool known = station.azimuth_step > 0;
    const std::string steps = known ? fmt::format(", steps of {:.4f} and {:.4f} degrees",
                                                  station.azimuth_step * kDegrees, station.elevation_step * kDegrees)
                                    : "";
    row("station", fmt::format("{}: {:.3f} {:.3f} {:.3f}{}", station.name, at.x, at.y, at.z, steps));
  }
  for (const CloudSuitability& s : suitability(info, m)) row(s.product.c_str(), (s.yes ? "yes: " : "no: ") + s.reason);
  for (const std::string& warning : cloud_warnings(info, m)) row("warning", warning);
  return out;
}

// A bad file does not hide the others. The message names it, and the exit code reports the fault.
int info_command(const InfoArguments& given) {
  if (given.inputs.empty()) throw Error("info: no INPUT given (ilot info --help)", ExitCode::usage);
  const auto files = expand_inputs(given.inputs);
  const OpenOptions open = open_options(given.dialect);
  Json all = Json::array();
  std::size_t bad = 0;
  for (const auto& file : files) {
    try {
      ConsoleProgress progress(given.quiet ? Verbosity::quiet : Verbosity::normal, "");
      const auto reader = open_cloud(file, open);
      progress.get().begin_stage(file.filename().string(), 2 * reader->info().points);
      const CloudMeasure m = measure_cloud(*reader, [&](std::uint64_t n) { progress.get().advance(n); });
      progress.get().clear_line();
      if (given.json) all.push_back(info_json(reader->info(), m));
      if (!given.json) print(info_text(reader->info(), m));
    } catch (const Error& fault) {
      if (files.size() == 1 || fault.code() == ExitCode::interrupted) throw;
      say(fmt::format("ilot: {}\n", fault.what()));
      ++bad;
    }
  }
  if (given.json) print(all.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  if (bad == 0) return static_cast<int>(ExitCode::ok);
  return static_cast<int>(bad == files.size() ? ExitCode::failed : ExitCode::incomplete);
}

}  // namespace

void add_info_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("info", "Describes what point clouds contain, as measured");
  auto given = std::make_shared<InfoArguments>();
  command->add_option("INPUT", given->inputs, "point clouds: files, folders, patterns, URLs")->option_text("...");
  add_dialect_option(*command, given->dialect);
  command->add_flag("--json", given->json, "a JSON list with one object per file [off]");
  command->add_flag("-q,--quiet", given->quiet, "no progress [off]");
  command->footer("Example: ilot info district.las --json");
  command->callback([given, &action] { action = [given] { return info_command(*given); }; });
}

}  // namespace ilot
