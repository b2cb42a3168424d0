// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/wall_outline.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/products/facades/walls/top_lines.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: a bound of time; walls of more than 40 m get wider columns.
constexpr double kMostColumns = 400;  // columns of the profile in which lines are searched
// Derived: a boundary is known to one step on either side.
constexpr double kSteps = 2;  // steps between boundaries and their lines, at most
// Choice: a tree may cover a fifth of the sky above an edge; under more of it the edge is not drawn as seen.
constexpr double kFree = 0.2;  // share of the place above an edge in which other parts may stand
// Choice: five steps of 2 cm; time and detail of what is above an edge.
constexpr double kCell = 0.1;  // metres; cell of that place
// Derived: a majority; chimneys and what stands behind take less.
constexpr double kWallGoesOn = 0.5;  // share of the columns above an edge in which there are points of the wall
// Choice: the thickness of a roof, whose points lie in the plane of the gable below it.
constexpr double kVergeAbove = 0.3;  // metres above an edge in which points say nothing of the wall
// Choice: twice the largest cell of openings; sparse parts of walls have points in each.
constexpr double kCoarse = 0.3;  // metres; width of these columns
// Choice: one point may be a stray one.
constexpr int kFewestAbove = 2;  // points of the wall in such a column
// Derived: as where walls are followed to their sparse ends (wall_growth.h).
constexpr double kBow = 3;  // epsilons by which a wall may be off its plane
// Choice: lower ends are gables whose eaves are at the foot; they are drawn as a triangle.
constexpr double kLeastSide = 0.3;  // metres; least height of the ends of the wall
// Choice: as long as the shadow of a lamp; shorter ones are chance.
constexpr double kLeastShadow = 0.3;  // metres of an edge without rings; shorter parts are chance
// Derived: even steps leave gaps of one, a lost ray of two.
constexpr double kStepsOfShadow = 3;

// An edge of the top from u0 to u1.
struct TopEdge {
  TopLine line;
  double u0 = 0, u1 = 0;
  double error = 0, rms = 0;
  bool known = false;  // a line of the profile; otherwise nothing was seen there
};

struct Wall {
  const FacadeSite& site;
  double cell, tolerance;
  std::vector<double> fine;  // profile in half steps
  double fine_cell;

  double top() const { return site.height; }
};

Wall wall_of(const FacadeSite& site) {
  Wall wall{site, std::max(kSteps * site.step, site.width / kMostColumns), kSteps * site.step + site.epsilon, {}, 0};
  const double count = std::ceil(site.width / std::max(site.step / 2, site.width / 1e5));
  wall.fine_cell = site.width / count;
  wall.fine = ring_profile(site.rings, ProfileOf::columns, 1, 0, wall.fine_cell, static_cast<std::size_t>(count));
  return wall;
}

bool is_parallel(const FacadeSite& site, std::uint32_t plane) {
  return std::binary_search(site.parallel.begin(), site.parallel.end(), ParallelPlane{plane, 0},
                            [](const ParallelPlane& a, const ParallelPlane& b) { return a.id < b.id; });
}

