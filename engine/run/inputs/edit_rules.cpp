// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/edit_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/model/point_label.h"

namespace ilot {
namespace {

using enum EditAction;

constexpr std::array kRules{
    EditRule{"facades", added, 2, 0, true, Needed::no, true, false},
    EditRule{"facades", deleted, 2, 0, false, Needed::no, true, false},
    EditRule{"facades", moved, 2, 2, false, Needed::possible, true, false},
    EditRule{"facades", kind, 2, 0, false, Needed::yes, true, false},
    EditRule{"facades", side, 2, 0, false, Needed::no, true, false},
    EditRule{"streets", added, 1, 0, true, Needed::no, false, false},
    EditRule{"streets", deleted, 1, 0, false, Needed::no, false, false},
    EditRule{"streets", kind, 1, 0, false, Needed::yes, false, false},
    EditRule{"streets", merged, 2, 0, false, Needed::possible, false, false},
    EditRule{"streets", split, 2, 0, false, Needed::no, false, false},
    EditRule{"roofs", kind, 0, 0, false, Needed::yes, false, true},
    EditRule{"roofs", merged, 2, 0, false, Needed::no, false, false},
};

constexpr std::array<const char*, 4> kOpenings{"window", "door", "shop", "opening"};
constexpr std::array<const char*, 3> kPointKinds{"building", "ground", "other"};

// The columns of `places` places.
std::string counted_places(std::size_t places, bool heights, const char* prefix) {
  const auto columns = [&](int n) {
    return fmt::format("{0}x{1} {0}y{1}", prefix, n) + (heights ? fmt::format(" {}z{}", prefix, n) : "");
  };
  if (places == 0) return fmt::format("no {}x1", prefix);
  return places == 1 ? "one place, " + columns(1) : "two places, " + columns(1) + " and " + columns(2);
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
  if (edit.product == "streets") {
    const auto label = label_named(kind);
    return label && is_street_object(*label) ? "" : fmt::format("\"{}\" is no class of street objects", kind);
  }
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
  if (edit.at.size() != rule.at) return what + counted_places(rule.at, rule.heights, "");
  if (edit.to.size() != rule.to) return what + counted_places(rule.to, rule.heights, "to_");
  if (rule.kind && edit.kind.empty()) return what + "a kind";
  if (rule.to_kind == Needed::yes && edit.to_kind.empty()) return what + "a to_kind";
  if (rule.to_kind == Needed::no && !edit.to_kind.empty()) return what + "no to_kind";
  if (rule.area == edit.area.rings.empty()) return what + (rule.area ? "an area, POLYGON ((x y, ...))" : "no area");
  if (edit.product == "facades" && edit.action != side) {
    if (!has_size(edit.at)) return "the corners of an opening are two opposite ones, at different places and heights";
    if (!edit.to.empty() && !has_size(edit.to)) return "the new corners of an opening are two opposite ones";
  }
  if (edit.low && edit.high && *edit.low > *edit.high) return "z1 is the lowest height and z2 the greatest";
  if ((edit.action == merged || edit.action == split) && edit.at[0].x == edit.at[1].x && edit.at[0].y == edit.at[1].y)
    return "two different places are needed";
  if (edit.action == added)
    if (const std::string fault = kind_fault(edit, edit.kind); !fault.empty()) return fault;
  return kind_fault(edit, edit.to_kind);
}

}  // namespace ilot
