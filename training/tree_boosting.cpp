// SPDX-License-Identifier: Apache-2.0
#include "training/tree_boosting.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr double kSlopeUnit = 0x1p-20;  // unit of gradients and curvatures
constexpr std::size_t kMostBins = 256;
constexpr double kMostStep = 8;       // largest step that a leaf adds
constexpr std::size_t kGrain = 4096;  // rows
// Choice: levels by which the largest gradients are found; more of them would choose nearly the same rows.
constexpr std::size_t kGradientLevels = 1024;  // from 0 to 1
// Choice: a histogram of so many columns stays in the nearest cache while the bins of so many rows do in the next one.
constexpr std::size_t kColumnsCounted = 16, kRowsCounted = 256;
constexpr std::size_t kRowsAhead = 12;  // that are fetched while a row is counted

std::int32_t in_units(double slope) {
  return static_cast<std::int32_t>(std::lround(slope / kSlopeUnit));
}

// Gradient and curvature of one row, in units.
struct RowSlope {
  std::int32_t first = 0, second = 0;
};

std::size_t level_of(const RowSlope& s) {
  return static_cast<std::size_t>(kSlopeUnit * std::abs(s.first) * kGradientLevels);
}

// Sums of slopes.
struct Slope {
  std::int64_t first = 0, second = 0;
  void add(const Slope& s) { first += s.first, second += s.second; }
  void add(const RowSlope& s) { first += s.first, second += s.second; }
  Slope less(const Slope& s) const { return {first - s.first, second - s.second}; }
};

// Bins, once row after row, for histograms of all columns, and once column after column, for the rows of a split.
struct BinnedColumns {
  std::size_t rows = 0;
  std::vector<std::vector<float>> limits;
  std::vector<std::size_t> start;  // start of each column in a histogram, and the end
  std::vector<std::uint8_t> by_row, by_column;
  std::vector<std::uint64_t> keys;  // hash of the bins of each row
  std::size_t columns() const { return limits.size(); }
  const std::uint8_t* row(std::size_t r) const { return by_row.data() + r * columns(); }
  const std::uint8_t* column(std::size_t c) const { return by_column.data() + c * rows; }
};

// Returns limits half way between values, so that each bin has about the same number of rows. Equal values are never
// separated.
std::vector<float> even_limits(std::vector<double> values, std::size_t bins) {
  std::sort(values.begin(), values.end());
  std::vector<float> limits;
  for (std::size_t b = 1; b < bins; ++b) {
    const std::size_t at = b * values.size() / bins;
    if (at == 0 || at == values.size()) continue;
    const auto above = std::upper_bound(values.begin(), values.end(), values[at - 1]);
    if (above == values.end()) break;
    const auto limit = static_cast<float>(values[at - 1] + (*above - values[at - 1]) / 2);
    if (limits.empty() || limit > limits.back()) limits.push_back(limit);
  }
  return limits;
}

std::vector<std::uint64_t> row_keys(const BinnedColumns& columns) {
  std::vector<std::uint64_t> keys(columns.rows, 0);
  parallel_for((columns.rows + kGrain - 1) / kGrain, [&](std::size_t part) {
    const std::size_t end = std::min(columns.rows, (part + 1) * kGrain);
    for (std::size_t r = part * kGrain; r < end; ++r)
      for (std::size_t c = 0; c < columns.columns(); ++c) keys[r] = mix64(keys[r] ^ columns.row(r)[c]);
  });
  return keys;
}

BinnedColumns binned(const TreeSamples& samples, std::size_t bins) {
  BinnedColumns out{samples.of_class.size(), std::vector<std::vector<float>>(samples.columns), {0}, {}, {}, {}};
  out.by_row.resize(out.rows * samples.columns), out.by_column.resize(out.by_row.size());
  parallel_for(samples.columns, [&](std::size_t c) {
    const std::vector<double> column = samples.values(c);
    assert(column.size() == out.rows);
    out.limits[c] = even_limits(column, bins);
    const std::vector<std::uint8_t> own = tree_bins({&out.limits[c], 1}, column);
    std::copy(own.begin(), own.end(), out.by_column.begin() + static_cast<std::ptrdiff_t>(c * out.rows));
    for (std::size_t r = 0; r < out.rows; ++r) out.by_row[r * samples.columns + c] = own[r];
  });
  for (const auto& list : out.limits) out.start.push_back(out.start.back() + list.size() + 1);
  out.keys = row_keys(out);
  return out;
}

