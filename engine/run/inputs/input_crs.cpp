// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/input_crs.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "engine/deliverables/layers/footprints.h"
#include "engine/error.h"
#include "engine/formats/changed_reader.h"
#include "engine/formats/crs.h"
#include "engine/formats/crs_transform.h"
#include "engine/run/inputs/input_places.h"

namespace ilot {
namespace {

bool is_known(const Crs& crs) {
  return !crs.wkt.empty() || crs.epsg != 0;
}

Error usage(const std::string& sentence) {
  return Error(sentence, ExitCode::usage);
}

void note_choice(const std::string& value, const std::string& why, RunRecord& record) {
  record.chosen.push_back({"crs", value, why});
}

Crs agreed_crs(const RunInputs& inputs, const RunOptions& options) {
  if (!options.crs.empty()) return crs_from_text(options.crs);
  std::set<std::string> names;
  const Crs* known = nullptr;
  for (const auto& reader : inputs.readers) {
    const Crs& crs = reader->info().crs;
    if (crs.wkt.empty() && crs.epsg == 0 && crs.name.empty()) continue;
    names.insert(crs_name(crs));
    if (known == nullptr) known = &crs;
  }
  if (names.size() > 1) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
    throw usage("the inputs are in different coordinate systems (" + list + "); run them apart or give --crs");
  }
  return known != nullptr ? *known : inputs.readers.front()->info().crs;
}

std::string kind_of(const Crs& crs) {
  return is_geocentric(crs) ? "geocentric" : "degrees";
}

std::string place_text(Vec3 place) {
  return fmt::format("x = {:.3f}, y = {:.3f}", place.x, place.y);
}

// A CRS that cannot contain the places is wrong, whatever its source is.
void check_degrees(RunInputs& inputs, const RunOptions& options, const PlaceBox& box, Progress& progress,
                   RunRecord& record) {
  if (can_be_at(inputs.crs, box.one)) return;
  const std::string where = place_text(box.one);
  if (!options.crs.empty())
    throw usage("--crs " + options.crs + (is_geocentric(inputs.crs) ? " is geocentric" : " is in degrees") +
                ", which " + where + " cannot be; give the projected CRS that the coordinates are in");
  const std::string warning = "the inputs say " + kind_of(inputs.crs) + " (" + crs_name(inputs.crs) + "), which " +
                              where + " cannot be: metres in an unknown CRS are assumed; --crs EPSG:n says it";
  progress.warn(warning);
  record.warnings.push_back(warning);
  inputs.crs = Crs{};
}

// Says what --to-crs could do. Near the poles, or where PROJ does not understand the CRS, there is no zone of UTM.
std::string ways_to_project(const Crs& crs, Vec3 place) {
  try {
    const std::string zone = std::to_string(utm_at(crs, place).epsg);
    return "--to-crs utm projects them (here to EPSG:" + zone + "), --to-crs EPSG:n to another CRS";
  } catch (const Error&) {
    return "--to-crs EPSG:n projects them";
  }
}

[[noreturn]] void refuse_degrees(const RunInputs& inputs, const RunOptions& options, const PlaceBox& box) {
  std::string sentence = "the coordinates are " + kind_of(inputs.crs) + " (" + crs_name(inputs.crs) +
                         "), products need metres or feet in a plane: " + ways_to_project(inputs.crs, box.one);
  if (options.crs.empty()) sentence += "; if the inputs are wrong, --crs EPSG:n says what they are in";
  throw usage(sentence);
}

void reproject_all(RunInputs& inputs, const RunOptions& options, const PlaceBox& box, Progress& progress,
                   RunRecord& record) {
  if (!is_known(inputs.crs))
    throw usage("--to-crs " + options.to_crs + ": no input says its CRS; give it with --crs EPSG:n");
  const Crs target = options.to_crs == "utm" ? utm_at(inputs.crs, box.one) : crs_from_text(options.to_crs);
  if (target.geographic)
    throw usage("--to-crs " + options.to_crs + " is in degrees; products need a projected CRS, such as --to-crs utm");
  for (auto& reader : inputs.readers) reader = reprojected(std::move(reader), inputs.crs, target, box.one);
  const std::string why = "reprojected from " + crs_name(inputs.crs) + " by --to-crs " + options.to_crs;
  progress.note("coordinates are in " + crs_name(target) + ": " + why);
  note_choice(crs_name(target), why, record);
  inputs.crs = inputs.readers.front()->info().crs;
}

// Returns whether it is taken.
bool take_crs_of_footprints(RunInputs& inputs, const RunOptions& options, Progress& progress, RunRecord& record) {
  const FootprintSource source = footprint_source(options.footprints);
  const auto box = sampled_box(inputs.readers);
  if (!is_known(source.crs) || source.crs.geographic || !box) return false;
  const PlaceBox theirs{source.min_x, source.min_y, source.max_x, source.max_y, {}};
  const std::string path = options.footprints.string();
  if (!widened(*box).touches(theirs))
    throw usage(path + ": is in " + crs_name(source.crs) + " (" + theirs.text() +
                "); the inputs say no CRS and are elsewhere (" + box->text() + "): give theirs with --crs EPSG:n");
  const std::string why =
      "no input says its CRS; that of " + path + " is taken, whose outlines are where the points are";
  progress.note("coordinates are in " + crs_name(source.crs) + ": " + why);
  note_choice(crs_name(source.crs), why, record);
  inputs.crs = source.crs;
  return true;
}

// Makes the readers say the CRS of the run, so that labelled clouds do. `replaces`: also those that say one themselves.
// The records of a cloud that says it already stay as they are.
void give_crs(RunInputs& inputs, bool replaces) {
  const auto is_same = [&](const Crs& crs) {
    return crs.epsg == inputs.crs.epsg && crs.wkt == inputs.crs.wkt &&
           crs.metres_per_unit == inputs.crs.metres_per_unit && crs.metres_per_unit_z == inputs.crs.metres_per_unit_z;
  };
  for (auto& reader : inputs.readers)
    if (const Crs& own = reader->info().crs; replaces ? !is_same(own) : !is_known(own))
      reader = in_crs(std::move(reader), inputs.crs);
}

double make_heights_alike(RunInputs& inputs, const RunOptions& options, Progress& progress, RunRecord& record) {
  constexpr double kSameUnit = 1e-4;  // international and US survey foot differ less
  const auto factor_of = [](const Crs& crs) { return crs.metres_per_unit_z / crs.metres_per_unit; };
  double changed = 1;
  for (auto& reader : inputs.readers) {
    const Crs& own = reader->info().crs;
    const double factor = options.crs.empty() && is_known(own) ? factor_of(own) : factor_of(inputs.crs);
    if (std::abs(factor - 1) <= kSameUnit) continue;
    reader = with_heights_in_unit(std::move(reader), factor);
    changed = factor;
  }
  if (changed == 1) return 1;
  const std::string note = fmt::format(
      "heights are in units of {} m, positions in units of {} m ({}): products give both in the unit of positions, "
      "points/ keeps the records as they are",
      inputs.crs.metres_per_unit_z, inputs.crs.metres_per_unit, crs_name(inputs.crs));
  progress.note(note);
  record.warnings.push_back(note);
  inputs.crs = horizontal_crs(inputs.crs);
  return changed;
}

// Of plan and heights from two systems the code is that of the plan alone.
bool is_said_by_code(const Crs& crs) {
  const auto has_heights = [](const Crs& c) { return horizontal_crs(c).wkt != c.wkt; };
  if (crs.epsg == 0 || !has_heights(crs)) return crs.epsg != 0;
  try {
    return has_heights(crs_from_epsg(crs.epsg));
  } catch (const Error&) {  // a file may claim any code
    return false;
  }
}

}  // namespace