// The share of the area between the line and the top of the wall in front of which there are points before the wall or
// along it.
double share_filled(const RaySamples& samples, const TopEdge& edge, double relief) {
  const FacadeSite& site = samples.site();
  const double bottom = std::min(edge.line.height(edge.u0), edge.line.height(edge.u1));
  const auto columns = static_cast<std::int64_t>(std::ceil((edge.u1 - edge.u0) / kCell));
  const auto rows = static_cast<std::int64_t>(std::ceil((site.height - bottom) / kCell));
  if (columns <= 0 || rows <= 0) return 0;
  std::vector<std::uint8_t> filled(static_cast<std::size_t>(columns * rows), 0);
  for (const Ray& ray : samples.at_places({edge.u0, edge.u1, bottom, site.height})) {
    const FacadePoint& p = ray.at;
    if (p.u < edge.u0 || p.u >= edge.u1 || p.v >= site.height || p.w > relief) continue;
    if (p.v < edge.line.height(p.u) + kCell || !(p.w > site.epsilon || is_parallel(site, p.plane))) continue;
    const auto c = static_cast<std::int64_t>((p.u - edge.u0) / kCell);
    const auto r = static_cast<std::int64_t>((p.v - bottom) / kCell);
    if (c < columns && r >= 0 && r < rows) filled[static_cast<std::size_t>(r * columns + c)] = 1;
  }
  double above = 0, of_these = 0;
  for (std::int64_t r = 0; r < rows; ++r)
    for (std::int64_t c = 0; c < columns; ++c) {
      const double u = edge.u0 + (static_cast<double>(c) + 0.5) * kCell;
      if (bottom + (static_cast<double>(r) + 0.5) * kCell < edge.line.height(u)) continue;
      above += 1;
      of_these += filled[static_cast<std::size_t>(r * columns + c)];
    }
  return above > 0 ? of_these / above : 0;
}

// Whether the wall goes on above an edge: its points lie above most of it. The boundary of a plane ends where points
// become too sparse for it, and what hides the wall cuts into it.
bool goes_on_above(const RaySamples& samples, const TopEdge& edge) {
  const FacadeSite& site = samples.site();
  const auto height = [&](double u) { return edge.line.height(u) + kVergeAbove; };
  std::vector<int> above(static_cast<std::size_t>(std::ceil((edge.u1 - edge.u0) / kCoarse)), 0);
  for (const Ray& ray :
       samples.at_places({edge.u0, edge.u1, std::min(height(edge.u0), height(edge.u1)), site.height})) {
    const FacadePoint& p = ray.at;
    if (p.u < edge.u0 || p.u >= edge.u1 || p.v < height(p.u) || p.v > site.height) continue;
    if (!samples.on_wall(ray) && (std::abs(p.w) > kBow * site.epsilon || is_parallel(site, p.plane))) continue;
    ++above[static_cast<std::size_t>((p.u - edge.u0) / kCoarse)];
  }
  int room = 0, filled = 0;
  for (std::size_t i = 0; i < above.size(); ++i) {
    const double u = edge.u0 + (static_cast<double>(i) + 0.5) * kCoarse;
    if (site.height - height(u) < kCoarse) continue;
    ++room;
    filled += above[i] >= kFewestAbove;
  }
  return filled > kWallGoesOn * room;
}

double squared(double a) {
  return a * a;
}

// The distance of neighbouring points across a line of this slope.
double step_across(const RaySamples& samples, const TopEdge& edge) {
  const double u = 0.5 * (edge.u0 + edge.u1);
  const Place2 step = samples.step_at({u, edge.line.height(u)});
  const double stretch = std::sqrt(1 + squared(edge.line.slope));
  return std::max(step.u * std::abs(edge.line.slope), step.v) / stretch;
}

