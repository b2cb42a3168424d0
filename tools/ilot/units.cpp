// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/units.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include "engine/error.h"

namespace ilot {
namespace {

std::string upper(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

std::uint64_t parse_bytes(const std::string& option, const std::string& text) {
  double number = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number, std::chars_format::fixed);
  std::string suffix = upper(std::string(end, text.data() + text.size()));
  suffix.erase(std::remove(suffix.begin(), suffix.end(), ' '), suffix.end());
  constexpr std::string_view kPrefixes = "KMGT";
  const std::size_t power = suffix.empty() ? std::string_view::npos : kPrefixes.find(suffix[0]);
  const double factor =
      power == std::string_view::npos ? 1 : static_cast<double>(std::uint64_t{1} << (10 * (power + 1)));
  const std::string rest = power == std::string_view::npos ? suffix : suffix.substr(1);
  const bool known = rest.empty() || rest == "B" || (rest == "IB" && factor > 1) || (rest == "I" && factor > 1);
  if (code != std::errc() || !known || !(number >= 0) || number * factor > 0x1p60) {
    throw Error(option + " " + text + ": a number of bytes is expected, as in 512M or 2G", ExitCode::usage);
  }
  return static_cast<std::uint64_t>(number * factor);
}

std::string parse_crs(const std::string& option, const std::string& text) {
  if (text.empty()) return text;
  const std::string name = upper(text);
  const auto is_code = [](std::string_view digits) {
    int code = 0;
    const char* end = digits.data() + digits.size();
    const auto parsed = std::from_chars(digits.data(), end, code);
    return parsed.ec == std::errc() && parsed.ptr == end && code >= 1024 && code <= 999999;
  };
  const std::string_view codes = std::string_view(name).substr(std::min<std::size_t>(5, name.size()));
  const std::size_t plus = codes.find('+');
  const bool heights_known = plus == codes.npos || is_code(codes.substr(plus + 1));
  if (!name.starts_with("EPSG:") || !is_code(codes.substr(0, plus)) || !heights_known) {
    throw Error(option + " " + text + ": EPSG:n is expected, as in EPSG:2154, or EPSG:2154+5720 with that of heights",
                ExitCode::usage);
  }
  return name;
}

void add_dialect_option(CLI::App& command, std::string& dialect) {
  command
      .add_option("--text-dialect", dialect,
                  "how text inputs write numbers, as semicolon,decimal-comma,thousands-blank [found from the rows]")
      ->option_text("WORDS");
}

OpenOptions open_options(const std::string& dialect) {
  OpenOptions options;
  if (!dialect.empty()) options.dialect = dialect_of_words(dialect);
  return options;
}

}  // namespace ilot