// Returns the lowest level from which on there are at most so many rows.
std::size_t first_large_level(std::span<const RowSlope> slopes, std::size_t most) {
  std::array<std::size_t, kGradientLevels + 1> count{};
  for (const RowSlope& s : slopes) ++count[level_of(s)];
  std::size_t from = kGradientLevels + 1, above = 0;
  while (from > 1 && above + count[from - 1] <= most) above += count[--from];
  return from;
}

// Returns the rows that a tree learns from. The slopes of those that were drawn count for all they stand for.
std::vector<std::uint32_t> sampled_rows(std::span<const std::uint64_t> keys, const TreeBoostingParams& params,
                                        std::uint64_t tree, std::span<RowSlope> slopes) {
  const std::size_t large =
      first_large_level(slopes, static_cast<std::size_t>(params.largest_share * static_cast<double>(slopes.size())));
  const auto times = static_cast<std::int32_t>(params.drawn_of);
  std::vector<std::uint32_t> out;
  out.reserve(slopes.size());
  for (std::size_t r = 0; r < slopes.size(); ++r) {
    const bool drawn = times > 1 && level_of(slopes[r]) < large;
    if (drawn && Rng(keys[r], tree).at(0) % params.drawn_of != 0) continue;
    if (drawn) slopes[r] = {times * slopes[r].first, times * slopes[r].second};
    out.push_back(static_cast<std::uint32_t>(r));
  }
  return out;
}

// The slopes of a node's rows by column and bin, and its rows in their order.
struct GrowingNode {
  Slope all;
  std::vector<std::uint32_t> rows;
  std::vector<Slope> histogram;
};

// Grows one tree for one class from the slopes of all rows. Of the two nodes of a split only the smaller one is
// counted. The other is the difference from their parent.
class TreeGrower {
 public:
  TreeGrower(const BinnedColumns& columns, std::span<const RowSlope> slopes, const TreeBoostingParams& params)
      : columns_(columns), slopes_(slopes), params_(params) {}

  // Fills in a tree, and adds the value of its leaf to the score of each row.
  void grow(std::vector<std::uint32_t> rows, std::span<TreeSplit> splits, std::span<std::int32_t> leaves,
            std::span<std::int32_t> scores) {
    std::vector<GrowingNode> level(1);
    level[0].rows = std::move(rows);
    for (const std::uint32_t r : level[0].rows) level[0].all.add(slopes_[r]);
    level[0].histogram = counted(level[0].rows);
    for (std::size_t depth = 1; depth <= params_.depth; ++depth) {
      std::vector<GrowingNode> next(2 * level.size());
      for (std::size_t n = 0; n < level.size(); ++n) {
        splits[level.size() - 1 + n] = best_split(level[n]);
        part(level[n], splits[level.size() - 1 + n], depth < params_.depth, next[2 * n], next[2 * n + 1]);
      }
      level = std::move(next);
    }
    for (std::size_t n = 0; n < leaves.size(); ++n) leaves[n] = leaf_of(level[n].all);
    add_leaves(splits, leaves, scores);
  }

 private:
  double score(const Slope& s) const {
    const double g = kSlopeUnit * static_cast<double>(s.first), h = kSlopeUnit * static_cast<double>(s.second);
    return g * g / (h + params_.ridge);
  }
  std::int32_t leaf_of(const Slope& s) const {
    const double g = kSlopeUnit * static_cast<double>(s.first), h = kSlopeUnit * static_cast<double>(s.second);
    const double step = -params_.shrinkage * g / (h + params_.ridge);
    return static_cast<std::int32_t>(std::lround(std::clamp(step, -kMostStep, kMostStep) / kTreeUnit));
  }

