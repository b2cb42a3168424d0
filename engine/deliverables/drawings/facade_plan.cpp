// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "kernels/core/portable_math.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

constexpr double kSamePlace = 1e-5;  // metres
constexpr double kOnArc = 0.005;     // metres: a tenth of a millimetre on paper at 1:50
constexpr double kBesideArcDeg = 1;  // beyond the ends of an arc
constexpr double kWidestBulgeDeg = 190;
constexpr double kChordDeg = 5;
constexpr double kHatchMm = 2.5;      // between lines, on paper
constexpr int kMostHatchLines = 400;  // of one element; for more lines the distance is increased
constexpr double kLargest = 1e6;      // metres; a larger value does not come from a facade
constexpr double kLongestCorner = 4;  // of a widened ring, in errors

FlatPoint place_of(const DrawingCorner& c) {
  return {c.x, c.y};
}

double turned(double degrees) {
  while (degrees < 0) degrees += 360;
  while (degrees >= 360) degrees -= 360;
  return degrees;
}

struct FlatArc {
  FlatPoint centre;
  double radius = 0, from_deg = 0, span_deg = 0;
};

FlatArc flat_arc(const Facade& facade, const FacadeArc& arc, double metres_per_unit) {
  const double span = turned(std::fmod(arc.to_deg, 360) - std::fmod(arc.from_deg, 360));
  return {flat_place(facade, arc.centre, metres_per_unit), metres_per_unit * arc.radius_m,
          turned(std::fmod(arc.from_deg, 360)), span == 0 ? 360 : span};
}

// Returns the angle from the start of the arc, counter-clockwise. It is negative for places just before the start.
double along(const FlatArc& arc, FlatPoint p) {
  const double degrees = turned(direction_degrees(p.x - arc.centre.x, p.y - arc.centre.y) - arc.from_deg);
  return degrees > 360 - kBesideArcDeg ? degrees - 360 : degrees;
}

bool lies_on(const FlatArc& arc, FlatPoint p) {
  return std::abs(distance(arc.centre, p) - arc.radius) <= kOnArc && along(arc, p) <= arc.span_deg + kBesideArcDeg;
}

// Returns the angle of each edge on the arc: negative when clockwise, 0 when the edge is not on the arc. An edge that
// closes the arc, such as the flat base of a lunette, has its ends on the arc too. It runs in the opposite direction to
// the edges along the arc, which are more numerous.
std::vector<double> angles_on(const FlatArc& arc, const std::vector<DrawingCorner>& corners) {
  const std::size_t n = corners.size();
  std::vector<double> angles(n, 0);
  std::size_t left = 0, right = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const FlatPoint a = place_of(corners[i]), b = place_of(corners[(i + 1) % n]);
    if (corners[i].bulge != 0 || !lies_on(arc, a) || !lies_on(arc, b)) continue;
    angles[i] = along(arc, b) - along(arc, a);
    if (arc.span_deg >= 360) angles[i] = turned(angles[i] + 180) - 180;
    left += angles[i] > 0;
    right += angles[i] < 0;
  }
  for (double& angle : angles)
    if (right > left ? angle > 0 : angle < 0) angle = 0;
  return angles;
}

// Returns the tangent of a quarter of the angle of the stretch. The radius and the chord determine it too, but for a
// half circle not to the centimetre when the corners are a millimetre off it.
double bulge_of(FlatPoint from, FlatPoint to, double angle_deg) {
  if (distance(from, to) / 2 < kSamePlace) return 0;
  return cos_degrees(angle_deg / 2 - 90) / (1 + cos_degrees(angle_deg / 2));
}

FacadeEdge larger(const FacadeEdge& a, const FacadeEdge& b) {
  return {a.status,
          a.points + b.points,
          std::max(a.rms_m, b.rms_m),
          std::max(a.error_m, b.error_m),
          std::max(a.moved_m, b.moved_m),
          std::max(a.occluded_share, b.occluded_share),
          std::min(a.covered_share, b.covered_share)};
}

