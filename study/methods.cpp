// SPDX-License-Identifier: Apache-2.0
// Runs every segmentation method on one scanned scene and compares it with the truth. Prints seconds, planes and the
// share found, and for each class the sensitivity and the precision as the documents count them (evaluate/confusion.h).
// Usage: study_methods SCENE.laz [--normals K] [--epsilon METRES] [--gap STEPS] [--least POINTS] [--only TEXT] [--clean
// 1]
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "kernels/core/portable_math.h"
#include "kernels/plane_methods/colour_ransac.h"
#include "kernels/plane_methods/facade_ransac.h"
#include "kernels/plane_methods/hough_planes.h"
#include "kernels/plane_methods/roof_ransac.h"
#include "kernels/plane_methods/split_merge.h"
#include "kernels/planes/ransac.h"
#include "kernels/planes/region_planes.h"
#include "kernels/planes/relabel.h"
#include "kernels/shapes/shape_ransac.h"
#include "study/scene.h"

namespace {

using namespace ilot;
using bench::Scene;

struct Setting {
  double epsilon = 0;  // units
  std::int64_t connectivity = 1;
  std::uint32_t min_points = 100;
};

struct Method {
  const char* name;
  std::function<PlaneSegments(const Scene&, const Setting&)> run;
};

PlaneSegments regions_to_planes(const Scene& s, const Setting& set, const Regions& regions) {
  return planes_of_regions(s.points(), regions, {set.epsilon, set.min_points, set.connectivity, PlaneEstimate::kBest});
}

PlaneSegments pairs(const Scene& s, const Setting& set) {
  return regions_to_planes(s, set,
                           grow_by_pairs(s.points(), s.normals, s.neighbours(),
                                         {cos_degrees(5), set.epsilon / 2, set.connectivity, set.min_points}));
}

PlaneSegments smooth(const Scene& s, const Setting& set) {
  return regions_to_planes(
      s, set,
      grow_smooth(s.points(), s.normals, s.neighbours(), {cos_degrees(2), 1.0 / 3, set.connectivity, set.min_points}));
}

PlaneSegments octree(const Scene& s, const Setting& set) {
  SplitMergeParams p;
  p.epsilon = set.epsilon;
  p.tolerance = set.epsilon / 2.5;
  p.max_step = set.epsilon / 2;
  p.min_edge = static_cast<std::int64_t>(2 * s.step);
  p.min_points = set.min_points;
  return split_merge(s.points(), p);
}

PlaneSegments hough(const Scene& s, const Setting& set) {
  HoughPlanesParams p;
  p.epsilon = set.epsilon;
  p.distance_step = 2 * set.epsilon;
  p.min_vote_cos = cos_degrees(8);
  p.min_cos = cos_degrees(25);
  p.connectivity = set.connectivity;
  p.min_points = set.min_points;
  return hough_planes(s.oriented(), p);
}

PlaneSegments planes(const Scene& s, const Setting& set) {
  return ransac_planes(s.oriented(), {set.epsilon, cos_degrees(25), set.connectivity, set.min_points, 0.99, 1});
}

ShapeRansacParams shape_params(const Setting& set, unsigned kinds) {
  ShapeRansacParams p;
  p.epsilon = set.epsilon;
  p.min_cos = cos_degrees(25);
  p.connectivity = set.connectivity;
  p.min_points = set.min_points;
  p.kinds = kinds;
  p.key = 1;
  return p;
}

PlaneSegments plane_shapes(const Scene& s, const Setting& set) {
  const ShapeSegments found = ransac_shapes(s.oriented(), shape_params(set, shape_bit(ShapeKind::kPlane)));
  PlaneSegments r{found.label, {}};
  for (const FoundShape& f : found.shapes) r.planes.push_back(plane_of(f.shape));
  return r;
}

FacadeRansacParams facade_params(const Scene& s, const Setting& set) {
  FacadeRansacParams p;
  p.epsilon = set.epsilon;
  p.inclined_gap = static_cast<std::int64_t>(0.02 / s.unit_metres);
  p.connectivity = set.connectivity;
  p.parallel_points = 1000;
  p.key = 1;
  return p;
}

PlaneSegments facade(const Scene& s, const Setting& set) {
  return facade_ransac(s.oriented(), with_degrees(facade_params(s, set), 18, 72, 1.8)).segments;
}

PlaneSegments facade_raw(const Scene& s, const Setting& set) {
  return facade_ransac(s.oriented(), with_raw_numbers(facade_params(s, set))).segments;
}

ColourRansacParams colour_params(const Setting& set) {
  ColourRansacParams p;
  p.epsilon = set.epsilon;
  p.min_points = set.min_points;
  p.max_draws = 20000;
  p.key = 1;
  return p;
}

PlaneSegments classical(const Scene& s, const Setting& set) {
  return colour_ransac(s.oriented(), {}, colour_params(set)).segments;
}

PlaneSegments coloured(const Scene& s, const Setting& set) {
  if (s.red.empty()) return {std::vector<std::uint32_t>(s.size(), 0), {}};
  return colour_ransac(s.oriented(), colour_classes(s.colours()).label, colour_params(set)).segments;
}

PlaneSegments roofs(const Scene& s, const Setting& set) {
  RoofRansacParams p;
  p.epsilon = set.epsilon;
  p.stray_gap = set.connectivity;
  p.min_points = set.min_points;
  p.key = 1;
  return roof_ransac(s.points(), s.neighbours(), p);
}

const Method kMethods[] = {
    {"A2 pairs", pairs},     {"D3 smooth", smooth},  {"A3 octree", octree},
    {"A4 hough", hough},     {"A6 planes", planes},  {"A6 shapes, planes", plane_shapes},
    {"A7 degrees", facade},  {"A7 raw", facade_raw}, {"C2 classical", classical},
    {"C2 colour", coloured}, {"D4 rings", roofs},
};

template <typename Body>
double seconds_of(const Body& body) {
  const auto start = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_row(const Scene& s, const char* name, double seconds, std::size_t planes,
               const std::vector<std::uint32_t>& label) {
  LabelPairs by_class, by_plane;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.classes.count(s.true_class[i]) != 0) by_class.add(s.true_class[i], label[i]);
    by_plane.add(s.true_plane[i], label[i]);
  }
  for (const std::uint32_t c : s.dropped_class)
    if (s.classes.count(c) != 0) by_class.add(c, 0);
  const ConfusionMatrix m = confusion_of_segments(by_class.sorted(), s.classes);
  const auto percent = [](std::optional<double> v) {
    return v ? fmt::format("{:5.1f}", 100 * *v) : std::string("    -");
  };
  fmt::print("{:<20}{:>8.3f}{:>7}  {}%", name, seconds, planes, percent(global_sensitivity(m)));
  for (std::size_t c = 0; c < m.classes.size(); ++c)
    fmt::print("  {}/{}", percent(sensitivity(m, c)), percent(precision(m, c)));
  fmt::print("\n");
  std::fflush(stdout);
}

