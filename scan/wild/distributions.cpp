// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/distributions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <deque>
#include <map>
#include <set>

#include "engine/error.h"
#include "engine/report/sha256.h"
#include "scan/wild/distributions_text.h"

namespace ilot::scan {
namespace {

constexpr std::string_view kHeader = "name,unit,kind,from,to,weights,per,group,family,meaning,source";
constexpr std::array<std::string_view, 6> kKinds{"uniform", "log_uniform", "normal", "whole", "mixed", "choice"};
constexpr std::array<std::string_view, 3> kMixture{"none", "some", "all"};

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> pieces;
  for (;;) {
    const std::size_t end = text.find(at);
    pieces.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return pieces;
    text.remove_prefix(end + 1);
  }
}

// A line of the file and its number, for messages.
struct Line {
  std::string_view text;
  std::size_t number = 0;

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(fmt::format("distributions.csv, line {}: {}", number, what));
  }

  double value(std::string_view field) const {
    double v = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), v);
    if (error != std::errc() || end != field.data() + field.size()) fail(fmt::format("'{}' is not a number", field));
    return v;
  }
};

// Reads "flat:3|round:1" into names and weights whose sum is 1.
void read_weights(const Line& line, std::string_view field, Distribution& row) {
  double sum = 0;
  for (std::string_view piece : split(field, '|')) {
    const std::size_t colon = piece.find(':');
    if (colon == std::string_view::npos) line.fail(fmt::format("'{}' needs the form name:weight", piece));
    row.choices.push_back(piece.substr(0, colon));
    row.weights.push_back(line.value(piece.substr(colon + 1)));
    if (!(row.weights.back() >= 0)) line.fail("a weight is negative");
    sum += row.weights.back();
  }
  if (!(sum > 0)) line.fail("all weights are zero");
  for (double& weight : row.weights) weight /= sum;
}

void read_mixture(const Line& line, Distribution& row) {
  std::vector<double> weights(kMixture.size());
  for (std::size_t i = 0; i < row.choices.size(); ++i) {
    const auto at = std::find(kMixture.begin(), kMixture.end(), row.choices[i]);
    if (at == kMixture.end()) line.fail("the weights of mixed are none, some and all");
    weights[static_cast<std::size_t>(at - kMixture.begin())] = row.weights[i];
  }
  row.weights = weights;
  row.choices.clear();
}

void check_range(const Line& line, const Distribution& row) {
  if (!(row.from <= row.to)) line.fail("from is larger than to");
  if (row.kind == DistributionKind::log_uniform && !(row.from > 0)) line.fail("a logarithm needs a range above 0");
  if (row.kind == DistributionKind::mixed && !(row.from <= 0 && row.to >= 0)) line.fail("the range must contain 0");
  const bool can_be_nothing =
      row.kind == DistributionKind::choice || (row.kind != DistributionKind::log_uniform && row.from <= 0);
  if (!row.family.empty() && !can_be_nothing) line.fail("a row of a family needs 0 in its range, or choices");
}

Distribution parse_row(const Line& line) {
  const std::vector<std::string_view> fields = split(line.text, ',');
  if (fields.size() != 11) line.fail(fmt::format("has {} fields, not 11", fields.size()));
  Distribution row;
  row.name = fields[0];
  row.unit = fields[1];
  const auto kind = std::find(kKinds.begin(), kKinds.end(), fields[2]);
  if (kind == kKinds.end()) line.fail(fmt::format("'{}' is no kind of distribution", fields[2]));
  row.kind = static_cast<DistributionKind>(kind - kKinds.begin());
  if (!fields[5].empty()) read_weights(line, fields[5], row);
  if (row.kind == DistributionKind::choice) {
    if (row.choices.size() < 2) line.fail("a choice needs two names or more");
    row.to = static_cast<double>(row.choices.size() - 1);
  } else {
    row.from = line.value(fields[3]);
    row.to = line.value(fields[4]);
    if (row.kind == DistributionKind::mixed)
      read_mixture(line, row);
    else if (!row.choices.empty())
      line.fail("only mixed and choice have weights");
  }
  row.per = fields[6];
  row.group = fields[7];
  row.family = fields[8];
  row.meaning = fields[9];
  row.source = fields[10];
  for (std::string_view needed : {row.name, row.unit, row.per, row.group, row.meaning, row.source})
    if (needed.empty()) line.fail("only family may be empty");
  check_range(line, row);
  return row;
}

bool is_of(const Distribution& row, std::span<const std::string_view> groups) {
  return std::find(groups.begin(), groups.end(), row.group) != groups.end();
}

// Keeps the texts of the options, which are views.
struct OptionTexts {
  std::deque<std::string> keys, choices, help;
};

SceneOption option_of(const Distribution& row, OptionTexts& texts) {
  texts.keys.push_back("scene." + std::string(row.name));
  std::string& names = texts.choices.emplace_back();
  for (std::string_view name : row.choices) names += (names.empty() ? "" : "|") + std::string(name);
  texts.help.push_back(fmt::format("{}; drawn for each {}", row.meaning, row.per));
  const double low = row.kind == DistributionKind::mixed ? std::min(0.0, row.from) : row.from;
  return {texts.keys.back(), low, row.unit, low, row.to, texts.help.back(), true, names};
}

}  // namespace

std::vector<Distribution> parse_distributions(std::string_view text) {
  std::vector<Distribution> rows;
  std::set<std::string_view> names;
  std::size_t number = 0;
  for (std::string_view line_text : split(text, '\n')) {
    const Line line{line_text, ++number};
    if (number == 1 && line_text != kHeader) line.fail(fmt::format("the header needs to be {}", kHeader));
    if (number == 1 || line_text.empty()) continue;
    rows.push_back(parse_row(line));
    if (!names.insert(rows.back().name).second) line.fail(fmt::format("'{}' comes twice", rows.back().name));
  }
  return rows;
}

std::span<const Distribution> distributions() {
  static const std::vector<Distribution> rows = parse_distributions(distributions_text());
  return rows;
}

const std::string& distributions_hash() {
  static const std::string hash = [] {
    Sha256 sum;
    sum.update(std::as_bytes(std::span(distributions_text())));
    return sum.hex();
  }();
  return hash;
}

std::span<const SceneOption> drawn_options(std::span<const std::string_view> groups) {
  static OptionTexts texts;
  static std::map<std::vector<std::string_view>, std::vector<SceneOption>> known;
  const std::vector<std::string_view> key(groups.begin(), groups.end());
  const auto [at, added] = known.try_emplace(key);
  if (added)
    for (const Distribution& row : distributions())
      if (is_of(row, groups)) at->second.push_back(option_of(row, texts));
  return at->second;
}

std::vector<std::string_view> families_of(std::span<const std::string_view> groups) {
  std::vector<std::string_view> families;
  for (const Distribution& row : distributions())
    if (is_of(row, groups) && !row.family.empty() &&
        std::find(families.begin(), families.end(), row.family) == families.end())
      families.push_back(row.family);
  return families;
}

}  // namespace ilot::scan
