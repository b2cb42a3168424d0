// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_growth.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/products/facades/walls/wall_neighbours.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: the width of a narrow pier.
constexpr double kGrowthCell = 0.5;  // metres
// Choice: windows between piers are as wide; where points are farther apart, no opening is found between them.
constexpr double kMostBetween = 1.5;  // metres without a strip that continues the wall
// Derived: the noise of a wall fills two epsilons, four bins.
constexpr std::int64_t kBinsOfWall = 4, kBinsBeside = 4;  // bins of half an epsilon: on it, and on either side of it
// Derived: plants and walls across fill the layers on the wall and beside it evenly.
constexpr double kChance = 1.0 / 3;  // share of points that are on it by chance
// Choice: old walls bow and lean by some centimetres from the plane of one of their parts.
constexpr double kMostDrift = 0.1;  // metres
// Choice: a bow of 3 cm over 10 m leans by 1.2 cm a metre at its ends; the next house steps at once.
constexpr std::int64_t kStripsOfBow = 2;  // strips from one change of the distance, by half of epsilon, to the next
constexpr double kSureOfStrip = 3;        // Derived: three standard deviations
constexpr double kMostOnPlane = 0.5;      // Derived: a majority of the points
// Choice: windows and doors take up to two thirds of a strip.
constexpr double kStripCovered = 1.0 / 3;  // share of the cells of a strip with points on the plane
constexpr double kLeastStrip = 2;          // Choice: facades.least_height; metres of a strip with points on the plane
constexpr double kLeastGrowth = 0.5;       // Choice: a window and its pier are wider; metres
constexpr double kLongestPart = 4;         // Choice: about two bays; metres over which the density is taken as even
// Choice: eaves and corners are searched to so much beside the ends; gables end farther in.
constexpr double kNearEnd = 1.5;  // metres

std::int64_t cells_in(double metres) {
  return static_cast<std::int64_t>(std::ceil(std::max(metres, 0.0) / kGrowthCell)) + 1;
}

// The box of another wall in the axes of a wall, if it is along it: of its planes, or with its sparse parts.
std::optional<Box2> box_along(const WallGroup& wall, const WallGroup& other, const Box2& box,
                              const WallParams& params) {
  const double metres = params.metres_per_unit, turn = dot(wall.axes.out, other.axes.out);
  if (std::abs(turn) < cos_degrees(kTurnInRowDeg)) return std::nullopt;
  const Vec3 d = metres * (other.axes.origin - wall.axes.origin);
  if (std::abs(dot(d, wall.axes.out)) > params.relief_front) return std::nullopt;
  const double u = dot(d, wall.axes.right), v = dot(d, wall.axes.up);
  return Box2{turn > 0 ? u + box.u0 : u - box.u1, turn > 0 ? u + box.u1 : u - box.u0, v + box.v0, v + box.v1};
}

// Ends the room of a wall where another one along it begins.
void limit(const WallGroup& wall, const Box2& other, GrowthRoom& room) {
  if (std::min(other.u1, wall.width) - std::max(other.u0, 0.0) > kCommonByChance && other.v1 > wall.height)
    room.top = std::min(room.top, std::max(0.0, other.v0 - wall.height));
  if (std::min(other.v1, wall.height) - std::max(other.v0, 0.0) <= kCommonByChance) return;
  if (other.u1 > wall.width) room.right = std::min(room.right, std::max(0.0, other.u0 - wall.width));
  if (other.u0 < 0) room.left = std::min(room.left, std::max(0.0, -other.u1));
}

// Cuts the sparse parts of a wall where they lie on a box.
void give_way(const Box2& other, WallGroup& wall) {
  GrowthRoom room{INFINITY, INFINITY, INFINITY};
  limit(wall, other, room);
  Box2 whole{0, wall.width, 0, wall.height};
  for (SparsePart& p : wall.sparse) {
    if (!p.upright) {  // those above come last
      p.u0 = std::max(p.u0, whole.u0), p.u1 = std::min(p.u1, whole.u1);
      // A wall beside this one that is higher ends its upper part too.
      if (other.v0 < p.v1 && other.v1 > p.v0 && other.u0 >= wall.width - kCommonByChance)
        p.u1 = std::min(p.u1, wall.width);
      if (other.v0 < p.v1 && other.v1 > p.v0 && other.u1 <= kCommonByChance) p.u0 = std::max(p.u0, 0.0);
      p.v1 = std::min(p.v1, wall.height + room.top);
      continue;
    }
    p.u1 = std::min(p.u1, wall.width + room.right), p.u0 = std::max(p.u0, -room.left);
    if (p.u1 - p.u0 >= kLeastGrowth) whole.u0 = std::min(whole.u0, p.u0), whole.u1 = std::max(whole.u1, p.u1);
  }
  std::erase_if(wall.sparse,
                [](const SparsePart& p) { return p.u1 - p.u0 < kLeastGrowth || p.v1 - p.v0 < kLeastGrowth; });
}

}  // namespace