// Joins stretches of the ring that are on the arc. False when there are none.
bool join_on_arc(const FlatArc& arc, std::vector<DrawingCorner>& corners, std::vector<FacadeEdge>& edges) {
  const std::size_t n = corners.size();
  const std::vector<double> angle = angles_on(arc, corners);
  const auto start_at = std::find(angle.begin(), angle.end(), 0);  // a place where no stretch continues
  if (std::all_of(angle.begin(), angle.end(), [](double a) { return a == 0; })) return false;
  const auto start = start_at == angle.end() ? 0 : static_cast<std::size_t>(start_at - angle.begin());
  std::vector<DrawingCorner> joined;
  std::vector<FacadeEdge> kept;
  for (std::size_t k = 0; k < n;) {
    const std::size_t first = (start + k) % n;
    DrawingCorner corner = corners[first];
    FacadeEdge edge = edges[first];
    double sum = angle[first];
    std::size_t length = 1;
    for (; angle[first] != 0 && k + length < n; ++length) {
      const std::size_t next = (first + length) % n;
      const bool goes_on =
          angle[next] * sum > 0 && edges[next].status == edge.status && std::abs(sum + angle[next]) <= kWidestBulgeDeg;
      if (!goes_on) break;
      sum += angle[next];
      edge = larger(edge, edges[next]);
    }
    if (sum != 0) corner.bulge = bulge_of(place_of(corner), place_of(corners[(first + length) % n]), sum);
    joined.push_back(corner);
    kept.push_back(edge);
    k += length;
  }
  corners = std::move(joined);
  edges = std::move(kept);
  return true;
}

double doubled_area_of(const std::vector<DrawingCorner>& ring) {
  return doubled_area<double>(ring.size(), [&](std::size_t i) { return place_of(ring[i]); });
}

FlatBox box_of(const std::vector<FlatPoint>& points) {
  FlatBox box = FlatBox::none();
  for (const FlatPoint& p : points) box.add(p);
  return box.is_empty() ? FlatBox{} : box;
}

// Draws runs of edges with one status, from the place where the status changes.
void draw_chains(const FlatElement& flat, DrawingRole role, Drawing& drawing) {
  const std::size_t n = flat.corners.size();
  std::size_t start = 0;
  while (start < n && flat.edges[start].status == flat.edges[(start + n - 1) % n].status) ++start;
  for (std::size_t k = 0; k < n;) {
    const std::size_t first = (start + k) % n;
    const DrawnStatus status = flat.edges[first].status;
    DrawingLine line{status == DrawnStatus::completed  ? DrawingRole::completed
                     : status == DrawnStatus::occluded ? DrawingRole::occluded
                                                       : role,
                     {},
                     start == n};
    for (; k < n && flat.edges[(start + k) % n].status == status; ++k)
      line.corners.push_back(flat.corners[(start + k) % n]);
    if (!line.closed) {
      line.corners.push_back(flat.corners[(start + k) % n]);
      line.corners.back().bulge = 0;
    }
    drawing.lines.push_back(std::move(line));
  }
}

