// SPDX-License-Identifier: Apache-2.0
#include "engine/settings/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <type_traits>

namespace ilot {
namespace {

// Converts a field of Settings to a Value and back.
template <class T>
struct Field {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = std::is_same_v<T, bool>       ? ParameterKind::boolean
                                         : std::is_floating_point_v<T> ? ParameterKind::number
                                                                       : ParameterKind::integer;
  using Stored = std::conditional_t<std::is_same_v<T, bool>, bool,
                                    std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>>;
  static Value get(const T& field) { return static_cast<Stored>(field); }
  static void set(T& field, const Value& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
      field = static_cast<T>(*whole);
    } else {
      field = static_cast<T>(std::get<Stored>(value));
    }
  }
};

template <class T>
struct Field<std::optional<T>> {
  static constexpr bool kOptional = true;
  static constexpr ParameterKind kKind = Field<T>::kKind;
  static Value get(const std::optional<T>& field) { return field ? Field<T>::get(*field) : Value(Auto{}); }
  static void set(std::optional<T>& field, const Value& value) {
    field.reset();
    if (!std::holds_alternative<Auto>(value)) Field<T>::set(field.emplace(), value);
  }
};

template <>
struct Field<std::vector<int>> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::integers;
  static Value get(const std::vector<int>& field) { return std::vector<std::int64_t>(field.begin(), field.end()); }
  static void set(std::vector<int>& field, const Value& value) {
    const auto& list = std::get<std::vector<std::int64_t>>(value);
    field.clear();
    for (std::int64_t entry : list) field.push_back(static_cast<int>(entry));
  }
};

template <>
struct Field<std::vector<double>> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::numbers;
  static Value get(const std::vector<double>& field) { return field; }
  static void set(std::vector<double>& field, const Value& value) {
    if (const auto* whole = std::get_if<std::vector<std::int64_t>>(&value)) {
      field.assign(whole->begin(), whole->end());
    } else {
      field = std::get<std::vector<double>>(value);
    }
  }
};

// A choice among names, in the order of the enumeration.
template <class E>
requires std::is_enum_v<E>
struct Field<E> {
  static constexpr bool kOptional = false;
  static constexpr ParameterKind kKind = ParameterKind::choice;
  static Value get(E field) { return std::string(names_of(field)[static_cast<std::size_t>(field)]); }
  static void set(E& field, const Value& value) {
    const auto names = names_of(field);
    field = static_cast<E>(std::find(names.begin(), names.end(), std::get<std::string>(value)) - names.begin());
  }
};

template <class Access>
Parameter make(const char* key, Access access, ValueRange range, const char* unit, const char* help) {
  using F = Field<std::remove_cvref_t<decltype(access(std::declval<Settings&>()))>>;
  return {key,
          F::kKind,
          F::kOptional,
          range,
          {},
          unit,
          help,
          [access](const Settings& s) { return F::get(access(s)); },
          [access](Settings& s, const Value& value) { F::set(access(s), value); }};
}

Parameter with_choices(Parameter parameter, std::span<const std::string_view> choices) {
  parameter.choices = choices;
  return parameter;
}

#define ILOT_FIELD(path) \
  [](auto& s) -> auto& { \
    return s.path;       \
  }

