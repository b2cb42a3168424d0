// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/pavement_areas.h"

#include <algorithm>
#include <cmath>

#include "kernels/geometry/flat.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

bool has_end(const PavementWidth& w) {
  return w.end != PavementEnd::open && w.end != PavementEnd::unsure;
}

bool follows(const PavementWidth& a, const PavementWidth& b) {
  return a.kerb == b.kerb && a.number + 1 == b.number;
}

// Whether the ends of two widths lie one behind the other as their beginnings do.
bool in_step(const PavementWidth& a, const PavementWidth& b) {
  const Vec3 kerb = b.from - a.from, end = b.to - a.to;
  return kerb.x * end.x + kerb.y * end.y > 0;
}

Pavement area_of_run(std::span<const PavementWidth> run, double metres_per_unit) {
  Pavement p;
  p.kerb = run.front().kerb;
  p.passable_m = run.front().passable_m;
  std::vector<double> widths;
  for (std::size_t i = 0; i < run.size(); ++i) {
    p.ring.push_back(run[i].from);
    widths.push_back(run[i].width_m);
    p.passable_m = std::min(p.passable_m, run[i].passable_m);
    p.unseen_share += run[i].unseen_share / static_cast<double>(run.size());
    if (i > 0)
      p.length_m +=
          norm(FlatPoint{run[i].from.x - run[i - 1].from.x, run[i].from.y - run[i - 1].from.y}) * metres_per_unit;
  }
  for (std::size_t i = run.size(); i-- > 0;) p.ring.push_back(run[i].to);
  p.area_m2 = std::abs(doubled_area(p.ring).z) / 2 * metres_per_unit * metres_per_unit;
  std::sort(widths.begin(), widths.end());
  p.width_m = (widths[(widths.size() - 1) / 2] + widths[widths.size() / 2]) / 2;
  return p;
}

}  // namespace

void mark_unsure_widths(std::span<PavementWidth> widths, const PavementAreasParams& params) {
  std::vector<std::uint8_t> sure(widths.size(), 0);
  for (std::size_t i = 0; i < widths.size(); ++i)
    for (std::size_t j = i + 1; j < widths.size() && widths[j].kerb == widths[i].kerb &&
                                widths[j].number <= widths[i].number + params.neighbours;
         ++j)
      if (has_end(widths[i]) && has_end(widths[j]) &&
          std::abs(widths[i].width_m - widths[j].width_m) <= params.same_width)
        sure[i] = sure[j] = 1;
  for (std::size_t i = 0; i < widths.size(); ++i)
    if (has_end(widths[i]) && sure[i] == 0) widths[i].end = PavementEnd::unsure, widths[i].error_m = 0;
}

std::vector<Pavement> join_pavements(std::span<const PavementWidth> widths, double metres_per_unit) {
  std::vector<Pavement> all;
  for (std::size_t from = 0; from < widths.size();) {
    std::size_t to = from + 1;
    if (has_end(widths[from]))
      while (to < widths.size() && has_end(widths[to]) && follows(widths[to - 1], widths[to]) &&
             in_step(widths[to - 1], widths[to]))
        ++to;
    if (to - from > 1) {
      all.push_back(area_of_run(widths.subspan(from, to - from), metres_per_unit));
      all.back().id = static_cast<std::uint32_t>(all.size());
    }
    from = to;
  }
  return all;
}

}  // namespace ilot
