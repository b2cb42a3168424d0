// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/text_dialect.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>

#include "engine/error.h"
#include "engine/formats/tables/lines.h"

namespace ilot {
namespace {

struct Word {
  const char* option;
  const char* meaning;
  char sign;
};

constexpr std::array<Word, 4> kSeparators{{{"blank", "separated by blanks", ' '},
                                           {"tab", "separated by tabs", '\t'},
                                           {"comma", "separated by commas", ','},
                                           {"semicolon", "separated by semicolons", ';'}}};
constexpr std::array<Word, 2> kDecimals{
    {{"decimal-point", "decimal point", '.'}, {"decimal-comma", "decimal comma", ','}}};
constexpr std::array<Word, 4> kThousands{{{"thousands-comma", "commas between thousands", ','},
                                          {"thousands-point", "points between thousands", '.'},
                                          {"thousands-apostrophe", "apostrophes between thousands", '\''},
                                          {"thousands-blank", "blanks between thousands", ' '}}};

constexpr std::size_t kLongestNumber = 64;  // characters; doubles need 25

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Returns the number of bytes of a blank at the front that groups digits: a blank, U+00A0 (in Latin-1 and UTF-8) or
// U+202F.
std::size_t group_blank(std::string_view text) {
  if (text.starts_with(' ') || text.starts_with('\xA0')) return 1;
  if (text.starts_with("\xC2\xA0")) return 2;
  return text.starts_with("\xE2\x80\xAF") ? 3 : 0;
}

std::size_t group_sign(std::string_view text, char thousands) {
  if (thousands == ' ') return group_blank(text);
  return !text.empty() && text.front() == thousands ? 1 : 0;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

// Reads the whole digits, in groups of three after the first group if the dialect has them; false when there are none.
bool take_whole(std::string_view& text, char thousands, std::string& plain) {
  std::size_t run = 0;
  const auto take_digits = [&] {
    for (run = 0; !text.empty() && is_digit(text.front()); ++run, text.remove_prefix(1)) plain.push_back(text.front());
  };
  const bool zero = text.starts_with('0');
  take_digits();
  if (run == 0) return false;
  if (thousands == 0 || group_sign(text, thousands) == 0) return true;
  if (run > 3 || zero) return false;
  while (const std::size_t sign = group_sign(text, thousands)) {
    text.remove_prefix(sign);
    take_digits();
    if (run != 3) return false;
  }
  return true;
}

// Returns the number in C syntax; false when it is not a number of the dialect.
bool as_c_number(std::string_view text, const TextDialect& dialect, std::string& plain) {
  plain.clear();
  if (text.size() > kLongestNumber) return false;
  if (text.starts_with('-')) plain.push_back('-');
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (!take_whole(text, dialect.thousands, plain)) return false;
  if (text.starts_with(dialect.decimal)) {
    plain.push_back('.');
    text.remove_prefix(1);
    if (text.empty() || !is_digit(text.front())) return false;
    for (; !text.empty() && is_digit(text.front()); text.remove_prefix(1)) plain.push_back(text.front());
  }
  plain.append(text);  // an exponent
  return text.empty() || text.front() == 'e' || text.front() == 'E';
}

bool is_named_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return !text.empty() && (text.front() == 'n' || text.front() == 'N' || text.front() == 'i' || text.front() == 'I');
}

std::size_t skip_blanks(std::string_view line, std::size_t at) {
  while (at < line.size() && is_blank(line[at])) ++at;
  return at;
}

// Returns the end of a quoted field that begins at `at`, behind its closing quote.
std::size_t end_of_quoted(std::string_view line, std::size_t at) {
  const std::size_t close = line.find('"', at + 1);
  return close == std::string_view::npos ? line.size() : close + 1;
}

void split_at_blanks(std::string_view line, std::size_t most, std::vector<std::string_view>& fields) {
  for (std::size_t at = skip_blanks(line, 0); at < line.size() && fields.size() < most; at = skip_blanks(line, at)) {
    const std::size_t begin = at;
    if (line[at] == '"') {
      at = end_of_quoted(line, at);
      fields.push_back(line.substr(begin + 1, std::max(at - begin, std::size_t{2}) - 2));
      continue;
    }
    while (at < line.size() && !is_blank(line[at])) ++at;
    fields.push_back(line.substr(begin, at - begin));
  }
}

void split_at_signs(std::string_view line, char sign, std::size_t signs_within, std::size_t most,
                    std::vector<std::string_view>& fields) {
  line = trimmed(line);
  for (std::size_t at = 0; at < line.size() && fields.size() < most; ++at) {
    at = sign == '\t' ? at : skip_blanks(line, at);
    const std::size_t begin = at;
    if (at < line.size() && line[at] == '"') {
      at = end_of_quoted(line, at);
      fields.push_back(line.substr(begin + 1, std::max(at - begin, std::size_t{2}) - 2));
      at = std::min(line.find(sign, at), line.size());
      continue;
    }
    at = std::min(line.find(sign, at), line.size());
    for (std::size_t i = 0; i < signs_within && at < line.size(); ++i)
      at = std::min(line.find(sign, at + 1), line.size());
    fields.push_back(trimmed(line.substr(begin, at - begin)));
  }
}

template <std::size_t N>
const Word& word_of(const std::array<Word, N>& words, char sign) {
  return *std::find_if(words.begin(), words.end(), [&](const Word& w) { return w.sign == sign; });
}

template <std::size_t N>
char sign_of(const std::array<Word, N>& words, std::string_view option) {
  for (const Word& word : words)
    if (option == word.option) return word.sign;
  return 0;
}

}  // namespace

std::string description_of(const TextDialect& dialect) {
  std::string text = kSeparators[static_cast<std::size_t>(dialect.separator)].meaning;
  text += std::string(", ") + word_of(kDecimals, dialect.decimal).meaning;
  if (dialect.thousands != 0) text += std::string(", ") + word_of(kThousands, dialect.thousands).meaning;
  return text;
}

std::string words_of(const TextDialect& dialect) {
  std::string text = kSeparators[static_cast<std::size_t>(dialect.separator)].option;
  text += std::string(",") + word_of(kDecimals, dialect.decimal).option;
  if (dialect.thousands != 0) text += std::string(",") + word_of(kThousands, dialect.thousands).option;
  return text;
}

TextDialect dialect_of_words(const std::string& words) {
  const auto fault = [&](const std::string& what) {
    return Error("--text-dialect " + words + ": " + what +
                     "; there is one of blank, tab, comma, semicolon, then decimal-point or decimal-comma, and "
                     "thousands-comma, thousands-point, thousands-apostrophe or thousands-blank, joined by commas",
                 ExitCode::usage);
  };
  TextDialect dialect;
  bool separated = false;
  std::string_view rest = words;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), word.size() + 1));
    if (const char sign = sign_of(kSeparators, word)) {
      for (std::size_t i = 0; i < kSeparators.size(); ++i)
        if (kSeparators[i].sign == sign) dialect.separator = static_cast<Separator>(i);
      separated = true;
    } else if (const char decimal = sign_of(kDecimals, word)) {
      dialect.decimal = decimal;
    } else if (const char thousands = sign_of(kThousands, word)) {
      dialect.thousands = thousands;
    } else {
      throw fault("\"" + std::string(word) + "\" is not one of its words");
    }
  }
  if (!separated) throw fault("says no separator");
  if (dialect.decimal == dialect.thousands) throw fault("the same sign cannot stand for decimals and for thousands");
  return dialect;
}