std::vector<GrowthRoom> growth_rooms(std::span<const WallGroup> walls, double reach, const WallParams& params) {
  std::vector<GrowthRoom> rooms(walls.size(), {reach, reach, reach});
  for_each_near_wall(walls, reach, params, [&](std::size_t i, std::size_t k) {
    const WallGroup& other = walls[k];
    if (const auto box = box_along(walls[i], other, {0, other.width, 0, other.height}, params))
      limit(walls[i], *box, rooms[i]);
  });
  return rooms;
}

Box2 grown_box(const WallGroup& wall) {
  Box2 box{0, wall.width, 0, wall.height};
  for (const SparsePart& p : wall.sparse)
    box = {std::min(box.u0, p.u0), std::max(box.u1, p.u1), std::min(box.v0, p.v0), std::max(box.v1, p.v1)};
  return box;
}

void share_growth(std::span<WallGroup> walls, double reach, const WallParams& params) {
  for_each_near_wall(walls, 2 * reach, params, [&](std::size_t i, std::size_t k) {
    if (walls[i].sparse.empty()) return;
    const Box2 own{0, walls[k].width, 0, walls[k].height};
    if (const auto box = box_along(walls[i], walls[k], k < i ? grown_box(walls[k]) : own, params))
      give_way(*box, walls[i]);
  });
}

double WallGrowth::depth(double epsilon) {
  return kMostDrift + (kBinsOfWall / 2 + kBinsBeside + 1) * epsilon / 2;
}

WallGrowth::WallGrowth(double width, double height, const GrowthRoom& room, double epsilon)
    : width_(width),
      height_(height),
      epsilon_(epsilon),
      left_(room.left),
      columns_(cells_in(room.left + width + room.right)),
      rows_(cells_in(height + room.top)),
      levels_(static_cast<std::int64_t>(4 * depth(epsilon) / epsilon) + 1),
      bins_(static_cast<std::size_t>(columns_ * rows_ * levels_)),
      low_u_(static_cast<std::size_t>(columns_), INFINITY),
      high_u_(static_cast<std::size_t>(columns_), -INFINITY),
      high_v_(static_cast<std::size_t>(rows_), -INFINITY) {}

std::uint64_t WallGrowth::bytes(double width, double height, const GrowthRoom& room, double epsilon) {
  const auto columns = static_cast<std::uint64_t>(cells_in(room.left + width + room.right));
  const auto rows = static_cast<std::uint64_t>(cells_in(height + room.top));
  const auto levels = static_cast<std::uint64_t>(4 * depth(epsilon) / epsilon) + 1;
  return columns * rows * levels * sizeof(std::uint32_t) + (2 * columns + rows) * sizeof(double);
}

void WallGrowth::add(const FacadePoint& p) {
  const double u = p.u, v = p.v, w = static_cast<double>(p.w) + depth(epsilon_);
  if (w < 0 || u < -left_ || v < 0) return;
  const auto c = static_cast<std::int64_t>((u + left_) / kGrowthCell);
  const auto r = static_cast<std::int64_t>(v / kGrowthCell);
  const auto level = static_cast<std::int64_t>(2 * w / epsilon_);
  if (c >= columns_ || r >= rows_ || level >= levels_) return;
  ++bins_[static_cast<std::size_t>((r * columns_ + c) * levels_ + level)];
  double &low = low_u_[static_cast<std::size_t>(c)], &high = high_u_[static_cast<std::size_t>(c)];
  low = std::min(low, u), high = std::max(high, u);
  high_v_[static_cast<std::size_t>(r)] = std::max(high_v_[static_cast<std::size_t>(r)], v);
}

// The distance of the wall from its plane, when its points begin in this bin.
double WallGrowth::distance(std::int64_t level) const {
  return static_cast<double>(level + kBinsOfWall / 2) * epsilon_ / 2 - depth(epsilon_);
}

// The strip with the bins that have the most points, near the given ones.
WallGrowth::Strip WallGrowth::strip_at(std::int64_t line, std::int64_t level, std::int64_t reach, const Span& across,
                                       bool upright) const {
  Strip best{line, level, -1};
  for (std::int64_t l = std::max(kBinsBeside, level - reach);
       l <= std::min(levels_ - kBinsOfWall - kBinsBeside, level + reach); ++l) {
    double on = 0;
    for (std::int64_t k = across.first; k <= across.last; ++k)
      for (std::int64_t b = l; b < l + kBinsOfWall; ++b) on += upright ? at(line, k, b) : at(k, line, b);
    if (on > best.on || (on == best.on && std::abs(l - level) < std::abs(best.level - level))) best = {line, l, on};
  }
  return best;
}

