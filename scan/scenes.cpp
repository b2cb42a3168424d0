// SPDX-License-Identifier: Apache-2.0
#include "scan/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/error.h"
#include "engine/settings/nearest_name.h"
#include "scan/districts/district_file.h"
#include "scan/facades/building.h"
#include "scan/facades/facade_haussmann.h"
#include "scan/facades/facade_restoration.h"
#include "scan/facades/shapes.h"
#include "scan/facades/stones.h"
#include "scan/models/model_scan.h"
#include "scan/roofs/roofs_scan.h"
#include "scan/streets/street_flight.h"
#include "scan/streets/street_scan.h"
#include "scan/wild/distributions.h"
#include "scan/wild/facade/wild_scenes.h"
#include "scan/wild/roofs/wild_roofs_scan.h"
#include "scan/wild/street/wild_street_scan.h"

namespace ilot::scan {

namespace {

constexpr std::string_view kScaled = "to about 1 % from 100,000 points on, by scaling the angular step";
constexpr std::string_view kModelPoints = "to about 2 % from 100,000 points on, by scaling steps and density";

std::string options_text(std::span<const SceneOption> options) {
  std::string text;
  for (const SceneOption& option : options)
    text += fmt::format("  {:<18} {} ({} to {}) [{} {}]\n", option.key, option.help, option.low, option.high,
                        option.standard, option.unit);
  return text;
}

std::string options_markdown(std::span<const SceneOption> options) {
  std::string text = "| key | default | range | meaning |\n|---|---|---|---|\n";
  for (const SceneOption& option : options)
    text += fmt::format("| `{}` | {} | {} to {} {} | {} |\n", option.key, option.standard, option.low, option.high,
                        option.unit, option.help);
  return text;
}

constexpr std::string_view kWild = "about; without it the drawn density decides, up to 2,000,000";

}  // namespace

std::span<const Scene> scenes() {
  static const std::array kScenes{
      Scene{"stones", "four facing stones, their joints and two side walls, one station", kScaled, stones_options(),
            scan_planned<plan_stones>},
      Scene{"facade-restoration", "a plain town house of fifteen windows, one station off to the left", kScaled,
            facade_restoration_options(), scan_planned<plan_facade_restoration>},
      Scene{"facade-haussmann", "a front of banded stone with arches, balconies and a mansard, two stations", kScaled,
            facade_haussmann_options(), scan_planned<plan_facade_haussmann>},
      Scene{"building", "a free-standing house with bulges in its render, six stations around it", kScaled,
            building_options(), scan_planned<plan_building>},
      Scene{"shapes", "cylinders, spheres, cones and boxes of several sizes on a floor, three stations", kScaled,
            shapes_options(), scan_planned<plan_shapes>},
      Scene{"roofs", "445 roofs of every kind with trees beside them, seen from the air; writes their solids too",
            "about; the density follows", roofs_options(), scan_roofs_scene},
      Scene{"street", "30 blocks on both sides of a street, 442 objects on its pavements, scanned from a vehicle",
            "to about 1 %, by scaling the spacing of profiles and pulses", street_options(), scan_street_scene},
      Scene{"street-air", "that street and the gardens behind its houses, seen from the air",
            "about; the density follows", street_flight_options(), scan_street_flight_scene},
      Scene{"street-wild", "a street with its yards that is drawn from wide distributions, with objects of 70 kinds",
            "about; without it the extent follows the density, up to 2 million points", wild_street_options(),
            scan_wild_street_scene, kWildStreetGroups},
      Scene{"roofs-wild", "a town from the air, with roofs and faults that are drawn from wide distributions",
            "about; without it the extent follows the density, up to 2 million points", wild_roofs_options(),
            scan_wild_roofs_scene, kWildRoofsGroups},
      Scene{"district", "a town of houses under flat, gable and hip roofs, seen from the air",
            "exactly; the area follows from the density", district_options(), scan_district_scene},
      Scene{"facade-wild", "one house, its neighbours and what stands before it; everything is drawn", kWild,
            drawn_options(kFacadeWildGroups), scan_wild_scene<plan_facade_wild>, kFacadeWildGroups},
      Scene{"row-wild", "a row of 3 to 12 houses and often the other side of the street; everything is drawn", kWild,
            drawn_options(kRowWildGroups), scan_wild_scene<plan_row_wild>, kRowWildGroups},
      Scene{"court-wild", "a court scanned from inside, four fronts; everything is drawn", kWild,
            drawn_options(kCourtWildGroups), scan_wild_scene<plan_court_wild>, kCourtWildGroups},
  };
  return kScenes;
}

const Scene& find_scene(std::string_view name) {
  const std::span<const Scene> all = scenes();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Scene& s) { return s.name == name; });
  if (found == all.end()) {
    std::vector<std::string> names;
    for (const Scene& s : all) names.emplace_back(s.name);
    throw Error(fmt::format("scan: no scene '{}'{} (ilot scan --list)", name, did_you_mean(name, names)),
                ExitCode::usage);
  }
  return *found;
}

namespace {

std::string join(std::span<const std::string_view> names) {
  std::string text;
  for (std::string_view name : names) text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string list_drawn() {
  std::string text = fmt::format("Drawn by the wild scenes (distributions.csv, sha256 {})\n", distributions_hash());
  for (const Distribution& row : distributions()) {
    const std::string_view unit = row.unit == "-" ? "" : row.unit;
    const std::string range =
        row.choices.empty() ? fmt::format("{} to {} {}", row.from, row.to, unit) : join(row.choices);
    text += fmt::format("  {:<24} {} ({}) [{}, for each {}]{}\n", "scene." + std::string(row.name), row.meaning, range,
                        row.group, row.per, row.family.empty() ? "" : " --without " + std::string(row.family));
  }
  return text;
}

}  // namespace

std::string list_scenes() {
  std::string text;
  for (const Scene& scene : scenes()) {
    text += fmt::format("{:<20} {}\n", scene.name, scene.help);
    text += fmt::format("  {:<18} {}\n", "--points", scene.points);
    if (!scene.groups.empty()) {
      text += fmt::format("  {:<18} of the groups {}, see below\n", "drawn parameters", join(scene.groups));
      continue;
    }
    text += options_text(scene.options);
  }
  text += fmt::format("{:<20} {}\n  {:<18} {}\n", "--model FILE", "a model that you have, CityJSON or OBJ", "--points",
                      kModelPoints);
  return text + options_text(model_options()) + list_drawn();
}

std::string scenes_markdown() {
  std::string text = "## Options\n\nGenerated from the table in `scan/scenes.cpp`; `--set KEY=VALUE`.\n";
  for (const Scene& scene : scenes()) {
    text += fmt::format("\n### {}\n\nA scan of {}. `--points` is met {}.\n\n", scene.name, scene.help, scene.points);
    if (!scene.groups.empty()) {
      text += fmt::format("Draws from the groups {} of `scan/wild/distributions.csv`; families for `--without`: {}.\n",
                          join(scene.groups), join(families_of(scene.groups)));
      continue;
    }
    text += options_markdown(scene.options);
  }
  text += fmt::format("\n### --model FILE\n\nA scan of a model that you have. `--points` is met {}.\n\n", kModelPoints);
  return text + options_markdown(model_options());
}

}  // namespace ilot::scan
