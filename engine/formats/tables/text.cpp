// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/text.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/formats/tables/lines.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::size_t kMostFields = 1001;
constexpr int kMostPreambleLines = 200;
constexpr std::size_t kBeginning = 1000;  // rows from which the dialect is found

// The content before the points.
struct Preamble {
  std::vector<TableColumn> columns;  // empty: the columns have no names
  std::uint64_t declared = 0;        // 0: no line with the count
  std::uint64_t offset = 0, first_line = 1;
  bool ended = false;  // there are no points
};

std::string_view without_comment_mark(std::string_view line) {
  const std::size_t begin = line.find_first_not_of("#/ \t");
  return begin == std::string_view::npos ? std::string_view{} : line.substr(begin);
}

std::vector<TableColumn> named_columns(const std::vector<std::string_view>& fields) {
  std::vector<TableColumn> columns;
  for (const std::string_view field : fields) columns.push_back({std::string(field), FieldType::f64});
  return columns;
}

// A line with one number is a count: of the points, or 0 when it cannot be a count.
std::optional<std::uint64_t> count_of(const std::vector<std::string_view>& fields) {
  double value = 0;
  if (fields.size() != 1 || !parse_number(fields[0], value)) return std::nullopt;
  return value >= 1 && value < 1e15 ? static_cast<std::uint64_t>(value) : 0;
}

// Reads lines until the points begin. Comments, names of columns and one count may come before.
Preamble read_preamble(const InputFile& file) {
  constexpr std::uint64_t kByteOrderMark = 3;
  std::byte mark[kByteOrderMark]{};
  file.read_at(0, mark);
  const bool marked = mark[0] == std::byte{0xEF} && mark[1] == std::byte{0xBB} && mark[2] == std::byte{0xBF};
  LineReader lines(file, marked ? kByteOrderMark : 0);
  Preamble preamble;
  std::vector<std::string_view> fields;
  std::string_view line;
  for (int i = 0; i < kMostPreambleLines; ++i) {
    preamble.offset = lines.offset();
    preamble.first_line = static_cast<std::uint64_t>(i) + 1;
    preamble.ended = !lines.next(line);
    if (preamble.ended) return preamble;
    const std::string_view text = without_comment_mark(line);
    split_fields(text, kMostFields, fields);
    if (fields.empty()) continue;
    if (const auto count = count_of(fields); count && preamble.declared == 0) {
      preamble.declared = *count;
      continue;
    }
    const bool numbers = looks_like_numbers(text);
    if (numbers && text.data() == line.data() + line.find_first_not_of(" \t")) return preamble;
    if (numbers) continue;
    std::vector<TableColumn> columns = named_columns(fields);
    if (has_coordinates(columns))
      preamble.columns = std::move(columns);
    else if (text.size() == line.size())
      break;
  }
  throw Error(file.path().string() + ": line " + std::to_string(preamble.first_line) +
              " is neither three numbers nor names of columns with x, y and z; is this a point cloud?");
}

std::vector<std::string> beginning(const InputFile& file, const Preamble& preamble) {
  LineReader lines(file, preamble.offset);
  std::vector<std::string> rows;
  for (std::string_view line; rows.size() < kBeginning && lines.next(line);)
    if (line.find_first_not_of(" \t") != std::string_view::npos) rows.emplace_back(line);
  return rows;
}

// Returns the requested dialect with the number of columns that most rows have, or else the dialect that is found.
FoundDialect dialect_of(std::span<const std::string> rows, const Preamble& preamble, const OpenOptions& options,
                        const std::string& place) {
  if (!options.dialect) return find_dialect(rows, preamble.columns.size(), {}, place);
  return {*options.dialect, columns_of_most(rows, *options.dialect)};
}

// Returns the values of the first correct row.
std::vector<double> first_values(std::span<const std::string> rows, const FoundDialect& found) {
  std::vector<double> values(found.columns);
  std::vector<std::string_view> fields;
  for (const std::string& row : rows)
    if (parse_row(row, found.dialect, fields, values)) break;
  return values;
}

// When a header names fewer columns than there are, the others have no name.
std::vector<TableColumn> completed(std::vector<TableColumn> columns, std::size_t count, const std::string& path) {
  if (columns.size() > count)
    throw Error(path + ": its header names " + std::to_string(columns.size()) + " columns, but its rows have " +
                std::to_string(count) + " numbers; mend the header or remove it");
  while (columns.size() < count) columns.push_back({"column" + std::to_string(columns.size() + 1), FieldType::f64});
  return columns;
}

std::vector<TableColumn> guessed_columns(const std::vector<double>& first) {
  const bool normals = first.size() >= 6 &&
                       std::all_of(first.begin() + 3, first.begin() + 6, [](double v) { return std::abs(v) <= 1; }) &&
                       std::any_of(first.begin() + 3, first.begin() + 6, [](double v) { return v != std::round(v); });
  std::vector<std::string> names{"x", "y", "z"};
  if (first.size() == 4) names.insert(names.end(), {"intensity"});
  if (first.size() == 6 && normals) names.insert(names.end(), {"nx", "ny", "nz"});
  if (first.size() == 6 && !normals) names.insert(names.end(), {"red", "green", "blue"});
  if (first.size() == 7) names.insert(names.end(), {"intensity", "red", "green", "blue"});
  while (names.size() < first.size()) names.push_back("column" + std::to_string(names.size() + 1));
  std::vector<TableColumn> columns;
  for (const std::string& name : names) columns.push_back({name, FieldType::f64});
  return columns;
}

bool is_pts(const std::filesystem::path& path) {
  return path.extension() == ".pts" || path.extension() == ".PTS";
}

}  // namespace

std::unique_ptr<PointReader> open_text(std::unique_ptr<InputFile> file, const OpenOptions& options) {
  const std::string path = file->path().string();
  if (file->size() == 0) throw Error(path + ": is empty; fetch or export it again");
  Preamble preamble = read_preamble(*file);
  const std::string place = path + ": line " + std::to_string(preamble.first_line);
  const std::vector<std::string> rows = beginning(*file, preamble);
  FoundDialect found = dialect_of(rows, preamble, options, place);
  const bool named = !preamble.columns.empty();
  if (found.columns == 0 && !(named && rows.empty()))
    throw Error(place +
                (options.dialect ? " is not three numbers " + description_of(*options.dialect)
                                 : " has fewer than three numbers") +
                "; is this a point cloud?");
  if (found.columns == 0) found.columns = preamble.columns.size();
  TextBody body;
  body.offset = preamble.offset;
  body.first_line = preamble.first_line;
  body.counts_between = is_pts(file->path()) && preamble.declared > 0;
  body.dialect = found.dialect;
  body.degrees = options.degrees;
  preamble.columns =
      named ? completed(std::move(preamble.columns), found.columns, path) : guessed_columns(first_values(rows, found));
  if (!named && is_pts(file->path()) && (preamble.columns.size() == 4 || preamble.columns.size() == 7))
    body.convert = [](std::span<double> values) { values[3] = (values[3] + 2048) * 16; };
  CloudInfo info;
  info.path = file->path();
  info.format = "text";
  info.dialect = description_of(found.dialect) + (named ? ", header line" : "");
  info.declared_points = preamble.declared;
  return open_text_table(std::move(file), std::move(info), std::move(preamble.columns), std::move(body));
}

}  // namespace ilot
