// SPDX-License-Identifier: Apache-2.0
// Tests whether colour helps [Lorraine thesis, 2.2.1 and 2.2.2], on a coloured scene with truth. First, it counts the
// draws until 95% of the support of a plane is reached, for the first five planes, classical and guided, as the median
// over seeds. Second, it finds the colour space that separates colours best, by two measures against the true classes:
// the share of inertia within classes (less is better) and the V-measure (Rosenberg and Hirschberg 2007). Usage:
// study_colour SCENE.laz [seeds [20]]
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "kernels/core/quantile.h"
#include "kernels/plane_methods/colour_ransac.h"
#include "study/scene.h"

namespace {

using namespace ilot;
using bench::Scene;

constexpr std::uint32_t kPlanes = 5;

double entropy(const std::map<std::uint32_t, double>& count, double n) {
  double h = 0;
  for (const auto& [key, c] : count) h -= c / n * std::log(c / n);
  return h;
}

double v_measure(const std::vector<std::uint32_t>& truth, const std::vector<std::uint32_t>& found) {
  std::map<std::uint32_t, double> of_truth, of_found, of_both;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    ++of_truth[truth[i]];
    ++of_found[found[i]];
    ++of_both[truth[i] << 8 | found[i]];
  }
  const auto n = static_cast<double>(truth.size());
  const double ht = entropy(of_truth, n), hf = entropy(of_found, n), hb = entropy(of_both, n);
  const double homogeneity = ht > 0 ? 1 - (hb - hf) / ht : 1, completeness = hf > 0 ? 1 - (hb - ht) / hf : 1;
  return 2 * homogeneity * completeness / (homogeneity + completeness);
}

void evaluate_spaces(const Scene& s) {
  const std::pair<const char*, ColourSpace> spaces[]{
      {"Lab", ColourSpace::kLab}, {"RGB", ColourSpace::kRgb}, {"Lab + intensity", ColourSpace::kLabIntensity}};
  for (const auto& [name, space] : spaces) {
    ColourClassParams params;
    params.space = space;
    const ColourClasses c = colour_classes(s.colours(), params);
    fmt::print("{:<16} inertia within / total {:.3f}   V-measure against classes {:.3f}\n", name, c.intra / c.total(),
               v_measure(s.true_class, c.label));
  }
}

// Returns the draws until the consensus set contains 95% of the points of the plane after refinement, or all draws if
// it never does.
std::vector<std::uint64_t> draws_needed(const ColourRansacPlanes& r) {
  std::vector<std::uint64_t> size(r.segments.planes.size() + 1, 0), needed;
  for (const std::uint32_t l : r.segments.label) ++size[l];
  for (std::size_t p = 0; p < r.draws.size(); ++p) {
    std::uint64_t draws = r.draws[p];
    for (const DrawProgress& step : r.progress[p]) {
      if (step.support < 0.95 * static_cast<double>(size[p + 1])) continue;
      draws = step.draw;
      break;
    }
    needed.push_back(draws);
  }
  return needed;
}

std::uint64_t median(std::vector<std::uint64_t> v) {
  return v.empty() ? 0 : upper_median(v);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: study_colour SCENE.laz [seeds [20]]\n");
    return 2;
  }
  try {
    const Scene s = bench::load_scene(argv[1], 32, bench::Cleaning::kNone);
    if (s.red.empty()) throw std::runtime_error("the scene has no colours");
    evaluate_spaces(s);
    const std::vector<std::uint32_t> classes = colour_classes(s.colours()).label, none;
    const int seeds = argc > 2 ? std::atoi(argv[2]) : 20;
    std::vector<std::uint64_t> needed[2][kPlanes], drawn[2][kPlanes], support[2][kPlanes];
    for (int seed = 1; seed <= seeds; ++seed)
      for (int guided = 0; guided < 2; ++guided) {
        ColourRansacParams params;
        params.epsilon = 0.02 / s.unit_metres;  // the value of the document
        params.max_planes = kPlanes;
        params.min_points = 500;
        params.key = static_cast<std::uint64_t>(seed);
        const ColourRansacPlanes r = colour_ransac(s.oriented(), guided != 0 ? classes : none, params);
        const auto n = draws_needed(r);
        for (std::size_t p = 0; p < n.size(); ++p) {
          needed[guided][p].push_back(n[p]);
          drawn[guided][p].push_back(r.draws[p]);
          support[guided][p].push_back(
              static_cast<std::uint64_t>(std::count(r.segments.label.begin(), r.segments.label.end(), p + 1)));
        }
      }
    fmt::print("medians of {} seeds; classical -> guided\n", seeds);
    std::uint64_t total[2]{};
    for (std::size_t p = 0; p < kPlanes; ++p) {
      fmt::print("plane {}: draws to 95% {:>6} -> {:>6}   draws to the bound {:>6} -> {:>6}   support {:>7} -> {:>7}\n",
                 p + 1, median(needed[0][p]), median(needed[1][p]), median(drawn[0][p]), median(drawn[1][p]),
                 median(support[0][p]), median(support[1][p]));
      for (int g = 0; g < 2; ++g) total[g] += median(needed[g][p]);
    }
    fmt::print("total to 95%: {} -> {} ({:.0f}%)\n", total[0], total[1],
               100.0 * static_cast<double>(total[1]) / static_cast<double>(total[0]));
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_colour: {}\n", e.what());
    return 1;
  }
  return 0;
}