  // Takes all rows down the tree, some at a time, so that their nodes stay in the cache.
  void add_leaves(std::span<const TreeSplit> splits, std::span<const std::int32_t> leaves,
                  std::span<std::int32_t> scores) const {
    std::array<std::uint8_t, kGrain> node;
    for (std::size_t first = 0; first < scores.size(); first += kGrain) {
      const std::size_t count = std::min(kGrain, scores.size() - first);
      std::fill_n(node.begin(), count, std::uint8_t{0});
      for (std::size_t depth = 0; depth < params_.depth; ++depth) {
        const TreeSplit* split = splits.data() + (std::size_t{1} << depth) - 1;
        for (std::size_t i = 0; i < count; ++i) {
          const TreeSplit s = split[node[i]];
          node[i] = static_cast<std::uint8_t>(2 * node[i] + (columns_.column(s.column)[first + i] > s.bin));
        }
      }
      for (std::size_t i = 0; i < count; ++i) scores[first + i] += leaves[node[i]];
    }
  }

  void count(std::span<const std::uint32_t> rows, std::size_t first, std::size_t end, Slope* histogram) const {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      __builtin_prefetch(columns_.row(rows[std::min(i + kRowsAhead, rows.size() - 1)]) + first);
      const Slope slope{slopes_[rows[i]].first, slopes_[rows[i]].second};
      const std::uint8_t* bins = columns_.row(rows[i]);
      for (std::size_t c = first; c < end; ++c) histogram[columns_.start[c] + bins[c]].add(slope);
    }
  }

  std::vector<Slope> counted(const std::vector<std::uint32_t>& rows) const {
    std::vector<Slope> histogram(columns_.start.back());
    for (std::size_t first = 0; first < rows.size(); first += kRowsCounted) {
      const auto some = std::span(rows).subspan(first, std::min(kRowsCounted, rows.size() - first));
      for (std::size_t c = 0; c < columns_.columns(); c += kColumnsCounted)
        count(some, c, std::min(columns_.columns(), c + kColumnsCounted), histogram.data());
    }
    return histogram;
  }

  TreeSplit best_split(const GrowingNode& node) const {
    TreeSplit best{0, kNoSplit};
    double most = 0;
    const double before = score(node.all);
    for (std::size_t c = 0; c < columns_.limits.size() && !node.rows.empty(); ++c) {
      Slope left;
      for (std::size_t b = 0; b < columns_.limits[c].size(); ++b) {
        left.add(node.histogram[columns_.start[c] + b]);
        const Slope right = node.all.less(left);
        if (kSlopeUnit * static_cast<double>(std::min(left.second, right.second)) < params_.least_curvature) continue;
        const double gain = score(left) + score(right) - before;
        if (gain > most) most = gain, best = {static_cast<std::uint16_t>(c), static_cast<std::uint16_t>(b)};
      }
    }
    return best;
  }

  void part(GrowingNode& node, TreeSplit split, bool goes_on, GrowingNode& left, GrowingNode& right) const {
    if (split.bin == kNoSplit) {
      left = std::move(node);
      right.histogram.resize(left.histogram.size());
      return;
    }
    const std::uint8_t* bins = columns_.column(split.column);
    for (const std::uint32_t r : node.rows) {
      GrowingNode& side = bins[r] > split.bin ? right : left;
      side.rows.push_back(r);
      side.all.add(slopes_[r]);
    }
    if (!goes_on) return;
    const bool left_is_lesser = left.rows.size() < right.rows.size();
    GrowingNode &lesser = left_is_lesser ? left : right, &other = left_is_lesser ? right : left;
    lesser.histogram = counted(lesser.rows);
    other.histogram = std::move(node.histogram);
    for (std::size_t b = 0; b < other.histogram.size(); ++b)
      other.histogram[b] = other.histogram[b].less(lesser.histogram[b]);
  }

  const BinnedColumns& columns_;
  std::span<const RowSlope> slopes_;
  const TreeBoostingParams& params_;
};