// Checks that no point is farther than epsilon from its own plane.
void check_epsilon(const Scene& s, const PlaneSegments& r, double epsilon, const char* name) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (r.label[i] == 0) continue;
    if (std::abs(signed_distance(r.planes[r.label[i] - 1], {s.x[i], s.y[i], s.z[i]})) <= epsilon) continue;
    fmt::print(stderr, "{}: point {} lies beyond epsilon of its plane\n", name, i);
    std::exit(1);
  }
}

// Returns whether a shape is found. A found shape of the same kind must have its parameters within 1% or 5 mm (angles:
// half a degree) and contain half of its points.
bool agrees(const bench::TrueShape& t, const FoundShape& f, double unit) {
  const double near = 0.005 / unit;
  const auto close = [&](double a, double b) { return std::abs(a - b) <= std::max(near, 0.01 * std::abs(b)); };
  if (f.shape.kind != t.shape.kind) return false;
  const double cosine = std::abs(dot(f.shape.axis, t.shape.axis));
  const Vec3 v =
      t.shape.origin + (t.shape.kind == ShapeKind::kSphere ? 0 : t.length / 2) * t.shape.axis - f.shape.origin;
  switch (t.shape.kind) {
    case ShapeKind::kSphere:
      return norm(v) <= std::max(near, 0.01 * t.shape.radius) && close(f.shape.radius, t.shape.radius);
    case ShapeKind::kCylinder:
      return cosine > 0.99996 &&
             norm(v - dot(v, f.shape.axis) * f.shape.axis) <= std::max(near, 0.01 * t.shape.radius) &&
             close(f.shape.radius, t.shape.radius);
    default:
      return cosine > 0.99996 && std::abs(f.shape.sine - t.shape.sine) <= 0.01 &&
             norm(f.shape.origin - t.shape.origin) <= std::max(near, 0.01 * t.length);
  }
}