std::vector<Parameter> make_table() {
  return {
      make("seed", ILOT_FIELD(seed), {0, 0x1p53 - 1}, "", "varies the random draws; any value is reproducible"),
      make("index.block_points", ILOT_FIELD(index.block_points), {256, 0x1p26}, "points",
           "most points in one block of the store; results do not depend on it"),
      make("index.finest_step", ILOT_FIELD(index.finest_step), {0.00001, 0.1}, "m",
           "coordinates in finer steps than this are rounded to it"),
      make("index.keep_strays", ILOT_FIELD(index.keep_strays), {}, "",
           "keep points that stand alone, hundreds of metres from all others, such as rays written as 0 0 0"),
      make("normals.neighbours", ILOT_FIELD(normals.neighbours), {3, 64}, "points",
           "nearest points that a normal is fitted to"),
      make("normals.max_radius", ILOT_FIELD(normals.max_radius), {0.001, 1000}, "m",
           "neighbours farther away than this are not used"),
      make("normals.write", ILOT_FIELD(normals.write), {}, "", "write NormalX, NormalY and NormalZ with the points"),
      with_choices(make("planes.method", ILOT_FIELD(planes.method), {}, "", "how planes are found"), kPlaneMethods),
      make("planes.epsilon", ILOT_FIELD(planes.epsilon), {0.0001, 10}, "m",
           "greatest distance of a labelled point from its plane"),
      make("planes.normal_angle", ILOT_FIELD(planes.normal_angle), {0.1, 90}, "deg",
           "greatest angle between a point's normal and that of its plane"),
      make("planes.min_points", ILOT_FIELD(planes.min_points), {3, 1e9}, "points", "fewest points of a plane"),
      make("planes.connectivity", ILOT_FIELD(planes.connectivity), {0.001, 100}, "m",
           "parts of a plane farther apart than this are two planes"),
      make("planes.join_angle", ILOT_FIELD(planes.join_angle), {0, 45}, "deg",
           "planes that meet at a cell border are joined up to this angle"),
      make("planes.probability", ILOT_FIELD(planes.probability), {0.5, 0.999999}, "",
           "that the best plane was among those tried"),
      with_choices(make("planes.cleaning", ILOT_FIELD(planes.cleaning), {}, "",
                        "which points take no part in the search for planes"),
                   kCleanings),
      with_choices(make("planes.epsilon_by", ILOT_FIELD(planes.epsilon_by), {}, "", "what epsilon is chosen by"),
                   kEpsilonBy),
      make("planes.colour_classes", ILOT_FIELD(planes.colour_classes), {0, 16}, "",
           "classes that colours are parted into where points have them"),
      make("planes.curved", ILOT_FIELD(planes.curved), {}, "",
           "spheres, cylinders and cones are looked for too; planes lie on the points that these leave"),
      make("planes.curved_points", ILOT_FIELD(planes.curved_points), {30, 1e9}, "points",
           "fewest points of a sphere, cylinder or cone"),
      make("boundaries.gamma", ILOT_FIELD(boundaries.gamma), {0.1, 100}, "",
           "threshold around a point over the sampling step there: gaps wider than twice that are openings"),
      make("boundaries.threshold", ILOT_FIELD(boundaries.threshold), {0.001, 1000}, "m",
           "one threshold for all points, whatever the sampling step"),
      with_choices(make("boundaries.step", ILOT_FIELD(boundaries.step), {}, "",
                        "sampling step as the stations' angular steps predict it, or as neighbours tell it"),
                   kStepSources),
      with_choices(make("boundaries.rule", ILOT_FIELD(boundaries.rule), {}, "",
                        "what of a triangle must not exceed the threshold"),
                   kBoundaryRules),
      with_choices(make("boundaries.edge_length", ILOT_FIELD(boundaries.edge_length), {}, "",
                        "longest_edge: edges as projected on the plane, or between the points themselves"),
                   kEdgeLengths),
      with_choices(make("boundaries.erosion", ILOT_FIELD(boundaries.erosion), {}, "",
                        "gaps open an outline everywhere, or only from the outside: then it has no holes"),
                   kErosions),
      make("boundaries.tolerance", ILOT_FIELD(boundaries.tolerance), {0, 10}, "m",
           "outlines lose the vertices that move them by less than this"),
      make(
          "boundaries.density_maps", ILOT_FIELD(boundaries.density_maps), {0, 1000}, "planes",
          "those with the most points, whose density is written as rasters beside what stations predict; auto: 4 where "
          "angular steps are known, else none"),
      make("roofs.trust_classes", ILOT_FIELD(roofs.trust_classes), {}, "",
           "false looks for ground and buildings by shape, as where no point is of classes.building"),
      make("roofs.cluster_distance", ILOT_FIELD(roofs.cluster_distance), {0.01, 100}, "m",
           "building points farther apart in plan are two buildings, without footprints"),
      make("roofs.cluster_points", ILOT_FIELD(roofs.cluster_points), {3, 1e9}, "points",
           "fewest points of a building, without footprints"),
      make("roofs.margin", ILOT_FIELD(roofs.margin), {0, 5}, "m",
           "points outside of all outlines but so near to one are its building's"),
      make("roofs.epsilon", ILOT_FIELD(roofs.epsilon), {0.001, 10}, "m",
           "greatest distance of a point from its roof face"),
      make("roofs.min_points", ILOT_FIELD(roofs.min_points), {3, 1e9}, "points", "fewest points of a roof face"),
      make("roofs.least_face_area", ILOT_FIELD(roofs.least_face_area), {0, 1e6}, "m2",
           "smaller roof faces go to their neighbour"),
      make("roofs.superstructures", ILOT_FIELD(roofs.superstructures), {}, "",
           "false leaves out what stands on the main roof: dormers, chimneys"),
      with_choices(make("roofs.attribute_style", ILOT_FIELD(roofs.attribute_style), {}, "",
                        "what attributes of buildings are called: docs/outputs.md"),
                   kAttributeStyles),
      with_choices(make("streets.view", ILOT_FIELD(streets.view), {}, "",
                        "where the street was scanned from: chooses the pixel and by what things are called"),
                   kStreetViews),
      make("streets.pixel", ILOT_FIELD(streets.pixel), {0.01, 10}, "m", "of the images from above"),
      make("streets.flat", ILOT_FIELD(streets.flat), {0.01, 100}, "m",
           "heights of neighbouring pixels of the ground differ by at most this"),
      make("streets.longest_gap", ILOT_FIELD(streets.longest_gap), {0, 10}, "m",
           "gaps between scan lines are closed up to this"),
      make("streets.longest_link", ILOT_FIELD(streets.longest_link), {0, 100}, "m",
           "shadows that cut the ground apart are crossed up to this"),
      make("streets.least_height", ILOT_FIELD(streets.least_height), {0.01, 10}, "m",
           "what is lower is part of the ground"),
      make("streets.least_area", ILOT_FIELD(streets.least_area), {0, 100}, "m2",
           "smaller things on the ground are dropped"),
      make("streets.rise", ILOT_FIELD(streets.rise), {0, 10}, "m",
           "what rises so far above the pass to a higher thing is a thing of its own"),
      make("facades.least_width", ILOT_FIELD(facades.least_width), {0.1, 1000}, "m", "narrower walls are no facades"),
      make("facades.least_height", ILOT_FIELD(facades.least_height), {0.1, 1000}, "m", "lower walls are no facades"),
      make("facades.bias", ILOT_FIELD(facades.bias), {0, 1}, "m", "walls whose planes differ by less are one facade"),
      make("facades.gap", ILOT_FIELD(facades.gap), {0, 100}, "m", "parts of a facade lie apart by at most this"),
      make("facades.relief", ILOT_FIELD(facades.relief), {0, 5}, "m",
           "what stands so far before a facade, along it, belongs to it"),
      make("facades.least_opening", ILOT_FIELD(facades.least_opening), {0.05, 10}, "m",
           "narrower or lower holes are no windows"),
      make("facades.alike", ILOT_FIELD(facades.alike), {0, 1}, "m",
           "sizes and lines that differ by less may have been meant equal"),
      make("facades.regularise", ILOT_FIELD(facades.regularise), {}, "",
           "rows, columns and families line up, each edge within its own error"),
      make("facades.scale", ILOT_FIELD(facades.scale), {1, 10000}, "", "drawings are 1 : scale on paper"),
      with_choices(make("facades.layers", ILOT_FIELD(facades.layers), {}, "",
                        "whose layers drawings have; ilot draw takes an office's own"),
                   kLayerNames),
      make("facades.sections", ILOT_FIELD(facades.sections), {-1e6, 1e6}, "CRS units",
           "heights that facades are also cut at"),
      make("facades.upright_sections", ILOT_FIELD(facades.upright_sections), {-1e4, 1e4}, "m",
           "distances from the left end of each facade that upright cuts go through it at"),
      make("facades.section_lines", ILOT_FIELD(facades.section_lines), {-1e9, 1e9}, "CRS units",
           "x0, y0, x1, y1 of each line that facades are also cut along, upright"),
      make("classes.ground", ILOT_FIELD(classes.ground), {0, 255}, "", "class codes of the ground"),
      make("classes.building", ILOT_FIELD(classes.building), {0, 255}, "", "class codes of buildings"),
      make("classes.noise", ILOT_FIELD(classes.noise), {0, 255}, "", "class codes of points that no product uses"),
  };
}

