// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/edit_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

using enum EditAction;

constexpr std::array kRules{
    EditRule{"facades", added, 2, 2, 0, true, false, true, false},
    EditRule{"facades", deleted, 2, 2, 0, false, false, true, false},
    EditRule{"facades", moved, 2, 2, 2, false, false, true, false},
    EditRule{"facades", kind, 2, 2, 0, false, true, true, false},
    EditRule{"facades", side, 2, 2, 0, false, false, true, false},
    EditRule{"roofs", kind, 0, 0, 0, false, true, false, true},
    EditRule{"roofs", merged, 2, 2, 0, false, false, false, false},
};

constexpr std::array<const char*, 4> kOpenings{"window", "door", "shop", "opening"};
constexpr std::array<const char*, 3> kPointKinds{"building", "ground", "other"};

std::string counted_places(std::size_t least, std::size_t most, const char* prefix) {
  if (most == 0) return fmt::format("no {}x1", prefix);
  if (least == 1 && most == 1) return fmt::format("one place, {0}x1 {0}y1 {0}z1", prefix);
  return fmt::format("{1} places, {0}x1 {0}y1 {0}z1 and {0}x2 {0}y2 {0}z2", prefix, least == 1 ? "one or two" : "two");
}

// The corners of an opening must not lie on one line along the wall or upright.
bool has_size(const std::vector<Vec3>& corners) {
  const double dx = corners[1].x - corners[0].x, dy = corners[1].y - corners[0].y;
  return dx * dx + dy * dy > 0 && corners[1].z != corners[0].z;
}

std::string kind_fault(const Edit& edit, const std::string& kind) {
  const auto one_of = [&](const auto& names) { return std::find(names.begin(), names.end(), kind) != names.end(); };
  if (kind.empty()) return "";
  if (edit.product == "roofs")
    return one_of(kPointKinds) ? "" : fmt::format("\"{}\" is no kind of points: building, ground or other", kind);
  return one_of(kOpenings) ? "" : fmt::format("\"{}\" is no kind of an opening: window, door, shop or opening", kind);
}

}  // namespace

const EditRule* edit_rule(const std::string& product, EditAction action) {
  const auto rule = std::find_if(kRules.begin(), kRules.end(),
                                 [&](const EditRule& r) { return product == r.product && action == r.action; });
  return rule == kRules.end() ? nullptr : &*rule;
}

std::string edit_rules_text() {
  std::string text, product;
  for (const EditRule& rule : kRules) {
    text += product == rule.product ? ", " : fmt::format("{}{}: ", text.empty() ? "" : "; ", rule.product);
    text += kEditActionNames.at(static_cast<std::size_t>(rule.action));
    product = rule.product;
  }
  return text;
}

std::string edit_fault(const Edit& edit, const EditRule& rule) {
  const std::string what =
      fmt::format("{} of {} needs ", kEditActionNames.at(static_cast<std::size_t>(rule.action)), rule.product);
  if (edit.at.size() < rule.least_at || edit.at.size() > rule.most_at)
    return what + counted_places(rule.least_at, rule.most_at, "");
  if (edit.to.size() != rule.to) return what + counted_places(rule.to, rule.to, "to_");
  if (rule.kind && edit.kind.empty()) return what + "a kind";
  if (rule.to_kind && edit.to_kind.empty()) return what + "a to_kind";
  if (rule.area == edit.area.rings.empty()) return what + (rule.area ? "an area, POLYGON ((x y, ...))" : "no area");
  if (edit.product == "facades" && edit.action != side) {
    if (!has_size(edit.at)) return "the corners of an opening are two opposite ones, at different places and heights";
    if (!edit.to.empty() && !has_size(edit.to)) return "the new corners of an opening are two opposite ones";
  }
  if (edit.low && edit.high && *edit.low > *edit.high) return "z1 is the lowest height and z2 the greatest";
  if (edit.action == merged && edit.at[0].x == edit.at[1].x && edit.at[0].y == edit.at[1].y)
    return "the two faces are given by two different places";
  if (edit.action == added)
    if (const std::string fault = kind_fault(edit, edit.kind); !fault.empty()) return fault;
  return kind_fault(edit, edit.to_kind);
}

}  // namespace ilot
