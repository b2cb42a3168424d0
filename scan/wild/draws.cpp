// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/error.h"
#include "kernels/core/portable_math.h"
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

// FNV-1a (Fowler, Noll, Vo 1991) over the bytes of a name.
std::uint64_t key_of(std::string_view name) {
  std::uint64_t key = 0xcbf29ce484222325ull;
  for (const char c : name) key = (key ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return key;
}

Rng rng_of(std::uint64_t seed, std::string_view name, std::uint64_t element) {
  return Rng(mix64(seed ^ 0x77696c64ull) ^ key_of(name), element);
}

double truncated_normal(Rng& rng, double from, double to) {
  const double mean = (from + to) / 2, deviation = (to - from) / 4;
  for (int i = 0; i < 64; ++i) {
    const double v = mean + deviation * gaussian(rng);
    if (v >= from && v <= to) return v;
  }
  return mean;
}

std::size_t pick(std::span<const double> weights, double u) {
  for (std::size_t i = 0; i + 1 < weights.size(); ++i) {
    if (u < weights[i]) return i;
    u -= weights[i];
  }
  return weights.size() - 1;
}

double draw_from(const Distribution& row, Rng& rng) {
  switch (row.kind) {
    case DistributionKind::uniform:
      return row.from + (row.to - row.from) * rng.uniform();
    case DistributionKind::log_uniform:
      return std::clamp(row.from * natural_exp(natural_log(row.to / row.from) * rng.uniform()), row.from, row.to);
    case DistributionKind::normal:
      return truncated_normal(rng, row.from, row.to);
    case DistributionKind::whole:
      return row.from + static_cast<double>(rng.below(static_cast<std::uint64_t>(row.to - row.from) + 1));
    case DistributionKind::choice:
      return static_cast<double>(pick(row.weights, rng.uniform()));
    case DistributionKind::mixed:
      break;
  }
  const std::size_t part = pick(row.weights, rng.uniform());
  const double between = row.from + (row.to - row.from) * rng.uniform();
  return part == 0 ? 0 : part == 1 ? between : row.to;
}

bool is_once(const Distribution& row) {
  return row.per == "scene";
}

std::string choice_text(const Distribution& row, double value) {
  return row.kind == DistributionKind::choice ? std::string(row.choices[static_cast<std::size_t>(value)]) : "";
}

}  // namespace

std::uint64_t element_index(std::uint64_t first, std::uint64_t second, std::uint64_t third, std::uint64_t fourth) {
  return mix64(mix64(mix64(mix64(first) ^ second) ^ third) ^ fourth);
}

Draws::Draws(const SceneValues& values, std::span<const std::string_view> groups, std::uint64_t seed)
    : values_(values), seed_(seed) {
  for (const Distribution& row : distributions()) {
    if (std::find(groups.begin(), groups.end(), row.group) == groups.end()) continue;
    index_.emplace(row.name, records_.size());
    records_.push_back({&row, {}, {}});
    if (is_once(row)) records_.back().values[0] = draw(row, 0);
  }
}

Draws::Record& Draws::record_of(std::string_view name) {
  const auto found = index_.find(name);
  if (found == index_.end()) throw Error(fmt::format("distributions.csv has no row '{}' for this scene", name));
  return records_[found->second];
}

double Draws::draw(const Distribution& row, std::uint64_t element) const {
  const std::string key = "scene." + std::string(row.name);
  if (values_.is_set(key)) return values_.get(key);
  if (!row.family.empty() && values_.leaves_out(row.family)) return 0;
  Rng rng = rng_of(seed_, row.name, element);
  return draw_from(row, rng);
}

double Draws::number(std::string_view name, std::uint64_t element) {
  Record& record = record_of(name);
  if (is_once(*record.row)) element = 0;
  const auto [at, added] = record.values.try_emplace(element);
  if (added) at->second = draw(*record.row, element);
  return at->second;
}

int Draws::whole(std::string_view name, std::uint64_t element) {
  return static_cast<int>(std::lround(number(name, element)));
}

std::string_view Draws::choice(std::string_view name, std::uint64_t element) {
  const Distribution& row = *record_of(name).row;
  if (row.kind != DistributionKind::choice) throw Error(fmt::format("distributions.csv: '{}' is no choice", name));
  return row.choices[static_cast<std::size_t>(whole(name, element))];
}

bool Draws::happens(std::string_view share, std::uint64_t element, std::uint64_t of) {
  const double probability = number(share, of);
  Rng rng = rng_of(seed_, share, mix64(element) ^ 0x68617070656e73ull);
  const bool result = rng.uniform() < probability;
  record_of(share).happened[element] = result;
  return result;
}

Rng Draws::random(std::string_view use, std::uint64_t element) const {
  return rng_of(seed_ ^ 0x757365ull, use, element);
}

TrueDraws Draws::drawn() const {
  TrueDraws all;
  all.distributions = distributions_hash();
  for (const Record& record : records_) {
    const Distribution& row = *record.row;
    const bool fixed = values_.is_set("scene." + std::string(row.name));
    if (is_once(row))
      all.scene.push_back({std::string(row.name), record.values.at(0), std::string(row.unit),
                           choice_text(row, record.values.at(0)), fixed});
    else if (!record.values.empty()) {
      TrueDrawSummary summary{std::string(row.name),
                              std::string(row.unit),
                              std::string(row.per),
                              record.values.size(),
                              record.values.begin()->second,
                              record.values.begin()->second,
                              0,
                              {}};
      for (const auto& [element, value] : record.values) {
        summary.least = std::min(summary.least, value);
        summary.most = std::max(summary.most, value);
        summary.mean += value / static_cast<double>(record.values.size());
        if (row.kind == DistributionKind::choice) ++summary.choices[choice_text(row, value)];
      }
      all.elements.push_back(std::move(summary));
    }
    if (record.happened.empty()) continue;
    const auto yes =
        std::count_if(record.happened.begin(), record.happened.end(), [](const auto& h) { return h.second; });
    all.shares.push_back({std::string(row.name), record.happened.size(), static_cast<std::uint64_t>(yes)});
  }
  return all;
}

}  // namespace ilot::scan
