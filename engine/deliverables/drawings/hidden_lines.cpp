// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/hidden_lines.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

// Choice: the rounding of levels and sizes on a drawing; edges that meet lie nearer together.
constexpr double kBeside = 0.001;  // metres
// Choice: pieces of a line that are shorter cannot be told apart on paper.
constexpr double kShortest = 1e-4;  // metres

double distance_to(FlatPoint p, FlatPoint a, FlatPoint b) {
  const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
  const double t = length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0;
  const double ex = p.x - a.x - t * dx, ey = p.y - a.y - t * dy;
  return std::sqrt(ex * ex + ey * ey);
}

enum class Where { inside, border, outside };

Where place_in(const Cover& cover, FlatPoint p) {
  if (!cover.box.grown(kBeside).contains(FlatBox{p, p})) return Where::outside;
  bool inside = false;
  const std::size_t n = cover.ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const FlatPoint a = cover.ring[i], b = cover.ring[(i + 1) % n];
    if (distance_to(p, a, b) <= kBeside) return Where::border;
    inside ^= ray_crosses_by_share(p, a, b);
  }
  return inside ? Where::inside : Where::outside;
}

// One stretch of a line: straight, or an arc about a centre.
class Stretch {
 public:
  Stretch(const DrawingCorner& from, const DrawingCorner& to) : a_{from.x, from.y}, b_{to.x, to.y} {
    if (from.bulge == 0) return;
    constexpr double kQuarters = 4;
    sweep_deg_ = kQuarters * direction_degrees(1, std::abs(from.bulge)) * (from.bulge < 0 ? -1 : 1);
    const double k = (1 - from.bulge * from.bulge) / (4 * from.bulge);
    centre_ = {(a_.x + b_.x) / 2 - k * (b_.y - a_.y), (a_.y + b_.y) / 2 + k * (b_.x - a_.x)};
    start_deg_ = direction_degrees(a_.x - centre_.x, a_.y - centre_.y);
    radius_ = std::sqrt((a_.x - centre_.x) * (a_.x - centre_.x) + (a_.y - centre_.y) * (a_.y - centre_.y));
  }
  FlatPoint at(double t) const {
    if (t <= 0) return a_;
    if (t >= 1) return b_;
    if (sweep_deg_ == 0) return {a_.x + t * (b_.x - a_.x), a_.y + t * (b_.y - a_.y)};
    const double degrees = start_deg_ + t * sweep_deg_;
    return {centre_.x + radius_ * cos_degrees(degrees), centre_.y + radius_ * cos_degrees(degrees - 90)};
  }
  double bulge_of(double share) const {
    const double angle = share * sweep_deg_;
    return sweep_deg_ == 0 ? 0 : cos_degrees(angle / 4 - 90) / cos_degrees(angle / 4);
  }
  double length() const { return std::sqrt((b_.x - a_.x) * (b_.x - a_.x) + (b_.y - a_.y) * (b_.y - a_.y)); }
  // Adds the shares of the stretch at which it crosses the line from p to q.
  void cross(FlatPoint p, FlatPoint q, std::vector<double>& shares) const {
    sweep_deg_ == 0 ? cross_straight(p, q, shares) : cross_arc(p, q, shares);
  }

