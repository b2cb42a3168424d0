// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/pavement_width.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ilot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Choice: as far as a step is from the means on both sides of it, and as wide as these are.
constexpr double kStepGap = 0.05, kStepWindow = 0.3;  // metres
constexpr double kLeastHeights = 5;                   // Derived: a mean of fewer heights is no mean
// Derived: a pixel of ground contains a point one time in four or more, so that two columns of a metre have one.
constexpr double kLeastBin = 0.2;  // metres along the strip in which something must be seen; two columns or more

// Choice: leaves have gaps, and one row of pixels in five may have lost its points.
constexpr double kLeastShare = 0.8;
constexpr double kLeastRows = 0.2;  // Derived: two in ten rows are known where pixels have a point one time in four
constexpr double kBehind = 0.6;     // Choice: metres; reveals of doors and windows are less deep
constexpr double kSame = 0.15;      // Choice: metres; what stands so near to a wall is fixed to it (StreetMaskParams)
constexpr std::uint32_t kNever = UINT32_MAX / 2;

struct Front {
  double at = kInfinity;
  PavementEnd end = PavementEnd::open;
};

class StripReader {
 public:
  StripReader(const PavementStrip& strip, const PavementWidthParams& params)
      : strip_(strip), params_(params), last_ground_(strip.rows, 0) {
    for (std::uint32_t r = 0; r < strip.rows; ++r)
      for (std::uint32_t c = 0; c < strip.columns; ++c)
        if (strip.pixels[strip.at(r, c)] == PavementPixel::ground) last_ground_[r] = c;
  }

  StripWidth measure() const {
    Front front = standing_front();
    if (params_.next_kerb < front.at) front = {params_.next_kerb, PavementEnd::step};
    if (const double step = first_step(front.at); step < front.at) front = {step, PavementEnd::step};
    StripWidth out;
    out.end = front.end;
    out.width = front.end == PavementEnd::open ? seen_to() : front.at;
    out.unseen_share = unseen_share(out.width);
    add_passable(out);
    return out;
  }

 private:
  double middle(std::uint32_t column) const { return (column + 0.5) * strip_.step; }
  std::uint32_t columns_of(double metres) const {
    return static_cast<std::uint32_t>(std::llround(metres / strip_.step));
  }

  // The first place where what stands is, in some rows, behind which few rows go on: they have ground behind it, or
  // meet the same only later.
  struct Search {
    PavementPixel least = PavementPixel::wall;
    double depth = 0.2;  // metres, across, in which it stands
    double share = 0.5;  // of the rows of which something is known
    double nearest = 0;  // metres from the kerb
    double rank = 0.5;   // of the places in the rows; the answer
  };
  std::optional<double> standing(const Search& search, std::uint32_t from, std::uint32_t to, double before) const {
    const std::uint32_t depth = std::max(1u, columns_of(search.depth)), behind = columns_of(kBehind);
    const std::vector<std::uint32_t> next = next_of(search.least);
    const auto least = static_cast<std::uint32_t>(std::max(2.0, kLeastRows * (to - from)));
    for (std::uint32_t c = columns_of(search.nearest); c < strip_.columns && middle(c) < before; ++c) {
      std::uint32_t blocked = 0, open = 0;
      bool begins = false;
      for (std::uint32_t r = from; r < to; ++r) {
        const std::uint32_t at = next[strip_.at(r, c)];
        begins = begins || at == c;
        if (at < c + depth)
          ++blocked;
        else if (last_ground_[r] >= c + depth || at < c + depth + behind)
          ++open;
      }
      if (!begins || blocked < least || blocked < search.share * (blocked + open)) continue;
      std::vector<std::uint32_t> own;
      for (std::uint32_t r = strip_.first; r < strip_.last; ++r)
        if (const std::uint32_t at = next[strip_.at(r, c)]; at < c + depth) own.push_back(at);
      if (own.empty()) continue;
      std::sort(own.begin(), own.end());
      return middle(own[static_cast<std::size_t>(search.rank * static_cast<double>(own.size() - 1))]);
    }
    return std::nullopt;
  }

  // By pixel: the first column of its row, from its own on, in which at least `least` stands; else a number beyond all.
  std::vector<std::uint32_t> next_of(PavementPixel least) const {
    std::vector<std::uint32_t> next(strip_.pixels.size());
    for (std::uint32_t r = 0; r < strip_.rows; ++r) {
      std::uint32_t at = kNever;
      for (std::uint32_t c = strip_.columns; c-- > 0;) {
        if (strip_.pixels[strip_.at(r, c)] >= least) at = c;
        next[strip_.at(r, c)] = at;
      }
    }
    return next;
  }

