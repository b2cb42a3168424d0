// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/street_report.h"

#include <fmt/format.h>

#include <cmath>

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

std::string errors_text(const char* name, const ErrorSizes& e) {
  if (e.count == 0) return "";
  return fmt::format("  {:<34} median {:.3f} m, 95 % within {:.3f} m ({})\n", name, e.median, e.p95, e.count);
}

Json errors_json(const ErrorSizes& e) {
  const auto number = [](double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); };
  return {{"count", e.count}, {"median_m", number(e.median)}, {"p95_m", number(e.p95)}};
}

}  // namespace

std::string trees_text(const TreeResult& t) {
  return fmt::format("trees    true {}  found {}  matched {}  false {}  (unseen {}); trunk seen of {}\n", t.truth,
                     t.found, t.matched, t.false_found, t.unseen, t.trunks) +
         errors_text("position", t.position) + errors_text("position, trunk seen", t.position_with_trunk) +
         errors_text("position, crown only", t.position_without_trunk) +
         errors_text("height, to the highest point", t.height) + errors_text("height, to the tree", t.height_of_tree) +
         errors_text("crown radius", t.crown_radius) + errors_text("crown base", t.crown_base);
}

std::string kerbs_text(const KerbResult& k) {
  return fmt::format("kerbs    true {:.1f} m  found {:.1f} m  complete {:.1f} %  correct {:.1f} %  (unseen {:.1f} m)\n",
                     k.true_m, k.found_m, 100 * k.complete, 100 * k.correct, k.unseen_m) +
         fmt::format("  not seen, bridged: {:.1f} m, {:.1f} % of it at a true kerb\n", k.bridged_m,
                     100 * k.bridged_correct) +
         errors_text("in plan", k.plan) + errors_text("height of the step", k.height) +
         errors_text("height of the edge", k.elevation);
}

std::string pavements_text(const PavementResult& p) {
  const std::string stated = std::isfinite(p.within_stated)
                                 ? fmt::format("within the stated error {:.1f} %", 100 * p.within_stated)
                                 : "no errors stated";
  return fmt::format("pavements  true {:.1f} m  complete {:.1f} %  widths {}  (no true pavement {}, without end {})\n",
                     p.true_m, 100 * p.complete, p.stated, p.away, p.endless) +
         fmt::format("  within 10 cm {:.1f} %  {}  as built {}; passable within 10 cm {:.1f} %\n", 100 * p.near, stated,
                     p.built, 100 * p.passable_near) +
         errors_text("width", p.width) + errors_text("passable width", p.passable) + errors_text("carriageway", p.road);
}

std::string carriageways_text(const CarriagewayResult& c) {
  return fmt::format("carriageways  true {:.1f} m of kerb  found {}: {:.1f} m2  complete {:.1f} %  correct {:.1f} %\n",
                     c.true_m, c.found, c.found_m2, 100 * c.complete, 100 * c.correct);
}

Json trees_json(const TreeResult& t) {
  return {{"true", t.truth},
          {"unseen", t.unseen},
          {"found", t.found},
          {"matched", t.matched},
          {"false", t.false_found},
          {"trunks_seen", t.trunks},
          {"position", errors_json(t.position)},
          {"position_trunk_seen", errors_json(t.position_with_trunk)},
          {"position_crown_only", errors_json(t.position_without_trunk)},
          {"height", errors_json(t.height)},
          {"height_of_tree", errors_json(t.height_of_tree)},
          {"crown_radius", errors_json(t.crown_radius)},
          {"crown_base", errors_json(t.crown_base)}};
}

Json kerbs_json(const KerbResult& k) {
  return {{"true_m", k.true_m},
          {"unseen_m", k.unseen_m},
          {"found_m", k.found_m},
          {"complete", k.complete},
          {"correct", k.correct},
          {"bridged_m", k.bridged_m},
          {"bridged_correct", k.bridged_correct},
          {"plan", errors_json(k.plan)},
          {"height", errors_json(k.height)},
          {"elevation", errors_json(k.elevation)}};
}

Json pavements_json(const PavementResult& p) {
  return {{"true_m", p.true_m},
          {"complete", p.complete},
          {"stated", p.stated},
          {"away", p.away},
          {"endless", p.endless},
          {"as_built", p.built},
          {"near", p.near},
          {"within_stated", std::isfinite(p.within_stated) ? Json(p.within_stated) : Json(nullptr)},
          {"passable_near", p.passable_near},
          {"width", errors_json(p.width)},
          {"passable", errors_json(p.passable)},
          {"road", errors_json(p.road)}};
}

Json carriageways_json(const CarriagewayResult& c) {
  return {{"true_m", c.true_m},
          {"found", c.found},
          {"found_m2", c.found_m2},
          {"complete", c.complete},
          {"correct", c.correct}};
}

}  // namespace ilot