#undef ILOT_FIELD

std::string number_text(double number) {
  char buffer[32];
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : (number < 0 ? "-inf" : "inf");
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  std::string text(buffer, end);
  const bool whole = text.find_first_of(".e") == std::string::npos;
  return whole ? text + ".0" : text;
}

// Returns the end of a range as a text for people, without an exponent and without ".0".
std::string bound_text(double bound) {
  char buffer[400];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, bound, std::chars_format::fixed).ptr};
}

bool fits_kind(const Parameter& p, const Value& value) {
  switch (p.kind) {
    case ParameterKind::boolean:
      return std::holds_alternative<bool>(value);
    case ParameterKind::integer:
      return std::holds_alternative<std::int64_t>(value);
    case ParameterKind::number:
      return std::holds_alternative<double>(value) || std::holds_alternative<std::int64_t>(value);
    case ParameterKind::integers:
      return std::holds_alternative<std::vector<std::int64_t>>(value);
    case ParameterKind::numbers:
      return std::holds_alternative<std::vector<double>>(value) ||
             std::holds_alternative<std::vector<std::int64_t>>(value);
    case ParameterKind::choice:
      return std::holds_alternative<std::string>(value) &&
             std::find(p.choices.begin(), p.choices.end(), std::get<std::string>(value)) != p.choices.end();
  }
  return false;
}

