// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/solids/solid_file.h"
#include "engine/error.h"
#include "engine/run/inputs/inputs.h"
#include "engine/validity/validate_drawing.h"
#include "engine/validity/validate_las.h"
#include "tools/ilot/commands.h"
#include "tools/ilot/console.h"
#include "tools/ilot/validate_models.h"

namespace ilot {
namespace {

struct ValidateArguments {
  std::vector<std::string> inputs;
  ValidityParams tolerances;
  bool quiet = false, json = false;
};

std::vector<Finding> findings_of(const std::filesystem::path& file, bool quiet) {
  ConsoleProgress progress(quiet ? Verbosity::quiet : Verbosity::normal, "");
  try {
    const auto reader = open_cloud(file);
    progress.get().begin_stage(file.filename().string(), reader->info().points);
    auto findings = validate_las(*reader, [&](std::uint64_t n) { progress.get().advance(n); });
    progress.get().clear_line();
    return findings;
  } catch (const Error& fault) {
    progress.get().clear_line();
    if (fault.code() != ExitCode::failed) throw;
    return {{"unreadable", fault.what(), true}};
  }
}

bool is_valid(const std::vector<Finding>& findings) {
  return std::none_of(findings.begin(), findings.end(), [](const Finding& f) { return f.severe; });
}

void print_findings(const std::filesystem::path& file, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings)
    print(one_line(
        fmt::format("{}: {}: {}: {}", file.string(), finding.severe ? "invalid" : "note", finding.rule, finding.text)));
  if (is_valid(findings)) print(one_line(file.string() + ": valid"));
}

std::string findings_json(const std::filesystem::path& file, const std::vector<Finding>& findings) {
  nlohmann::json list = nlohmann::json::array();
  for (const Finding& f : findings) list.push_back({{"rule", f.rule}, {"text", f.text}, {"severe", f.severe}});
  const nlohmann::json entry{{"file", file.string()}, {"valid", is_valid(findings)}, {"findings", std::move(list)}};
  return entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

// Prints the findings, or appends them to `json` if it is given.
bool validate_file(const std::filesystem::path& file, const ValidateArguments& given, std::string* json) {
  if (is_solid_file(file)) return print_models_validity(file, given.tolerances, json);
  const std::vector<Finding> findings =
      is_dxf_file(file) ? validate_drawing_file(file) : findings_of(file, given.quiet || given.json);
  if (json)
    *json += (json->empty() ? "" : ",\n") + findings_json(file, findings);
  else
    print_findings(file, findings);
  return is_valid(findings);
}

// Checks all files and names those of other formats.
int validate_command(const ValidateArguments& given) {
  if (given.inputs.empty()) throw Error("validate: no FILE given (ilot validate --help)", ExitCode::usage);
  bool all_valid = true, all_judged = true;
  std::string json;
  for (const auto& file : expand_inputs(given.inputs)) {
    try {
      all_valid = validate_file(file, given, given.json ? &json : nullptr) && all_valid;
    } catch (const Error& fault) {
      if (fault.code() != ExitCode::usage) throw;
      say(one_line(std::string("ilot: ") + fault.what()));
      all_judged = false;
    }
  }
  if (given.json) print(fmt::format("{{\"valid\":{},\"files\":[\n{}\n]}}\n", all_valid, json));
  if (!all_valid) return static_cast<int>(ExitCode::failed);
  return static_cast<int>(all_judged ? ExitCode::ok : ExitCode::usage);
}

}  // namespace

void add_validate_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("validate",
                                         "Checks files: geometries of CityJSON, OBJ, OFF and POLY against ISO 19107, "
                                         "DXF drawings, LAS headers against points");
  auto given = std::make_shared<ValidateArguments>();
  command->add_option("FILE", given->inputs, "CityJSON, CityJSONSeq, OBJ, OFF, POLY, DXF, LAS and LAZ files, patterns")
      ->option_text("...");
  ValidityParams& tolerances = given->tolerances;
  command
      ->add_option("--planarity", tolerances.plane_distance,
                   "models: greatest distance of a corner from its face's plane, CRS units [0.01]")
      ->option_text("D")
      ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--normals", tolerances.plane_normals_deg,
                   "models: largest angle between the triangles of a face, degrees [20]")
      ->option_text("DEG")
      ->check(CLI::Range(0.0, 180.0));
  command->add_option("--snap", tolerances.snap, "models: corners at most this far apart are one, CRS units [0.001]")
      ->option_text("D")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", given->json, "one JSON object on standard output [off]");
  command->add_flag("-q,--quiet", given->quiet, "no progress [off]");
  command->footer(
      "Codes, and tolerances by default, are those of val3dity 2.6, whose options are called --planarity_d2p_tol, "
      "--planarity_n_tol and --snap_tol (docs/validity.md).\n"
      "Exit codes: 0 all valid, 1 one is not, 2 usage.\nExample: ilot validate out/roofs/roofs.city.json");
  command->callback([given, &action] { action = [given] { return validate_command(*given); }; });
}

}  // namespace ilot
