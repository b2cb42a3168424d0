// SPDX-License-Identifier: Apache-2.0
// The search for the dialect of a text: text_dialect.h.
#include <algorithm>
#include <charconv>

#include "engine/error.h"
#include "engine/formats/tables/text_dialect.h"

namespace ilot {
namespace {

// True when a number of the row has two points: they group thousands.
bool has_two_points(std::string_view row) {
  for (std::size_t at = row.find('.'); at != std::string_view::npos; at = row.find('.', at + 1)) {
    const std::size_t end = row.find_first_not_of("0123456789", at + 1);
    if (end != std::string_view::npos && row[end] == '.') return true;
  }
  return false;
}

// Returns all dialects that the characters of the rows allow, the simplest first.
std::vector<TextDialect> candidates(std::span<const std::string> rows) {
  bool comma = false, semicolon = false, tab = false, apostrophe = false, blank = false, quote = false, points = false;
  for (const std::string& row : rows) {
    const auto has = [&](const char* sign) { return row.find(sign) != std::string::npos; };
    comma |= has(",");
    semicolon |= has(";");
    tab |= has("\t");
    apostrophe |= has("'");
    quote |= has("\"");
    blank |= has(" ") || has("\xA0") || has("\xE2\x80\xAF");
    points |= has_two_points(row);
  }
  std::vector<TextDialect> list;
  for (const char decimal : {'.', ','})
    for (const char thousands : {'\0', ',', '.', '\'', ' '})
      for (const Separator separator : {Separator::tab, Separator::blank, Separator::semicolon, Separator::comma}) {
        if ((separator == Separator::tab && !tab) || (separator == Separator::semicolon && !semicolon)) continue;
        if (separator == Separator::comma && !comma) continue;
        if (thousands == decimal || (decimal == ',' && !comma && !points)) continue;
        if ((thousands == ',' && !comma) || (thousands == '\'' && !apostrophe) || (thousands == ' ' && !blank))
          continue;
        if (thousands == ',' && separator == Separator::comma && !quote) continue;
        if (decimal == ',' && !comma && thousands != '.') continue;
        list.push_back({separator, decimal, thousands});
      }
  return list;
}

// The rows as one dialect reads them.
struct Reading {
  TextDialect dialect;
  std::vector<std::vector<double>> rows;  // empty when the row is not numbers
  std::size_t columns = 0;                // of most rows
  std::size_t fitting = 0;                // rows with this number of columns
};

// A row whose only points could be decimal points does not show that points group thousands.
bool shows_thousands(std::string_view row, const TextDialect& dialect) {
  return dialect.thousands != '.' || row.find('.') == std::string_view::npos ||
         row.find(',') != std::string_view::npos || has_two_points(row);
}

void read_rows(std::span<const std::string> rows, std::span<const std::size_t> counts, Reading& reading) {
  std::vector<std::string_view> fields;
  std::vector<std::size_t> with(kMostShownColumns + 1);
  for (const std::string& row : rows) {
    split_row(row, reading.dialect, kMostShownColumns, fields);
    std::vector<double>& values = reading.rows.emplace_back(fields.size());
    for (std::size_t i = 0; i < fields.size() && !values.empty(); ++i)
      if (!parse_number(fields[i], reading.dialect, values[i])) values.clear();
    if (!counts.empty() && std::find(counts.begin(), counts.end(), values.size()) == counts.end()) values.clear();
    if (values.size() < 3 || !shows_thousands(row, reading.dialect)) values.clear();
    ++with[values.size()];
  }
  reading.columns = static_cast<std::size_t>(std::max_element(with.begin() + 3, with.end()) - with.begin());
  reading.fitting = with[reading.columns];
  if (!counts.empty()) reading.fitting = rows.size() - with[0];
  if (reading.fitting == 0) reading.columns = 0;
  if (counts.empty())
    for (std::vector<double>& values : reading.rows)
      if (values.size() != reading.columns) values.clear();
}

bool is_same(double a, double b) {
  return a == b || (a != a && b != b);
}

// Returns the first row that both readings understand differently; rows.size() when there is none.
std::size_t first_difference(const Reading& a, const Reading& b) {
  for (std::size_t i = 0; i < a.rows.size(); ++i)
    if (!a.rows[i].empty() && !b.rows[i].empty() && !std::ranges::equal(a.rows[i], b.rows[i], is_same)) return i;
  return a.rows.size();
}

// Only faulty programs write commas both as separators and as decimal commas, while whole numbers between commas are
// common. One in ten decimals has a leading zero. When none of a hundred has one, they are not decimals.
bool are_decimals(std::span<const std::string> rows) {
  constexpr std::size_t kEnough = 100;
  std::vector<std::string_view> fields;
  std::size_t seen = 0;
  for (const std::string& row : rows) {
    if (row.find('"') != std::string::npos) return true;  // quotes show that commas are decimal commas
    split_row(row, {Separator::comma, '.', 0}, kMostShownColumns, fields);
    for (std::size_t i = 1; i < fields.size(); i += 2) {
      if (fields[i].size() < 2) continue;
      if (fields[i].front() == '0') return true;
      ++seen;
    }
  }
  return seen < kEnough;
}

std::string numbers_text(const std::vector<double>& values) {
  constexpr std::size_t kShown = 6;
  std::string text;
  for (std::size_t i = 0; i < std::min(values.size(), kShown); ++i) {
    char number[32];
    const auto end = std::to_chars(number, number + sizeof number, values[i]).ptr;
    text += (i > 0 ? " | " : "") + std::string(number, end);
  }
  return values.size() > kShown ? text + " | ..." : text;
}

[[noreturn]] void refuse_two_readings(const Reading& a, const Reading& b, std::size_t row, const std::string& text,
                                      const std::string& place) {
  constexpr std::size_t kShown = 80;
  throw Error(place + ": \"" + text.substr(0, kShown) + "\" can be read in two ways: " + numbers_text(a.rows[row]) +
                  " (" + description_of(a.dialect) + ") or " + numbers_text(b.rows[row]) + " (" +
                  description_of(b.dialect) + "); choose with --text-dialect " + words_of(a.dialect) +
                  " or --text-dialect " + words_of(b.dialect),
              ExitCode::usage);
}

[[noreturn]] void refuse_mixture(const Reading& a, const Reading& b, const std::string& place) {
  throw Error(place + ": the rows are written in two ways: " + std::to_string(a.fitting) + " of the first " +
                  std::to_string(a.rows.size()) + " are " + description_of(a.dialect) + ", " +
                  std::to_string(b.fitting) + " are " + description_of(b.dialect) +
                  "; write the file in one way, or choose with --text-dialect " + words_of(a.dialect) +
                  " (rows of the other way are then rejected)",
              ExitCode::usage);
}

}  // namespace

std::size_t columns_of_most(std::span<const std::string> rows, const TextDialect& dialect) {
  Reading reading{dialect, {}, 0, 0};
  read_rows(rows, {}, reading);
  return reading.columns;
}

FoundDialect find_dialect(std::span<const std::string> rows, std::size_t names, std::span<const std::size_t> counts,
                          const std::string& place) {
  std::vector<Reading> readings;
  for (const TextDialect& dialect : candidates(rows)) {
    Reading reading{dialect, {}, 0, 0};
    read_rows(rows, counts, reading);
    if (reading.fitting > 0) readings.push_back(std::move(reading));
  }
  if (readings.empty()) return {};
  const bool named = std::ranges::any_of(readings, [&](const Reading& r) { return names > 0 && r.columns == names; });
  if (named) std::erase_if(readings, [&](const Reading& r) { return r.columns != names; });
  if (!named && !are_decimals(rows) && readings.size() > 1)
    std::erase_if(readings,
                  [](const Reading& r) { return r.dialect.separator == Separator::comma && r.dialect.decimal == ','; });
  const Reading* best = &readings.front();
  for (const Reading& r : readings)
    if (r.fitting > best->fitting) best = &r;
  for (const Reading& other : readings) {
    if (other.fitting < best->fitting) continue;
    const std::size_t row = first_difference(*best, other);
    if (row < rows.size()) refuse_two_readings(*best, other, row, rows[row], place);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (best->rows[i].empty() != other.rows[i].empty()) refuse_mixture(*best, other, place);
  }
  return {best->dialect, best->columns};
}

}  // namespace ilot