// Draws lines at 45 degrees within the ring, alternately from where a line enters it to where it leaves it.
void hatch(const std::vector<FlatPoint>& ring, Drawing& drawing) {
  const auto across = [](FlatPoint p) { return p.y - p.x; };
  double low = across(ring[0]), high = low;
  for (const FlatPoint& p : ring) {
    low = std::min(low, across(p));
    high = std::max(high, across(p));
  }
  const double step = std::max(drawing.paper_mm(kHatchMm) * std::sqrt(2.0), (high - low) / kMostHatchLines);
  if (!(high - low < kLargest)) return;
  const double first = std::ceil(low / step) * step;
  for (int k = 0; k <= kMostHatchLines && first + k * step <= high; ++k) {
    const double c = first + k * step;
    std::vector<double> crossings;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      if ((across(a) < c) == (across(b) < c)) continue;
      crossings.push_back(a.x + (b.x - a.x) * (c - across(a)) / (across(b) - across(a)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      drawing.lines.push_back(
          {DrawingRole::shadow, {{crossings[i], crossings[i] + c}, {crossings[i + 1], crossings[i + 1] + c}}, false});
  }
}

// A corner and its error; arcs are chords.
struct ErrorCorner {
  FlatPoint place;
  double error = 0;  // of the edge to the next corner
};

template <class Take>
void for_each_chord(const FlatElement& element, Take take) {
  const std::size_t n = element.corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const DrawingCorner &a = element.corners[i], &b = element.corners[(i + 1) % n];
    take(place_of(a), i);
    if (a.bulge == 0) continue;
    // Adds points of the arc by repeated halving. The bulge of half an arc is t / (1 + sqrt(1 + t2)).
    const auto split = [&](auto&& self, FlatPoint p, FlatPoint q, double bulge) -> void {
      constexpr double kChordBulge = 0.0218;  // tangent of a quarter of kChordDeg
      static_assert(kChordDeg == 5);
      if (!(std::abs(bulge) > kChordBulge)) return;
      const FlatPoint top{(p.x + q.x + bulge * (q.y - p.y)) / 2, (p.y + q.y - bulge * (q.x - p.x)) / 2};
      const double half = bulge / (1 + std::sqrt(1 + bulge * bulge));
      self(self, p, top, half);
      take(top, i);
      self(self, top, q, half);
    };
    split(split, place_of(a), place_of(b), a.bulge);
  }
}

// Returns the place where the edges before and after a corner meet after they are moved outwards. The ring is
// counter-clockwise.
FlatPoint moved_corner(const ErrorCorner& before, const ErrorCorner& at, const ErrorCorner& after) {
  const double l1 = distance(before.place, at.place), l2 = distance(at.place, after.place);
  const FlatPoint n1{(at.place.y - before.place.y) / l1, (before.place.x - at.place.x) / l1};
  const FlatPoint n2{(after.place.y - at.place.y) / l2, (at.place.x - after.place.x) / l2};
  const double e1 = before.error, e2 = at.error, turn = n1.x * n2.y - n1.y * n2.x;
  const double longest = kLongestCorner * std::max(e1, e2);
  FlatPoint by{(e1 * n1.x + e2 * n2.x) / 2, (e1 * n1.y + e2 * n2.y) / 2};
  if (std::abs(turn) > 0.05) by = {(e1 * n2.y - e2 * n1.y) / turn, (e2 * n1.x - e1 * n2.x) / turn};
  const double length = std::sqrt(by.x * by.x + by.y * by.y);
  const double share = length > longest ? longest / length : 1;
  return {at.place.x + share * by.x, at.place.y + share * by.y};
}

}  // namespace

FlatPoint flat_place(const Facade& facade, Vec3 place, double metres_per_unit) {
  const Vec3 away = place - facade.origin;
  return {metres_per_unit * dot(away, facade.right), metres_per_unit * (facade.origin.z + dot(away, facade.up))};
}

FlatElement flat_element(const Facade& facade, const FacadeElement& element, double metres_per_unit) {
  FlatElement flat;
  for (std::size_t i = 0; i < element.ring.size(); ++i) {
    const FlatPoint p = flat_place(facade, element.ring[i], metres_per_unit);
    const FacadeEdge edge = element.edges.size() == element.ring.size() ? element.edges[i] : FacadeEdge{};
    if (!flat.corners.empty() && distance(place_of(flat.corners.back()), p) < kSamePlace) {
      flat.edges.back() = edge;
      continue;
    }
    flat.corners.push_back({p.x, p.y, 0});
    flat.edges.push_back(edge);
  }
  while (flat.corners.size() > 1 &&
         distance(place_of(flat.corners.front()), place_of(flat.corners.back())) < kSamePlace) {
    flat.corners.pop_back();
    flat.edges.pop_back();
  }
  if (doubled_area_of(flat.corners) < 0) {
    std::reverse(flat.corners.begin(), flat.corners.end());
    std::reverse(flat.edges.begin(), flat.edges.end());
    std::rotate(flat.edges.begin(), flat.edges.begin() + 1, flat.edges.end());
  }
  for (const FacadeArc& given : element.arcs) {
    const FlatArc arc = flat_arc(facade, given, metres_per_unit);
    if (arc.radius > kSamePlace && arc.radius < kLargest && !join_on_arc(arc, flat.corners, flat.edges))
      flat.arcs.push_back({role_of_kind(element.kind), arc.centre.x, arc.centre.y, arc.radius, arc.from_deg,
                           turned(arc.from_deg + arc.span_deg)});
  }
  flat.box = box_of(chords_of(flat));
  return flat;
}