void split_row(std::string_view line, const TextDialect& dialect, std::size_t most,
               std::vector<std::string_view>& fields) {
  fields.clear();
  if (dialect.separator == Separator::blank) return split_at_blanks(line, most, fields);
  const bool pairs =
      dialect.separator == Separator::comma && dialect.decimal == ',' && line.find('"') == std::string_view::npos;
  split_at_signs(line, kSeparators[static_cast<std::size_t>(dialect.separator)].sign, pairs ? 1 : 0, most, fields);
}

bool parse_number(std::string_view field, const TextDialect& dialect, double& value) {
  field = trimmed(field);
  if ((dialect.decimal == '.' && dialect.thousands == 0) || is_named_number(field)) return parse_number(field, value);
  std::string plain;
  return as_c_number(field, dialect, plain) && parse_number(plain, value);
}

bool parse_row(std::string_view line, const TextDialect& dialect, std::vector<std::string_view>& fields,
               std::span<double> values) {
  split_row(line, dialect, values.size() + 1, fields);
  if (fields.size() != values.size()) return false;
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!parse_number(fields[i], dialect, values[i])) return false;
  return true;
}

int decimals_of(std::string_view field, const TextDialect& dialect) {
  const std::size_t e = field.find_first_of("eE");
  int exponent = 0;
  if (e != std::string_view::npos) {
    const bool plus = e + 1 < field.size() && field[e + 1] == '+';
    std::from_chars(field.data() + e + (plus ? 2 : 1), field.data() + field.size(), exponent);
  }
  const std::string_view digits = trimmed(field.substr(0, e));
  const std::size_t point = digits.find(dialect.decimal);
  const std::size_t last = digits.find_last_not_of('0');
  const int written = point == std::string_view::npos || last == std::string_view::npos || last <= point
                          ? 0
                          : static_cast<int>(last - point);
  constexpr int kMostExponent = 400;  // of doubles
  return std::max(0, written - std::clamp(exponent, -kMostExponent, kMostExponent));
}

bool looks_like_numbers(std::string_view line) {
  std::string plain;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t wide = line[at] == ' ' ? 0 : group_blank(line.substr(at));
    if (wide == 0 && line[at] != '\'') plain.push_back(line[at]);
    at += std::max<std::size_t>(wide, 1);
  }
  // German thousands ("6.861.000,5") consist only of digits and points, so the text between separators must begin as a
  // number.
  std::vector<std::string_view> fields;
  split_fields(plain, kMostShownColumns, fields);
  double value = 0;
  for (const std::string_view field : fields) {
    const bool grouped = !field.empty() && field.find_first_not_of("+-0123456789.") == std::string_view::npos;
    if (!grouped && !parse_number(field, value)) return false;
  }
  return !fields.empty();
}

}  // namespace ilot
