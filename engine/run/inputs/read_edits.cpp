// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_edits.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "engine/error.h"
#include "engine/formats/tables/lines.h"
#include "engine/model/point_label.h"
#include "engine/run/inputs/edit_rules.h"
#include "engine/run/inputs/read_area.h"

namespace ilot {
namespace {

// Choice: coordinates of the earth are below 1e8 in feet.
constexpr double kFarthest = 1e9;  // units of the CRS
constexpr std::uintmax_t kMostEditBytes = 64u << 20;

[[noreturn]] void refuse_edit(const std::string& where, const std::string& what) {
  throw Error(where + ": " + what, ExitCode::usage);
}

// A polygon in a table of QGIS has the column WKT.
std::size_t column_of(std::string_view name) {
  if (name == "WKT") name = "area";
  return static_cast<std::size_t>(std::find(kEditColumns.begin(), kEditColumns.end(), name) - kEditColumns.begin());
}

std::string trimmed_field(std::string text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.back())) text.pop_back();
  text.erase(text.begin(), std::find_if_not(text.begin(), text.end(), blank));
  return text;
}

// Splits a line at its separators outside of quotes. Two quotes within quotes are one.
std::vector<std::string> fields_of(std::string_view line, char separator, const std::string& where) {
  std::vector<std::string> fields{""};
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (quoted && i + 1 < line.size() && line[i + 1] == '"')
        fields.back() += line[i++];
      else
        quoted = !quoted;
    } else if (line[i] == separator && !quoted) {
      fields.emplace_back();
    } else {
      fields.back() += line[i];
    }
  }
  if (quoted) refuse_edit(where, "a quote is not closed on its line");
  for (std::string& field : fields) field = trimmed_field(std::move(field));
  return fields;
}

char separator_of(std::string_view header) {
  for (const char c : {'\t', ';'})
    if (header.find(c) != std::string_view::npos) return c;
  return ',';
}

// One line of a table by the names of its columns.
class EditRow {
 public:
  EditRow(const std::vector<std::size_t>& columns, const std::vector<std::string>& fields, char separator,
          std::string where)
      : decimal_comma_(separator != ','), where_(std::move(where)) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i >= columns.size() && !fields[i].empty())
        refuse_edit(where_, "has more fields than the first line has columns");
      if (i < columns.size()) values_.at(columns[i]) = fields[i];
    }
  }

  const std::string& where() const { return where_; }
  const std::string& text(const char* column) const { return values_.at(column_of(column)); }

  std::optional<double> number(const std::string& column) const {
    std::string given = text(column.c_str());
    if (given.empty()) return std::nullopt;
    if (decimal_comma_) std::replace(given.begin(), given.end(), ',', '.');
    double value = 0;
    if (!parse_number(given, value) || !std::isfinite(value))
      refuse_edit(where_, column + ": \"" + text(column.c_str()) + "\" is not a number");
    if (std::abs(value) > kFarthest)
      refuse_edit(where_, column + ": \"" + text(column.c_str()) + "\" is farther away than any place on earth");
    return value;
  }

  // The places x1 y1 z1 and x2 y2 z2 behind the prefix; heights may be missing where they are not needed.
  std::vector<Vec3> places(const std::string& prefix, bool heights) const {
    std::vector<Vec3> places;
    for (const char* n : {"1", "2"}) {
      const auto x = number(prefix + "x" + n), y = number(prefix + "y" + n), z = number(prefix + "z" + n);
      if (!x && !y) continue;
      if (!x || !y || (heights && !z))
        refuse_edit(where_, "a place needs " + prefix + "x" + n + ", " + prefix + "y" + n +
                                (heights ? " and " + prefix + "z" + n : ""));
      if (places.empty() && *n == '2') refuse_edit(where_, prefix + "x2 is given without " + prefix + "x1");
      places.push_back({*x, *y, z.value_or(0)});
    }
    return places;
  }

 private:
  std::array<std::string, kEditColumns.size()> values_;
  bool decimal_comma_ = false;
  std::string where_;
};

std::vector<std::size_t> columns_of(const std::vector<std::string>& header, const std::string& where) {
  std::vector<std::size_t> columns;
  for (const std::string& name : header) {
    const std::size_t column = column_of(name);
    if (column == kEditColumns.size())
      refuse_edit(
          where, "\"" + name + "\" is no column of a table of edits; the first line names product, edit, kind, x1 ...");
    if (std::count(columns.begin(), columns.end(), column) > 0)
      refuse_edit(where, "the column \"" + name + "\" comes twice");
    columns.push_back(column);
  }
  for (const char* needed : {"product", "edit"})
    if (std::count(columns.begin(), columns.end(), column_of(needed)) == 0)
      refuse_edit(where,
                  std::string("the column ") + needed + " is needed; the first line names product, edit, kind, x1 ...");
  return columns;
}

Edit edit_of(const EditRow& row) {
  Edit edit;
  edit.where = row.where();
  edit.product = row.text("product");
  const auto action = std::find(kEditActionNames.begin(), kEditActionNames.end(), row.text("edit"));
  const EditRule* rule = action == kEditActionNames.end()
                             ? nullptr
                             : edit_rule(edit.product, static_cast<EditAction>(action - kEditActionNames.begin()));
  if (rule == nullptr)
    refuse_edit(row.where(),
                "\"" + edit.product + "\" has no edit \"" + row.text("edit") + "\"; there are: " + edit_rules_text());
  edit.action = rule->action;
  edit.kind = row.text("kind");
  edit.to_kind = row.text("to_kind");
  edit.note = row.text("note");
  edit.at = row.places("", rule->heights);
  edit.to = row.places("to_", rule->heights);
  if (!row.text("area").empty()) edit.area = parse_area(row.text("area"), row.where() + ": area");
  if (rule->area) {
    edit.low = row.number("z1");
    edit.high = row.number("z2");
  }
  if (const std::string fault = edit_fault(edit, *rule); !fault.empty()) refuse_edit(row.where(), fault);
  return edit;
}

}  // namespace

std::vector<Edit> parse_edits(std::string_view text, const std::string& name) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (text.find('\0') != std::string_view::npos) refuse_edit(name, "is no text; a table of edits is CSV");
  std::vector<Edit> edits;
  std::vector<std::size_t> columns;
  char separator = ',';
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::string where = name + ":" + std::to_string(number);
    if (line.starts_with('#')) continue;
    if (columns.empty()) separator = separator_of(line);
    const std::vector<std::string> fields = fields_of(line, separator, where);
    if (std::all_of(fields.begin(), fields.end(), [](const std::string& f) { return f.empty(); })) continue;
    if (columns.empty())
      columns = columns_of(fields, where);
    else
      edits.push_back(edit_of(EditRow(columns, fields, separator, where)));
  }
  if (columns.empty()) refuse_edit(name, "is empty; the first line of a table of edits names its columns");
  return edits;
}

std::vector<Edit> read_edits(const std::filesystem::path& path) {
  std::error_code fault;
  const std::uintmax_t size = std::filesystem::file_size(path, fault);
  if (fault) refuse_edit(path.string(), "cannot read the edits: " + fault.message());
  if (size > kMostEditBytes) refuse_edit(path.string(), "larger than 64 MiB: this is no table of edits");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) refuse_edit(path.string(), "cannot read the edits");
  return parse_edits(text, path.string());
}

std::vector<Edit> read_edits(std::span<const std::filesystem::path> paths) {
  std::vector<Edit> all;
  for (const std::filesystem::path& path : paths) {
    std::vector<Edit> edits = read_edits(path);
    std::move(edits.begin(), edits.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace ilot