bool in_range(const ValueRange& range, const Value& value) {
  const auto inside = [&](double v) { return v >= range.min && v <= range.max; };
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return inside(static_cast<double>(*whole));
  if (const auto* number = std::get_if<double>(&value)) return inside(*number);
  if (const auto* list = std::get_if<std::vector<std::int64_t>>(&value)) {
    return std::all_of(list->begin(), list->end(), [&](std::int64_t v) { return inside(static_cast<double>(v)); });
  }
  if (const auto* list = std::get_if<std::vector<double>>(&value))
    return std::all_of(list->begin(), list->end(), inside);
  return true;
}

// Returns the optimal string alignment distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = above[j - 1] + (a[i - 1] != b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

}  // namespace

const std::vector<Parameter>& parameters() {
  static const std::vector<Parameter> table = make_table();
  return table;
}

const Parameter* find_parameter(std::string_view key) {
  for (const Parameter& p : parameters()) {
    if (p.key == key) return &p;
  }
  return nullptr;
}

const Parameter& nearest_parameter(std::string_view key) {
  const std::string_view head = key.substr(0, 200);
  const Parameter* best = nullptr;
  std::size_t best_distance = 0;
  for (const Parameter& p : parameters()) {
    const std::size_t distance = edit_distance(head, p.key);
    if (best == nullptr || distance < best_distance) best = &p, best_distance = distance;
  }
  return *best;
}

std::optional<std::string> check_value(const Parameter& p, const Value& value) {
  if (std::holds_alternative<Auto>(value)) {
    if (p.optional) return std::nullopt;
    return p.key + " cannot be \"auto\": it must be " + expected_text(p);
  }
  if (!fits_kind(p, value)) return p.key + " must be " + expected_text(p) + ", not " + to_text(value);
  if (p.kind != ParameterKind::boolean && !in_range(p.range, value)) {
    return p.key + " = " + to_text(value) + " is out of range: " + range_text(p);
  }
  return std::nullopt;
}

std::string expected_text(const Parameter& p) {
  const char* names[] = {"true or false",           "a whole number",    "a number",
                         "a list of whole numbers", "a list of numbers", "one of "};
  std::string text = names[static_cast<int>(p.kind)];
  if (p.kind == ParameterKind::choice) text += range_text(p);
  if (!p.unit.empty()) text += " (" + p.unit + ")";
  return p.optional ? text + " or \"auto\"" : text;
}

std::string to_text(const Value& value) {
  if (std::holds_alternative<Auto>(value)) return "\"auto\"";
  if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const auto* number = std::get_if<double>(&value)) return number_text(*number);
  if (const auto* name = std::get_if<std::string>(&value)) return '"' + *name + '"';
  std::string text;
  const auto add = [&](const std::string& entry) { text += (text.empty() ? "" : ", ") + entry; };
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    for (const double entry : *numbers) add(number_text(entry));
  } else {
    for (const std::int64_t entry : std::get<std::vector<std::int64_t>>(value)) add(std::to_string(entry));
  }
  return "[" + text + "]";
}

std::string range_text(const Parameter& p) {
  if (p.kind == ParameterKind::boolean) return "";
  if (p.kind == ParameterKind::choice) {
    std::string names;
    for (const std::string_view name : p.choices) names += (names.empty() ? "" : ", ") + std::string(name);
    return names;
  }
  const std::string unit = p.unit.empty() ? "" : " " + p.unit;
  return bound_text(p.range.min) + " to " + bound_text(p.range.max) + unit;
}

}  // namespace ilot