// Fits a line by total least squares to the profile beside it, twice. Then moves it outwards, because boundaries lie
// inside of an edge.
void fit(const RaySamples& samples, const Wall& wall, TopEdge& edge) {
  double within = wall.tolerance;
  for (int round = 0; round < 2; ++round) {
    const double stretch = std::sqrt(1 + squared(edge.line.slope));
    double n = 0, su = 0, sv = 0, uu = 0, uv = 0, vv = 0;
    const double mu = 0.5 * (edge.u0 + edge.u1), mv = edge.line.height(mu);
    for (std::size_t i = 0; i < wall.fine.size(); ++i) {
      const double u = (static_cast<double>(i) + 0.5) * wall.fine_cell;
      if (u < edge.u0 || u > edge.u1 || std::abs(wall.fine[i] - edge.line.height(u)) > within * stretch) continue;
      const double du = u - mu, dv = wall.fine[i] - mv;
      n += 1, su += du, sv += dv, uu += du * du, uv += du * dv, vv += dv * dv;
    }
    if (n < 3) return;
    uu -= su * su / n, uv -= su * sv / n, vv -= sv * sv / n;
    const double spread = std::sqrt(squared(uu - vv) + 4 * uv * uv);
    if (!edge.line.level() && uv != 0) edge.line.slope = 2 * uv / (uu - vv + spread);
    edge.line.at = mv + sv / n - edge.line.slope * (mu + su / n);
    edge.rms =
        edge.line.level() ? std::sqrt(std::max(0.0, vv / n)) : std::sqrt(std::max(0.0, (uu + vv - spread) / 2 / n));
    edge.error = 2 * edge.rms / std::sqrt(std::max(1.0, n * wall.fine_cell / wall.site.step));
    within = std::max(3 * edge.rms, wall.site.step / 2);
  }
  const double half_step = 0.5 * step_across(samples, edge);
  edge.line.at += std::min(half_step, std::sqrt(3.0) * edge.rms) * std::sqrt(1 + squared(edge.line.slope));
  edge.error += half_step;
}

// The edges that the top follows. Edges near the height of the wall get this height.
std::vector<TopEdge> edges_of(const RaySamples& samples, const Wall& wall, const WallOutlineParams& params) {
  const FacadeSite& site = wall.site;
  const auto count = static_cast<std::size_t>(site.width / wall.cell);
  const std::vector<double> profile = ring_profile(site.rings, ProfileOf::columns, 1, 0, wall.cell, count);
  TopLineParams lines;
  lines.tolerance = wall.tolerance;
  lines.least_length = params.least_length;
  std::vector<TopEdge> edges;
  for (const TopLine& line : top_lines(profile, wall.cell, lines)) {
    TopEdge edge{line, static_cast<double>(line.first) * wall.cell, static_cast<double>(line.last + 1) * wall.cell};
    edge.known = true;
    if (line.level() && line.at > wall.top() - params.least_step) {
      edge.line.at = wall.top();
      edge.error = site.step;
    } else {
      if (share_filled(samples, edge, params.relief) > kFree || goes_on_above(samples, edge)) continue;
      fit(samples, wall, edge);
    }
    edges.push_back(edge);
  }
  return edges;
}

bool at_top(const TopEdge& edge, const Wall& wall) {
  return edge.line.level() && edge.line.at == wall.top();
}

