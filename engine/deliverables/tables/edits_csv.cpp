// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/edits_csv.h"

#include <algorithm>
#include <vector>

#include "engine/deliverables/drawings/drawing.h"

namespace ilot {
namespace {

// Derived: z1 and z2 among kEditColumns.
constexpr std::size_t kLowColumn = 5, kHighColumn = 8;

std::string quoted_field(const std::string& given) {
  const std::string text = clean_text(given);
  if (text.find_first_of(",;\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

void add_places(const std::vector<Vec3>& places, std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < 2; ++i)
    for (const double Vec3::*axis : {&Vec3::x, &Vec3::y, &Vec3::z})
      fields.push_back(i < places.size() ? decimal(places[i].*axis, 4) : "");
}

std::string area_text(const Area& area) {
  std::string text;
  for (const AreaRing& ring : area.rings) {
    std::string corners;
    for (std::size_t i = 0; i <= ring.size(); ++i)
      corners +=
          (i > 0 ? ", " : "") + decimal(ring[i % ring.size()][0], 4) + " " + decimal(ring[i % ring.size()][1], 4);
    text += (text.empty() ? "((" : ", ((") + corners + "))";
  }
  return text.empty() ? "" : "MULTIPOLYGON (" + text + ")";
}

}  // namespace

std::string edits_csv(std::span<const Edit> edits) {
  std::string table;
  for (const char* column : kEditColumns) table += (table.empty() ? "" : ",") + std::string(column);
  table += "\n";
  for (const Edit& edit : edits) {
    std::vector<std::string> fields{edit.product, kEditActionNames.at(static_cast<std::size_t>(edit.action)),
                                    edit.kind};
    add_places(edit.at, fields);
    if (edit.low) fields[kLowColumn] = decimal(*edit.low, 4);
    if (edit.high) fields[kHighColumn] = decimal(*edit.high, 4);
    fields.push_back(edit.to_kind);
    add_places(edit.to, fields);
    fields.push_back(area_text(edit.area));
    fields.push_back(edit.note);
    for (std::size_t i = 0; i < fields.size(); ++i) table += (i > 0 ? "," : "") + quoted_field(fields[i]);
    table += "\n";
  }
  return table;
}

}  // namespace ilot
