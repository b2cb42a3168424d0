// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/text.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/error.h"
#include "engine/formats/lines.h"
#include "engine/formats/table.h"

namespace ilot {
namespace {

constexpr std::size_t kMostFields = 1001;
constexpr int kMostHeaderLines = 200;

// What stands before the points.
struct Preamble {
  std::vector<Column> columns;  // empty: not named
  std::uint64_t declared = 0;   // 0: no line with the count
  std::uint64_t offset = 0, first_line = 1;
  std::vector<double> first;  // values of the first line of points, empty when there are none
};

std::string_view without_comment_mark(std::string_view line) {
  const std::size_t begin = line.find_first_not_of("#/ \t");
  return begin == std::string_view::npos ? std::string_view{} : line.substr(begin);
}

std::vector<Column> named_columns(const std::vector<std::string_view>& fields) {
  std::vector<Column> columns;
  for (const std::string_view field : fields) columns.push_back({std::string(field), FieldType::f64});
  return columns;
}

bool all_numbers(const std::vector<std::string_view>& fields, std::vector<double>& values) {
  values.assign(fields.size(), 0);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!parse_number(fields[i], values[i])) return false;
  return !fields.empty();
}

// Takes lines until one begins the points: comments, names of columns and one count are understood before it.
Preamble read_preamble(const InputFile& file) {
  constexpr std::uint64_t kByteOrderMark = 3;
  std::byte mark[kByteOrderMark]{};
  file.read_at(0, mark);
  const bool marked = mark[0] == std::byte{0xEF} && mark[1] == std::byte{0xBB} && mark[2] == std::byte{0xBF};
  LineReader lines(file, marked ? kByteOrderMark : 0);
  Preamble preamble;
  std::vector<std::string_view> fields;
  std::string_view line;
  for (int i = 0; i < kMostHeaderLines; ++i) {
    preamble.offset = lines.offset();
    preamble.first_line = static_cast<std::uint64_t>(i) + 1;
    if (!lines.next(line)) return preamble;
    const std::string_view text = without_comment_mark(line);
    split_fields(text, kMostFields, fields);
    if (fields.empty()) continue;
    const bool numbers = all_numbers(fields, preamble.first);
    if (numbers && fields.size() == 1 && preamble.declared == 0) {
      preamble.declared =
          preamble.first[0] >= 1 && preamble.first[0] < 1e15 ? static_cast<std::uint64_t>(preamble.first[0]) : 0;
      continue;
    }
    if (numbers && text.data() == line.data() + line.find_first_not_of(" \t")) return preamble;
    if (numbers) continue;
    std::vector<Column> columns = named_columns(fields);
    if (has_coordinates(columns))
      preamble.columns = std::move(columns);
    else if (text.size() == line.size())
      break;
  }
  throw Error(file.path().string() + ": line " + std::to_string(preamble.first_line) +
              " is neither three numbers nor names of columns with x, y and z; is this a point cloud?");
}

std::vector<Column> guessed_columns(const std::vector<double>& first) {
  const bool normals = first.size() >= 6 &&
                       std::all_of(first.begin() + 3, first.begin() + 6, [](double v) { return std::abs(v) <= 1; }) &&
                       std::any_of(first.begin() + 3, first.begin() + 6, [](double v) { return v != std::round(v); });
  std::vector<std::string> names{"x", "y", "z"};
  if (first.size() == 4) names.insert(names.end(), {"intensity"});
  if (first.size() == 6 && normals) names.insert(names.end(), {"nx", "ny", "nz"});
  if (first.size() == 6 && !normals) names.insert(names.end(), {"red", "green", "blue"});
  if (first.size() == 7) names.insert(names.end(), {"intensity", "red", "green", "blue"});
  while (names.size() < first.size()) names.push_back("column" + std::to_string(names.size() + 1));
  std::vector<Column> columns;
  for (const std::string& name : names) columns.push_back({name, FieldType::f64});
  return columns;
}

bool is_pts(const std::filesystem::path& path) {
  return path.extension() == ".pts" || path.extension() == ".PTS";
}

}  // namespace

std::unique_ptr<PointReader> open_text(std::unique_ptr<InputFile> file) {
  if (file->size() == 0) throw Error(file->path().string() + ": is empty; deliver it again");
  Preamble preamble = read_preamble(*file);
  const bool named = !preamble.columns.empty();
  if (!named && preamble.first.size() < 3)
    throw Error(file->path().string() + ": line " + std::to_string(preamble.first_line) +
                " has fewer than three numbers; is this a point cloud?");
  TextBody body;
  body.offset = preamble.offset;
  body.first_line = preamble.first_line;
  body.counts_between = is_pts(file->path()) && preamble.declared > 0;
  if (!named) preamble.columns = guessed_columns(preamble.first);
  if (!named && is_pts(file->path()) && (preamble.columns.size() == 4 || preamble.columns.size() == 7))
    body.convert = [](std::span<double> values) { values[3] = (values[3] + 2048) * 16; };
  CloudInfo info;
  info.path = file->path();
  info.format = "text";
  info.declared_points = preamble.declared;
  return open_text_table(std::move(file), std::move(info), std::move(preamble.columns), std::move(body));
}

}  // namespace ilot