 private:
  void cross_straight(FlatPoint p, FlatPoint q, std::vector<double>& shares) const {
    const double ux = b_.x - a_.x, uy = b_.y - a_.y, vx = q.x - p.x, vy = q.y - p.y, turn = ux * vy - uy * vx;
    if (turn == 0) return;
    const double t = ((p.x - a_.x) * vy - (p.y - a_.y) * vx) / turn, s = ((p.x - a_.x) * uy - (p.y - a_.y) * ux) / turn;
    if (t > 0 && t < 1 && s >= 0 && s <= 1) shares.push_back(t);
  }
  void cross_arc(FlatPoint p, FlatPoint q, std::vector<double>& shares) const {
    const double dx = q.x - p.x, dy = q.y - p.y, ex = p.x - centre_.x, ey = p.y - centre_.y;
    const double a = dx * dx + dy * dy, b = ex * dx + ey * dy, c = ex * ex + ey * ey - radius_ * radius_;
    const double root = b * b - a * c;
    if (a == 0 || root < 0) return;
    for (const double sign : {-1.0, 1.0}) {
      const double s = (-b + sign * std::sqrt(root)) / a;
      if (s < 0 || s > 1) continue;
      double turn = direction_degrees(ex + s * dx, ey + s * dy) - start_deg_;
      if (sweep_deg_ < 0) turn = -turn;
      while (turn < 0) turn += 360;
      while (turn >= 360) turn -= 360;
      const double t = turn / std::abs(sweep_deg_);
      if (t > 0 && t < 1) shares.push_back(t);
    }
  }
  FlatPoint a_, b_, centre_;
  double start_deg_ = 0, sweep_deg_ = 0, radius_ = 0;
};

struct Piece {
  DrawingCorner from;
  FlatPoint to;
  bool hidden = false;
};

std::vector<Piece> pieces_of(const DrawingLine& line, std::span<const Cover> covers) {
  std::vector<Piece> pieces;
  const std::size_t n = line.corners.size();
  for (std::size_t i = 0; i + 1 < n + line.closed; ++i) {
    const Stretch stretch(line.corners[i], line.corners[(i + 1) % n]);
    std::vector<double> shares{0, 1};
    for (const Cover& cover : covers)
      for (std::size_t k = 0; k < cover.ring.size(); ++k)
        stretch.cross(cover.ring[k], cover.ring[(k + 1) % cover.ring.size()], shares);
    std::sort(shares.begin(), shares.end());
    double from = 0;
    for (const double to : shares) {
      const bool last = to == 1;
      if ((to - from) * stretch.length() < kShortest && !(last && from == 0)) continue;
      const FlatPoint a = stretch.at(from), middle = stretch.at((from + to) / 2);
      const bool hidden = std::any_of(covers.begin(), covers.end(),
                                      [&](const Cover& cover) { return place_in(cover, middle) == Where::inside; });
      pieces.push_back({{a.x, a.y, stretch.bulge_of(to - from)}, stretch.at(to), hidden});
      from = to;
      if (last) break;
    }
  }
  return pieces;
}

void add_chains(const DrawingLine& line, const std::vector<Piece>& pieces, std::vector<DrawingLine>& lines) {
  const std::size_t n = pieces.size();
  std::size_t start = 0;
  if (line.closed)
    while (start < n && pieces[start].hidden == pieces[(start + n - 1) % n].hidden) ++start;
  for (std::size_t k = 0; k < n;) {
    const bool hidden = pieces[(start + k) % n].hidden;
    DrawingLine chain{hidden ? DrawingRole::hidden : line.role, {}, false, line.is_sample};
    FlatPoint end;
    for (; k < n && pieces[(start + k) % n].hidden == hidden; ++k) {
      chain.corners.push_back(pieces[(start + k) % n].from);
      end = pieces[(start + k) % n].to;
    }
    chain.corners.push_back({end.x, end.y, 0});
    lines.push_back(std::move(chain));
  }
}

}  // namespace

void hide_lines(std::span<const Cover> covers, std::vector<DrawingLine>& lines) {
  if (covers.empty()) return;
  std::vector<DrawingLine> cut;
  for (const DrawingLine& line : lines) {
    const std::vector<Piece> pieces = pieces_of(line, covers);
    const auto hidden = std::count_if(pieces.begin(), pieces.end(), [](const Piece& p) { return p.hidden; });
    if (hidden > 0 && static_cast<std::size_t>(hidden) < pieces.size()) {
      add_chains(line, pieces, cut);
      continue;
    }
    cut.push_back(line);
    if (hidden > 0) cut.back().role = DrawingRole::hidden;
  }
  lines = std::move(cut);
}

bool holds_all(const Cover& cover, std::span<const FlatPoint> places) {
  return std::none_of(places.begin(), places.end(), [&](FlatPoint p) { return place_in(cover, p) == Where::outside; });
}

}  // namespace ilot