// Scores of all rows, class after class, while trees are added.
class Booster {
 public:
  Booster(const TreeSamples& samples, const TreeBoostingParams& params)
      : samples_(samples),
        params_(params),
        columns_(binned(samples, params.bins)),
        scores_(samples.classes * rows()),
        slopes_(scores_.size()) {
    out_.classes = samples.classes, out_.depth = params.depth;
    std::vector<double> count(samples.classes, 0);
    for (const std::uint32_t c : samples.of_class) ++count[c];
    for (std::size_t c = 0; c < samples.classes; ++c) {
      const double log = natural_log(std::max(1.0, count[c]) / static_cast<double>(rows()));
      out_.first.push_back(static_cast<std::int32_t>(std::lround(log / kTreeUnit)));
      std::fill_n(scores_.begin() + static_cast<std::ptrdiff_t>(c * rows()), rows(), out_.first[c]);
    }
  }

  BoostedTrees boost() {
    const std::size_t leaves = std::size_t{1} << params_.depth, trees = params_.rounds * samples_.classes;
    out_.splits.resize(trees * (leaves - 1));
    out_.leaves.resize(trees * leaves);
    for (std::size_t round = 0; round < params_.rounds; ++round) {
      set_slopes();
      parallel_for(samples_.classes, [&](std::size_t c) {
        const std::size_t tree = round * samples_.classes + c;
        const auto slopes = std::span(slopes_).subspan(c * rows(), rows());
        TreeGrower(columns_, slopes, params_)
            .grow(sampled_rows(columns_.keys, params_, tree, slopes),
                  std::span(out_.splits).subspan(tree * (leaves - 1), leaves - 1),
                  std::span(out_.leaves).subspan(tree * leaves, leaves),
                  std::span(scores_).subspan(c * rows(), rows()));
      });
    }
    keep_used_limits();
    return out_;
  }

 private:
  std::size_t rows() const { return samples_.of_class.size(); }
  void set_slopes() {
    parallel_for((rows() + kGrain - 1) / kGrain, [&](std::size_t part) {
      std::vector<std::int32_t> own(samples_.classes);
      std::vector<double> share(samples_.classes);
      for (std::size_t r = part * kGrain; r < std::min(rows(), (part + 1) * kGrain); ++r) {
        for (std::size_t c = 0; c < own.size(); ++c) own[c] = scores_[c * rows() + r];
        tree_shares(own, share);
        for (std::size_t c = 0; c < own.size(); ++c) {
          const double p = share[c], y = samples_.of_class[r] == c ? 1 : 0;
          slopes_[c * rows() + r] = {in_units(p - y), in_units(p * (1 - p))};
        }
      }
    });
  }

  void keep_used_limits() {
    std::vector<std::vector<std::uint16_t>> place;  // of a limit: 1 where a tree uses it, later its new number
    for (const auto& list : columns_.limits) place.emplace_back(list.size(), 0);
    for (const TreeSplit& s : out_.splits)
      if (s.bin != kNoSplit) place[s.column][s.bin] = 1;
    out_.limits.resize(columns_.limits.size());
    for (std::size_t c = 0; c < place.size(); ++c)
      for (std::size_t b = 0; b < place[c].size(); ++b) {
        if (place[c][b] == 0) continue;
        place[c][b] = static_cast<std::uint16_t>(out_.limits[c].size());
        out_.limits[c].push_back(columns_.limits[c][b]);
      }
    for (TreeSplit& s : out_.splits)
      if (s.bin != kNoSplit) s.bin = place[s.column][s.bin];
  }

  const TreeSamples& samples_;
  const TreeBoostingParams& params_;
  BinnedColumns columns_;
  std::vector<std::int32_t> scores_;
  std::vector<RowSlope> slopes_;
  BoostedTrees out_;
};

}  // namespace

ReadColumn columns_of_rows(std::span<const double> rows, std::size_t columns) {
  return [rows, columns](std::size_t column) {
    std::vector<double> values(rows.size() / columns);
    for (std::size_t r = 0; r < values.size(); ++r) values[r] = rows[r * columns + column];
    return values;
  };
}

BoostedTrees boost_trees(const TreeSamples& samples, const TreeBoostingParams& params) {
  assert(samples.classes > 0 && samples.columns > 0 && !samples.of_class.empty());
  assert(params.drawn_of > 0 && params.drawn_of <= kMostDrawnOf);
  assert(params.depth > 0 && params.depth <= 7 && params.bins > 1 && params.bins <= kMostBins);
  return Booster(samples, params).boost();
}

}  // namespace ilot