void evaluate_shapes(const Scene& s, const Setting& set) {
  ShapeSegments found;
  ShapeRansacParams params = shape_params(set, kAllShapes);
  params.min_points = std::min<std::uint32_t>(params.min_points, 300);
  const double seconds = seconds_of([&] { found = ransac_shapes(s.oriented(), params); });
  print_row(s, "A6 all shapes", seconds, found.shapes.size(), found.label);
  static const char* const kNames[]{"plane", "sphere", "cylinder", "cone"};
  for (const bench::TrueShape& t : s.shapes) {
    std::vector<std::uint64_t> shared(found.shapes.size() + 1, 0);
    std::uint64_t points = 0;
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.true_plane[i] != t.id) continue;
      ++points;
      ++shared[found.label[i]];
    }
    const auto best = std::max_element(shared.begin() + 1, shared.end());
    const auto at = static_cast<std::size_t>(best - shared.begin()) - 1;
    const bool ok = best != shared.end() && agrees(t, found.shapes[at], s.unit_metres) && 2 * *best >= points;
    const double mm = 1000 * s.unit_metres;
    fmt::print("  {:<9}{:>7} points  r {:7.1f} mm  half angle sine {:.3f}  {}", kNames[static_cast<int>(t.shape.kind)],
               points, mm * t.shape.radius, t.shape.sine,
               ok             ? "found"
               : points < 500 ? "not found (below 500)"
                              : "MISSED");
    if (best != shared.end() && *best > 0) {
      const FoundShape& f = found.shapes[at];
      fmt::print("  as {} r {:.1f} sine {:.3f}, {:.0f}% of its points", kNames[static_cast<int>(f.shape.kind)],
                 mm * f.shape.radius, f.shape.sine, 100.0 * static_cast<double>(*best) / static_cast<double>(points));
    }
    fmt::print("\n");
  }
}

struct Options {
  const char* file = nullptr;
  int normals = 32;
  double epsilon = 0;  // metres; 0 = from the noise
  double gap = 3;      // connectivity in steps
  std::uint32_t least = 100;
  std::string only;  // a part of the name of a method
  bench::Cleaning cleaning = bench::Cleaning::kNone;
};

std::optional<Options> parse(int argc, char** argv) {
  Options o;
  for (int i = 1; i < argc; ++i) {
    const std::string_view key = argv[i];
    if (!key.starts_with("--")) {
      o.file = argv[i];
      continue;
    }
    if (++i == argc) return std::nullopt;
    if (key == "--normals")
      o.normals = std::atoi(argv[i]);
    else if (key == "--epsilon")
      o.epsilon = std::atof(argv[i]);
    else if (key == "--gap")
      o.gap = std::atof(argv[i]);
    else if (key == "--least")
      o.least = static_cast<std::uint32_t>(std::atoi(argv[i]));
    else if (key == "--only")
      o.only = argv[i];
    else if (key == "--clean")
      o.cleaning = bench::Cleaning::kMixedPixels;
    else
      return std::nullopt;
  }
  if (o.file == nullptr) return std::nullopt;
  return o;
}

int run(const Options& o) {
  const Scene s = bench::load_scene(o.file, o.normals, o.cleaning);
  Setting set;
  set.epsilon = o.epsilon > 0 ? o.epsilon / s.unit_metres : std::max(3.5 * s.noise, s.step / 4);
  set.connectivity = static_cast<std::int64_t>(std::ceil(o.gap * s.step));
  set.min_points = o.least;
  const double mm = 1000 * s.unit_metres;
  fmt::print(
      "{}: {} points, step {:.1f} mm, noise {:.2f} mm, epsilon {:.1f} mm; normals of {} {:.2f} s, neighbours {:.2f} "
      "s\n",
      o.file, s.size(), mm * s.step, mm * s.noise, mm * set.epsilon, o.normals, s.normal_seconds, s.neighbour_seconds);
  if (o.cleaning != bench::Cleaning::kNone)
    fmt::print("mixed pixels: {} dropped, {} of them of a class\n", s.dropped_class.size(),
               std::count_if(s.dropped_class.begin(), s.dropped_class.end(), [](std::uint32_t c) { return c != 0; }));
  fmt::print("{:<20}{:>8}{:>7}  {:>6}", "method", "seconds", "planes", "global");
  for (const auto& [number, name] : s.classes) fmt::print("  {:>11}", name.substr(0, 11));
  fmt::print("   (sensitivity/precision, percent)\n");
  for (const Method& m : kMethods) {
    if (std::string_view(m.name).find(o.only) == std::string_view::npos) continue;
    PlaneSegments found;
    const double seconds = seconds_of([&] {
      found = m.run(s, set);
      const RelabelParams relabel{set.epsilon, set.connectivity, 2, 4, 0.2 * set.epsilon};
      relabel_until_stable(s.points(), s.neighbours(), relabel, set.min_points, found);
    });
    check_epsilon(s, found, set.epsilon, m.name);
    print_row(s, m.name, seconds, found.planes.size(), found.label);
  }
  if (std::string_view("A6 all shapes").find(o.only) != std::string_view::npos) evaluate_shapes(s, set);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (const auto options = parse(argc, argv)) return run(*options);
    fmt::print(stderr,
               "usage: study_methods SCENE.laz [--normals K] [--epsilon METRES] [--gap STEPS] [--least POINTS] "
               "[--only TEXT] [--clean 1]\n");
    return 2;
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_methods: {}\n", e.what());
    return 1;
  }
}