std::vector<FlatPoint> chords_of(const FlatElement& element) {
  std::vector<FlatPoint> points;
  for_each_chord(element, [&](FlatPoint p, std::size_t) { points.push_back(p); });
  return points;
}

double distance_from_wall(const Facade& facade, const FacadeElement& element) {
  double sum = 0;
  for (const Vec3& p : element.ring) sum += dot(p - facade.origin, facade.out);
  return element.ring.empty() ? 0 : sum / static_cast<double>(element.ring.size());
}

bool is_hole(const Facade& facade, const FacadeElement& element, double metres_per_unit) {
  constexpr double kOnWall = 0.05;  // metres
  return is_opening(element) && std::abs(distance_from_wall(facade, element)) * metres_per_unit <= kOnWall;
}

DrawingRole role_of_kind(const std::string& kind) {
  using R = DrawingRole;
  constexpr std::array<std::pair<const char*, R>, 19> kRoles{{{"outline", R::outline},
                                                              {"dormer", R::outline},
                                                              {"window", R::opening},
                                                              {"door", R::opening},
                                                              {"shop", R::opening},
                                                              {"opening", R::opening},
                                                              {"sill", R::sill},
                                                              {"lintel", R::lintel},
                                                              {"surround", R::lintel},
                                                              {"balcony", R::balcony},
                                                              {"railing", R::balcony},
                                                              {"band", R::band},
                                                              {"cornice", R::band},
                                                              {"moulding", R::band},
                                                              {"pediment", R::band},
                                                              {"bulge", R::bulge},
                                                              {"stone", R::stone},
                                                              {"joint", R::joint},
                                                              {"groove", R::joint}}};
  for (const auto& [name, role] : kRoles)
    if (kind == name) return role;
  return R::detail;
}

bool is_opening(const FacadeElement& element) {
  return element.opening || role_of_kind(element.kind) == DrawingRole::opening;
}

DrawingRole role_of(const FacadeElement& element) {
  return element.region == FacadeRegion::irregularity ? DrawingRole::irregularity : role_of_kind(element.kind);
}

void draw_element(const FacadeElement& element, const FlatElement& flat, Drawing& drawing) {
  if (flat.corners.size() < 2) return;
  if (element.status == DrawnStatus::occluded) {
    const bool possible = element.kind == "possible opening";
    drawing.lines.push_back({possible ? DrawingRole::possible : DrawingRole::occluded, flat.corners, true});
    hatch(chords_of(flat), drawing);
    return;
  }
  const DrawingRole role = element.status == DrawnStatus::completed ? DrawingRole::completed : role_of(element);
  for (DrawingArc arc : flat.arcs) {
    arc.role = role;
    drawing.arcs.push_back(arc);
  }
  const auto has = [&](DrawnStatus status) {
    return std::any_of(flat.edges.begin(), flat.edges.end(), [&](const FacadeEdge& e) { return e.status == status; });
  };
  if (role != DrawingRole::completed && has(DrawnStatus::occluded)) {
    draw_chains(flat, role, drawing);
    return;
  }
  drawing.lines.push_back({role, flat.corners, true});
  if (role == DrawingRole::completed || !has(DrawnStatus::completed)) return;
  Drawing chains;
  draw_chains(flat, role, chains);
  for (DrawingLine& line : chains.lines)
    if (line.role == DrawingRole::completed) drawing.lines.push_back(std::move(line));
}

std::vector<FlatPoint> widened_ring(const FlatElement& element) {
  std::vector<ErrorCorner> ring;
  for_each_chord(element, [&](FlatPoint p, std::size_t edge) { ring.push_back({p, element.edges[edge].error_m}); });
  const std::size_t n = ring.size();
  if (n < 3 || std::none_of(ring.begin(), ring.end(), [](const ErrorCorner& c) { return c.error > 0; })) return {};
  std::vector<FlatPoint> widened;
  for (std::size_t i = 0; i < n; ++i)
    widened.push_back(moved_corner(ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]));
  return widened;
}

}  // namespace ilot
