// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr double kSamePlace = 1e-5;  // units of the drawing
constexpr std::size_t kMostLayers = 20;

std::string called(const DxfEntity& e) {
  return e.type + (e.handle.empty() ? "" : " " + e.handle) + " in line " + std::to_string(e.line);
}

// Counts the entities that break a rule and remembers the first.
class Count {
 public:
  void add(const DxfEntity& e) {
    if (count_++ == 0) first_ = called(e);
  }
  void report(const char* rule, const std::string& what, std::vector<Finding>& findings) const {
    if (count_ > 0) findings.push_back({rule, std::to_string(count_) + " " + what + ", the first is " + first_, true});
  }

 private:
  std::uint64_t count_ = 0;
  std::string first_;
};

bool same_place(const DrawingCorner& a, const DrawingCorner& b) {
  return std::abs(a.x - b.x) <= kSamePlace && std::abs(a.y - b.y) <= kSamePlace;
}

bool is_chain(const DxfEntity& e) {
  return e.type == "LINE" || e.type == "LWPOLYLINE" || e.type == "POLYLINE";
}

bool is_round(const DxfEntity& e) {
  return e.type == "ARC" || e.type == "CIRCLE";
}

// Returns true where a corner is at the same place as the one before it.
bool has_zero_length(const DxfEntity& e) {
  if (is_round(e)) return e.radius <= kSamePlace;
  for (std::size_t i = 0; i + 1 < e.corners.size(); ++i)
    if (same_place(e.corners[i], e.corners[i + 1])) return true;
  return e.closed && e.corners.size() > 2 && same_place(e.corners.front(), e.corners.back());
}

void check_structure(const DxfDrawing& drawing, std::vector<Finding>& findings) {
  for (const char* name : {"HEADER", "TABLES", "ENTITIES"})
    if (!drawing.sections.contains(name)) findings.push_back({"structure", std::string("no section ") + name, true});
  if (!drawing.has_end) findings.push_back({"structure", "no end of file (EOF)", true});
}

void check_units(const DxfDrawing& drawing, std::vector<Finding>& findings) {
  constexpr std::int64_t kMetres = 6;
  constexpr std::array<const char*, 7> kUnits{"nothing",     "inches",      "feet",  "miles",
                                              "millimetres", "centimetres", "metres"};
  if (!drawing.units || *drawing.units <= 0)
    findings.push_back({"units", "nothing says what a unit is ($INSUNITS)", true});
  else if (*drawing.units != kMetres)
    findings.push_back(
        {"units",
         "a unit is not a metre: $INSUNITS is " + std::to_string(*drawing.units) +
             (*drawing.units < kMetres ? std::string(", ") + kUnits[static_cast<std::size_t>(*drawing.units)] : ""),
         false});
}

std::string upper(std::string name) {
  for (char& c : name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return name;
}

void check_layers(const DxfDrawing& drawing, std::vector<Finding>& findings) {
  std::set<std::string> declared{"0"};
  for (const std::string& name : drawing.layers) declared.insert(upper(name));
  std::map<std::string, Count> unknown;
  for (const DxfEntity& e : drawing.entities)
    if (!declared.contains(upper(e.layer))) unknown[e.layer].add(e);
  std::size_t named = 0;
  for (const auto& [name, count] : unknown)
    if (named++ < kMostLayers)
      count.report("layer", "on the layer '" + clean_text(name) + "' that is not declared", findings);
}

// A key that is equal for duplicates and for nothing else.
using Key = std::pair<std::string, std::vector<std::int64_t>>;

Key key_of(const DxfEntity& e) {
  std::vector<std::int64_t> list = place_key(e.corners, e.closed);
  for (const double v : {e.radius, e.from_deg, e.to_deg}) list.push_back(place_key({{v, 0, 0}}, false)[0]);
  list.push_back(e.closed);
  return {e.type + "\n" + upper(e.layer) + "\n" + e.text, std::move(list)};
}

}  // namespace

std::vector<Finding> validate_drawing(const DxfDrawing& drawing) {
  std::vector<Finding> findings;
  check_structure(drawing, findings);
  check_units(drawing, findings);
  check_layers(drawing, findings);
  Count handles, numbers, empty, zero, open, twice;
  std::set<std::string> known;
  std::set<Key> keys;
  for (const DxfEntity& e : drawing.entities) {
    if (!e.handle.empty() && !known.insert(upper(e.handle)).second) handles.add(e);
    if (!e.finite) numbers.add(e);
    if (is_chain(e) && e.corners.size() < 2) empty.add(e);
    if ((is_chain(e) || is_round(e)) && has_zero_length(e)) zero.add(e);
    if (is_chain(e) && !e.closed && e.corners.size() > 3 && same_place(e.corners.front(), e.corners.back()))
      open.add(e);
    if (!e.corners.empty() && !keys.insert(key_of(e)).second) twice.add(e);
  }
  handles.report("handle", "with a handle that another one has", findings);
  numbers.report("number", "with a number that is none", findings);
  empty.report("empty", "of fewer than two corners", findings);
  zero.report("zero-length", "with a stretch of no length", findings);
  open.report("open-ring", "end where they begin and are not closed", findings);
  twice.report("duplicate", "lie on another one of their layer", findings);
  return findings;
}

std::vector<Finding> validate_drawing_file(const std::filesystem::path& path) {
  try {
    return validate_drawing(read_dxf(path));
  } catch (const Error& fault) {
    return {{"unreadable", fault.what(), true}};
  }
}

}  // namespace ilot