  Front standing_front() const {
    Front front;
    Search search;
    if (const auto wall = standing(search, strip_.first, strip_.last, front.at)) front = {*wall, PavementEnd::wall};
    search.least = PavementPixel::fence, search.nearest = params_.nearest_fence;
    if (const auto fence = standing(search, strip_.first, strip_.last, front.at - kSame);
        fence && *fence < front.at - kSame)
      front = {*fence, PavementEnd::barrier};
    // Hedges and walls of gardens are known by how they stand: in a row that is longer than other things.
    search = {PavementPixel::object, params_.barrier_depth, kLeastShare, params_.nearest_fence, 0.25};
    const std::uint32_t length = columns_of(params_.least_barrier);
    const double before = front.at - params_.barrier_depth - kSame;  // nearer to a wall things stand before it
    for (std::uint32_t from = 0; from + length <= strip_.rows; from += std::max(1u, length / 6)) {
      if (from > strip_.first || from + length < strip_.last) continue;
      const auto row = standing(search, from, from + length, before);
      if (row && *row < before && *row < front.at) front = {*row, PavementEnd::barrier};
    }
    return front;
  }

  // The first place before `before` where the ground rises or falls at once.
  double first_step(double before) const {
    std::vector<double> sum(strip_.columns + 1, 0), count(strip_.columns + 1, 0);
    for (std::uint32_t c = 0; c < strip_.columns; ++c) {
      sum[c + 1] = sum[c], count[c + 1] = count[c];
      for (std::uint32_t r = strip_.first; r < strip_.last; ++r)
        if (const std::size_t i = strip_.at(r, c); strip_.pixels[i] == PavementPixel::ground)
          sum[c + 1] += strip_.heights[i], count[c + 1] += 1;
    }
    const auto column = [&](double d) {
      return static_cast<std::size_t>(
          std::clamp(std::llround(d / strip_.step), 0LL, static_cast<long long>(strip_.columns)));
    };
    const auto rise = [&](std::size_t c) {
      const double d = static_cast<double>(c) * strip_.step;
      const std::size_t a = column(d - kStepWindow), b = column(d - kStepGap), e = column(d + kStepGap),
                        f = column(d + kStepWindow);
      const double low = count[b] - count[a], high = count[f] - count[e];
      if (low < kLeastHeights || high < kLeastHeights) return 0.0;
      return std::abs((sum[f] - sum[e]) / high - (sum[b] - sum[a]) / low);
    };
    std::size_t best = 0;
    double most = params_.least_step;
    for (std::size_t c = column(kStepWindow); c + 1 < strip_.columns; ++c) {
      if (static_cast<double>(c) * strip_.step >= before - kStepGap) break;
      const double here = rise(c);
      if (here <= most) {
        if (best != 0) break;  // beyond the steepest place of the first step
        continue;
      }
      most = here, best = c;
    }
    return best == 0 ? kInfinity : static_cast<double>(best) * strip_.step;
  }

  std::uint32_t bin() const { return static_cast<std::uint32_t>(std::max(2.0, std::ceil(kLeastBin / strip_.step))); }

  bool is_seen(std::uint32_t from, std::uint32_t to) const {
    for (std::uint32_t r = strip_.first; r < strip_.last; ++r)
      for (std::uint32_t c = from; c < std::min(to, strip_.columns); ++c)
        if (strip_.pixels[strip_.at(r, c)] != PavementPixel::unseen) return true;
    return false;
  }

  // The end of what was seen before a long part that was not.
  double seen_to() const {
    double last = 0;
    for (std::uint32_t c = 0; c < strip_.columns; c += bin()) {
      if (c * strip_.step - last > params_.longest_unseen) break;
      if (is_seen(c, c + bin())) last = std::min(c + bin(), strip_.columns) * strip_.step;
    }
    return last;
  }

  double unseen_share(double width) const {
    std::uint32_t all = 0, unseen = 0;
    for (std::uint32_t c = 0; c * strip_.step < width && c < strip_.columns; c += bin())
      ++all, unseen += is_seen(c, c + bin()) ? 0 : 1;
    return all == 0 ? 1 : static_cast<double>(unseen) / all;
  }

  bool is_blocked(std::uint32_t column) const {
    for (std::uint32_t r = strip_.first; r < strip_.last; ++r)
      if (strip_.pixels[strip_.at(r, column)] > PavementPixel::ground) return true;
    return false;
  }

  void add_passable(StripWidth& out) const {
    double from = 0;
    const auto take = [&](double to) {
      if (to - from > out.passable) out.passable = to - from, out.passable_from = from;
    };
    for (std::uint32_t c = 0; c < strip_.columns && middle(c) < out.width; ++c)
      if (is_blocked(c)) {
        take(middle(c));
        from = middle(c);
      }
    take(out.width);
  }

  const PavementStrip& strip_;
  const PavementWidthParams& params_;
  std::vector<std::uint32_t> last_ground_;  // by row
};

}  // namespace

StripWidth pavement_width(const PavementStrip& strip, const PavementWidthParams& params) {
  return StripReader(strip, params).measure();
}

}  // namespace ilot