std::string crs_name(const Crs& crs) {
  if (crs.epsg != 0) return "EPSG:" + std::to_string(crs.epsg);
  return crs.name.empty() ? "none" : crs.name;
}

CrsRecord crs_record(const Crs& crs) {
  return {crs_name(crs), crs.metres_per_unit, is_said_by_code(crs) ? std::string() : crs.wkt};
}

double resolve_crs(RunInputs& inputs, const RunOptions& options, Progress& progress, RunRecord& record) {
  inputs.crs = agreed_crs(inputs, options);
  if (inputs.crs.geographic || !options.to_crs.empty()) {
    const auto box = sampled_box(inputs.readers);
    if (!box) throw Error("no input has a point with usable coordinates");
    if (inputs.crs.geographic) check_degrees(inputs, options, *box, progress, record);
    if (!options.to_crs.empty()) reproject_all(inputs, options, *box, progress, record);
    if (inputs.crs.geographic) refuse_degrees(inputs, options, *box);
  }
  bool replaces = !options.crs.empty();
  if (!is_known(inputs.crs) && !options.footprints.empty())
    replaces = take_crs_of_footprints(inputs, options, progress, record);
  // Reprojected inputs say their CRS already.
  if (options.to_crs.empty() && is_known(inputs.crs)) give_crs(inputs, replaces);
  return make_heights_alike(inputs, options, progress, record);
}

}  // namespace ilot