// Drops level edges between higher ones: these are gaps and no steps.
void drop_gaps(std::vector<TopEdge>& edges, const Wall& wall) {
  const auto higher_beside = [&](std::size_t i, int way) {
    const double own = edges[i].line.at;
    for (auto k = static_cast<std::ptrdiff_t>(i) + way; k >= 0 && k < static_cast<std::ptrdiff_t>(edges.size());
         k += way) {
      const TopEdge& e = edges[static_cast<std::size_t>(k)];
      if (std::max(e.line.height(e.u0), e.line.height(e.u1)) > own + wall.tolerance) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < edges.size();) {
    const bool gap = edges[i].line.level() && !at_top(edges[i], wall) && higher_beside(i, -1) && higher_beside(i, 1);
    if (gap)
      edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

// A stretch of which no line is known. It is as high as an edge beside it, the lower one first, where the wall is not
// seen to go on above that and nothing hides it there; otherwise as high as the top of the wall.
TopEdge unknown_top(const RaySamples& samples, const Wall& wall, double u0, double u1, std::vector<double> beside,
                    double relief) {
  TopEdge edge;
  edge.u0 = u0, edge.u1 = u1;
  edge.error = wall.site.step;
  std::sort(beside.begin(), beside.end());
  for (const double height : beside) {
    edge.line.at = height;
    if (height < wall.top() - kVergeAbove && !goes_on_above(samples, edge) &&
        share_filled(samples, edge, relief) <= kFree)
      return edge;
  }
  edge.line.at = wall.top();
  return edge;
}

// The place where two edges meet, in the gap between them or close to it.
std::optional<double> meeting_of(const TopEdge& a, const TopEdge& b, double slack) {
  const double turn = a.line.slope - b.line.slope;
  if (turn == 0) return std::nullopt;
  const double u = (b.line.at - a.line.at) / turn;
  if (u < a.u1 - slack || u > b.u0 + slack) return std::nullopt;
  return u;
}

// Makes the edges cover the top from end to end without gaps. An edge is extended to where it meets the next one, to an
// upright step, or to a part at the top of the wall of which nothing is known.
std::vector<TopEdge> without_gaps(const RaySamples& samples, const std::vector<TopEdge>& edges, const Wall& wall,
                                  const WallOutlineParams& params) {
  const double slack = 4 * wall.cell;
  std::vector<TopEdge> closed;
  const auto take = [&](TopEdge edge) {
    if (!closed.empty() && at_top(closed.back(), wall) && at_top(edge, wall)) {
      closed.back().u1 = edge.u1;
      closed.back().known = closed.back().known || edge.known;
      return;
    }
    closed.push_back(edge);
  };
  double end = 0;
  for (const TopEdge& edge : edges) {
    const bool meets = !closed.empty() && meeting_of(closed.back(), edge, slack);
    std::vector<double> beside{edge.line.height(edge.u0)};
    if (!closed.empty() && closed.back().known) beside.push_back(closed.back().line.height(end));
    if (!meets && edge.u0 - end > params.least_length)
      take(unknown_top(samples, wall, end, edge.u0, beside, params.relief));
    take(edge);
    end = edge.u1;
  }
  if (wall.site.width - end > params.least_length || closed.empty()) {
    std::vector<double> beside;
    if (!closed.empty() && closed.back().known) beside.push_back(closed.back().line.height(end));
    take(unknown_top(samples, wall, end, wall.site.width, beside, params.relief));
  }
  for (std::size_t i = 0; i + 1 < closed.size(); ++i) {
    const double between = 0.5 * (closed[i].u1 + closed[i + 1].u0);
    const double corner = meeting_of(closed[i], closed[i + 1], slack).value_or(between);
    closed[i].u1 = closed[i + 1].u0 = corner;
  }
  closed.front().u0 = 0, closed.back().u1 = wall.site.width;
  return closed;
}

// The place of the upright side between two edges: the rows between them end there.
double side_between(const Wall& wall, const TopEdge& a, const TopEdge& b, double& error) {
  const double u = a.u1, va = a.line.height(u), vb = b.line.height(u);
  const bool rises = vb > va;  // the wall is on its right
  const double low = std::min(va, vb) + wall.tolerance, high = std::max(va, vb) - wall.tolerance;
  const auto count = static_cast<std::size_t>(std::max(0.0, (high - low) / wall.fine_cell));
  // Choice: cornices end within it; broader ones hide the end of the rows.
  constexpr double kReach = 0.5;  // metres beside the place in which the rows may end
  const auto ends = ring_profile(wall.site.rings, ProfileOf::rows, rises ? -1 : 1, low, wall.fine_cell, count);
  std::vector<double> at;
  for (const double e : ends)
    if (const double place = rises ? -e : e; std::abs(place - u) <= kReach) at.push_back(place);
  if (at.size() < 3) {
    error = std::max(wall.cell, 0.5 * std::abs(b.u0 - a.u1));
    return u;
  }
  error = wall.site.step;
  return upper_median(at) + (rises ? -1 : 1) * 0.25 * wall.site.step;
}

void add_corner(WallOutline& outline, Place2 at, const FacadeEdge& edge) {
  outline.ring.push_back(at);
  outline.edges.push_back(edge);
}

// Adds the edge from right to left, divided into parts that were seen and parts that were not. Its last corner is the
// first corner of the next edge.
void add_stretches(WallOutline& outline, const Wall& wall, const TopEdge& edge) {
  FacadeEdge seen;
  seen.error_m = edge.error, seen.rms_m = edge.rms;
  seen.status = edge.known ? DrawnStatus::seen : DrawnStatus::occluded;
  FacadeEdge hidden = seen;
  hidden.status = DrawnStatus::occluded;
  const auto place = [&](double u) { return Place2{u, edge.line.height(u)}; };
  if (edge.line.level()) return add_corner(outline, place(edge.u1), seen);
  const double stretch = std::sqrt(1 + squared(edge.line.slope));
  const double shadow = std::max(kLeastShadow, kStepsOfShadow * wall.site.step);
  double last = edge.u1;  // end of the part that was seen
  double from = edge.u1;  // begin of the current part
  for (std::size_t k = wall.fine.size(); k-- > 0;) {
    const double u = (static_cast<double>(k) + 0.5) * wall.fine_cell;
    if (u > edge.u1) continue;
    const bool ends = u < edge.u0;
    if (!ends && !(std::abs(wall.fine[k] - edge.line.height(u)) <= wall.tolerance * stretch)) continue;
    if ((last - std::max(u, edge.u0)) * stretch > shadow) {
      if (from > last) add_corner(outline, place(from), seen);
      add_corner(outline, place(last), hidden);
      from = std::max(u, edge.u0);
    }
    last = u;
    if (ends) break;
  }
  if (from > edge.u0) add_corner(outline, place(from), seen);
}

WallOutline rectangle_of(const FacadeSite& site) {
  return {{{0, 0}, {site.width, 0}, {site.width, site.height}, {0, site.height}}, {}};
}

WallOutline polygon_of(const Wall& wall, std::vector<TopEdge>& edges) {
  WallOutline outline;
  FacadeEdge plain;
  plain.error_m = wall.site.step;
  add_corner(outline, {0, 0}, plain);
  add_corner(outline, {wall.site.width, 0}, plain);
  std::vector<double> errors(edges.size(), 0);
  // Derived: above the rounding of doubles at 1 km, far below a step.
  constexpr double kSame = 1e-6;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double u = edges[i].u1;
    if (std::abs(edges[i].line.height(u) - edges[i + 1].line.height(u)) < kSame) continue;
    edges[i].u1 = edges[i + 1].u0 = side_between(wall, edges[i], edges[i + 1], errors[i]);
  }
  if (std::any_of(edges.begin(), edges.end(), [](const TopEdge& e) { return !(e.u1 > e.u0); }))
    return rectangle_of(wall.site);
  for (std::size_t i = edges.size(); i-- > 0;) {
    add_stretches(outline, wall, edges[i]);
    const bool step =
        i > 0 && std::abs(edges[i].line.height(edges[i].u0) - edges[i - 1].line.height(edges[i].u0)) >= kSame;
    if (step) {
      FacadeEdge side;
      side.error_m = errors[i - 1];
      add_corner(outline, {edges[i].u0, edges[i].line.height(edges[i].u0)}, side);
    }
  }
  add_corner(outline, {0, edges[0].line.height(0)}, plain);
  return outline;
}

}  // namespace

WallOutline wall_outline(const RaySamples& samples, const WallOutlineParams& params) {
  const FacadeSite& site = samples.site();
  if (site.rings.empty() || !(site.width > params.least_length)) return rectangle_of(site);
  const Wall wall = wall_of(site);
  std::vector<TopEdge> edges = edges_of(samples, wall, params);
  drop_gaps(edges, wall);
  edges = without_gaps(samples, edges, wall, params);
  if (std::all_of(edges.begin(), edges.end(), [&](const TopEdge& e) { return at_top(e, wall); }))
    return rectangle_of(site);
  if (edges.front().line.height(0) < kLeastSide || edges.back().line.height(site.width) < kLeastSide)
    return rectangle_of(site);
  return polygon_of(wall, edges);
}

}  // namespace ilot