// Whether a column (upright) or a row of cells continues the wall, by its cells in `across`.
bool WallGrowth::continues(std::int64_t line, const Span& across, bool upright, Strip& strip) const {
  double on = 0, all = 0, covered = 0;
  std::int64_t first = across.last, last = across.first;
  for (std::int64_t k = across.first; k <= across.last; ++k) {
    double here = 0;
    for (std::int64_t b = strip.level - kBinsBeside; b < strip.level + kBinsOfWall + kBinsBeside; ++b) {
      const double n = upright ? at(line, k, b) : at(k, line, b);
      all += n;
      if (b >= strip.level && b < strip.level + kBinsOfWall) here += n;
    }
    on += here;
    if (here == 0) continue;
    covered += 1;
    first = std::min(first, k), last = k;
  }
  if (on < kMostOnPlane * all || on - kChance * all < kSureOfStrip * std::sqrt(kChance * (1 - kChance) * all))
    return false;
  const auto near_end = static_cast<std::int64_t>(kNearEnd / kGrowthCell);
  if (!upright && (first > across.first + near_end || last < across.last - near_end)) return false;  // a gable
  return covered * kGrowthCell >= kLeastStrip && covered >= kStripCovered * static_cast<double>(across.count());
}

// Follows the wall from its last strip outwards.
std::vector<WallGrowth::Strip> WallGrowth::grown(std::int64_t from, std::int64_t way, const Span& across,
                                                 bool upright) const {
  const auto between = static_cast<std::int64_t>(kMostBetween / kGrowthCell);
  const std::int64_t lines = upright ? columns_ : rows_;
  const auto plane = static_cast<std::int64_t>(2 * depth(epsilon_) / epsilon_) - kBinsOfWall / 2;
  std::vector<Strip> strips{strip_at(from, plane, kBinsOfWall / 2, across, upright)};
  std::int64_t turned = from;  // the last strip at which the distance changed
  for (std::int64_t k = from + way; k >= 0 && k < lines; k += way) {
    if (std::abs(k - strips.back().line) > 1 + between) break;
    const std::int64_t level = strips.back().level, reach = std::abs(k - turned) >= kStripsOfBow ? 1 : 0;
    Strip next = strip_at(k, level, reach, across, upright);
    if (!(next.on > 0) || !continues(k, across, upright, next)) continue;
    if (next.level != level) turned = k;
    strips.push_back(next);
  }
  return strips;
}

void WallGrowth::add_parts(double from, double to, const std::vector<Strip>& strips, const Span& across, bool upright,
                           const Box2& whole, std::vector<SparsePart>& parts) const {
  if (to - from < kLeastGrowth || strips.size() < 2) return;
  const double count = std::ceil((to - from) / kLongestPart), length = (to - from) / count;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double p0 = from + i * length, p1 = p0 + length, shift = upright ? left_ : 0;
    const auto low = static_cast<std::int64_t>((p0 + shift) / kGrowthCell);
    const auto high = static_cast<std::int64_t>((p1 + shift) / kGrowthCell);
    SparsePart part{upright ? p0 : whole.u0, upright ? p1 : whole.u1, upright ? whole.v0 : p0, upright ? whole.v1 : p1};
    double on = 0, first = INFINITY, last = -INFINITY;
    for (const Strip& s : strips) {
      if (s.line < low || s.line > high) continue;
      const auto place = static_cast<double>(s.line);
      on += s.on;
      if (place < first) first = place, part.w0 = distance(s.level);
      if (place > last) last = place, part.w1 = distance(s.level);
    }
    const double cells = static_cast<double>(across.count() * (high - low + 1));
    part.step = std::sqrt(cells * kGrowthCell * kGrowthCell / std::max(on, 1.0));
    part.upright = upright;
    parts.push_back(part);
  }
}

std::vector<SparsePart> WallGrowth::parts() const {
  const auto cell = [](double metres) { return static_cast<std::int64_t>(metres / kGrowthCell); };
  const Span rows{0, std::min(rows_ - 1, cell(height_))};
  const std::int64_t first = cell(left_) + 1;  // the first column and the last row that the wall fills
  const std::int64_t last = std::max(first, cell(left_ + width_) - 1);
  const std::vector<Strip> right = grown(last, 1, rows, true), left = grown(first, -1, rows, true);
  const Span columns{left.back().line, right.back().line};
  const std::vector<Strip> top = grown(std::max<std::int64_t>(0, cell(height_) - 1), 1, columns, false);
  Box2 whole{0, width_, 0, height_};
  std::vector<SparsePart> parts;
  if (right.size() > 1) whole.u1 = std::max(width_, high_u_[static_cast<std::size_t>(columns.last)]);
  if (left.size() > 1) whole.u0 = std::min(0.0, low_u_[static_cast<std::size_t>(columns.first)]);
  add_parts(width_, whole.u1, right, rows, true, whole, parts);
  add_parts(whole.u0, 0, left, rows, true, whole, parts);
  if (top.size() > 1)
    add_parts(height_, std::max(height_, high_v_[static_cast<std::size_t>(top.back().line)]), top, columns, false,
              whole, parts);
  return parts;
}

}  // namespace ilot
