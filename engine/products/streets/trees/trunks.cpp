// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/trunks.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "engine/products/streets/trees/circle_fit.h"
#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// The mean place of the points of a voxel.
struct VoxelMean {
  double x = 0, y = 0, h = 0;  // metres
  std::uint32_t points = 0;
};

// Connected voxels of one slice.
struct Piece {
  std::uint32_t slice = 0;
  std::vector<VoxelMean> voxels;
  double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
  bool used = false;

  void add(const VoxelMean& v) {
    voxels.push_back(v);
    x0 = std::min(x0, v.x), x1 = std::max(x1, v.x), y0 = std::min(y0, v.y), y1 = std::max(y1, v.y);
  }
  double width() const { return std::max(x1 - x0, y1 - y0); }
  double x() const { return (x0 + x1) / 2; }
  double y() const { return (y0 + y1) / 2; }
};

class TrunkFinder {
 public:
  TrunkFinder(const TrunkVoxels& voxels, const TrunkParams& params)
      : voxels_(voxels), params_(params), seen_(voxels.values.size(), 0) {}

  std::vector<Trunk> find() {
    std::vector<std::vector<Piece>> slices(voxels_.slices);
    for (std::uint32_t s = 0; s < voxels_.slices; ++s) slices[s] = narrow_pieces(s);
    std::vector<Trunk> trunks;
    const auto least = static_cast<std::size_t>(std::ceil(params_.least_run / voxels_.slice - 1e-9));
    for (std::uint32_t s = 0; s < voxels_.slices; ++s)
      for (Piece& piece : slices[s]) {
        if (piece.used) continue;
        const std::vector<const Piece*> chain = chain_from(piece, slices);
        if (chain.size() < std::max<std::size_t>(2, least)) continue;
        const Trunk trunk = trunk_of(chain);
        if (trunk.from <= params_.foot && is_free(trunk, chain)) trunks.push_back(trunk);
      }
    keep_strongest(trunks);
    std::sort(trunks.begin(), trunks.end(),
              [](const Trunk& a, const Trunk& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); });
    return trunks;
  }

 private:
  // The index of a voxel with points; kNone where there are none.
  std::size_t in_use(std::uint32_t slice, std::uint32_t x, std::uint32_t y) const {
    const std::size_t i = voxels_.find(slice, x, y);
    return i != TrunkVoxels::kNone && voxels_.values[i].points > 0 ? i : TrunkVoxels::kNone;
  }

  VoxelMean mean_of(std::uint32_t slice, std::uint32_t x, std::uint32_t y) const {
    const TrunkVoxel& v = voxels_.values[voxels_.find(slice, x, y)];
    const double n = v.points, step = voxels_.side / kTrunkSteps;
    return {x * voxels_.side + (v.x / n + 0.5) * step, y * voxels_.side + (v.y / n + 0.5) * step,
            voxels_.first + (slice + 0.5) * voxels_.slice, v.points};
  }

  // The connected voxels around one. They are visited in an order that depends on their places alone.
  Piece piece_at(std::uint32_t slice, std::uint32_t x, std::uint32_t y) {
    Piece piece{slice, {}};
    std::vector<std::pair<std::uint32_t, std::uint32_t>> next{{x, y}};
    seen_[voxels_.find(slice, x, y)] = 1;
    while (!next.empty()) {
      const auto [u, v] = next.back();
      next.pop_back();
      piece.add(mean_of(slice, u, v));
      for (std::uint32_t b = v - (v > 0); b <= std::min(voxels_.height - 1, v + 1); ++b)
        for (std::uint32_t a = u - (u > 0); a <= std::min(voxels_.width - 1, u + 1); ++a) {
          const std::size_t i = in_use(slice, a, b);
          if (i == TrunkVoxels::kNone || seen_[i] != 0) continue;
          seen_[i] = 1;
          next.emplace_back(a, b);
        }
    }
    return piece;
  }

  std::vector<Piece> narrow_pieces(std::uint32_t slice) {
    std::vector<Piece> pieces;
    for (std::uint32_t y = 0; y < voxels_.height; ++y)
      for (std::uint32_t x = 0; x < voxels_.width; ++x) {
        const std::size_t i = in_use(slice, x, y);
        if (i == TrunkVoxels::kNone || seen_[i] != 0) continue;
        Piece piece = piece_at(slice, x, y);
        if (piece.width() <= params_.widest) pieces.push_back(std::move(piece));
      }
    return pieces;
  }

  // A piece and the pieces above it; a slice without one is passed over once.
  std::vector<const Piece*> chain_from(Piece& first, std::vector<std::vector<Piece>>& slices) const {
    std::vector<const Piece*> chain{&first};
    first.used = true;
    for (std::uint32_t s = first.slice + 1; s < slices.size() && s - chain.back()->slice <= 2; ++s) {
      const Piece& last = *chain.back();
      Piece* nearest = nullptr;
      double least = params_.apart;
      for (Piece& piece : slices[s]) {
        const double d = norm(FlatPoint{piece.x() - last.x(), piece.y() - last.y()});
        if (!piece.used && d < least) nearest = &piece, least = d;
      }
      if (nearest != nullptr) chain.push_back(nearest), nearest->used = true;
    }
    return chain;
  }

  // The lean of the line through the middles of the pieces.
  static void fit_lean(const std::vector<const Piece*>& chain, double first, double slice, Trunk& trunk) {
    double n = 0, h = 0, x = 0, y = 0, hh = 0, hx = 0, hy = 0;
    for (const Piece* p : chain) {
      const double at = first + (p->slice + 0.5) * slice;
      n += 1, h += at, x += p->x(), y += p->y(), hh += at * at, hx += at * p->x(), hy += at * p->y();
    }
    const double spread = hh - h * h / n;
    if (spread <= 0) return;
    trunk.lean_x = (hx - h * x / n) / spread, trunk.lean_y = (hy - h * y / n) / spread;
    // Derived: a tree that leans more is found as a trunk for a part of its height only (`apart` over a slice).
    constexpr double kMostLean = 0.3;
    if (norm(FlatPoint{trunk.lean_x, trunk.lean_y}) > kMostLean) trunk.lean_x = trunk.lean_y = 0;
  }

  Trunk trunk_of(const std::vector<const Piece*>& chain) const {
    Trunk trunk;
    fit_lean(chain, voxels_.first, voxels_.slice, trunk);
    std::vector<CirclePoint> points;
    double x0 = INFINITY, y0 = INFINITY, x1 = -INFINITY, y1 = -INFINITY;
    for (const Piece* piece : chain)
      for (const VoxelMean& v : piece->voxels) {
        points.push_back({v.x - trunk.lean_x * v.h, v.y - trunk.lean_y * v.h});
        const CirclePoint& p = points.back();
        x0 = std::min(x0, p.x), x1 = std::max(x1, p.x), y0 = std::min(y0, p.y), y1 = std::max(y1, p.y);
        trunk.points += v.points;
      }
    const double half = std::max(x1 - x0, y1 - y0) / 2;
    trunk.x = (x0 + x1) / 2, trunk.y = (y0 + y1) / 2, trunk.radius = half;
    const Circle circle = fit_circle(points);
    // A circle through points of one side is trusted where it is about as wide as they are.
    const double away = norm(FlatPoint{circle.x - trunk.x, circle.y - trunk.y});
    if (circle.radius > 0 && circle.radius <= 1.5 * half && away <= half)
      trunk.x = circle.x, trunk.y = circle.y, trunk.radius = circle.radius;
    trunk.from = voxels_.first + chain.front()->slice * voxels_.slice;
    trunk.to = voxels_.first + (chain.back()->slice + 1) * voxels_.slice;
    return trunk;
  }

  // Whether the ring around a trunk has fewer points than the trunk, in the slices in which it was seen.
  bool is_free(const Trunk& trunk, const std::vector<const Piece*>& chain) const {
    std::uint64_t around = 0;
    for (const Piece* piece : chain) {
      const double half = piece->width() / 2, outer = half + params_.ring + voxels_.side;
      const auto cell = [&](double v, std::uint32_t most) {
        return static_cast<std::uint32_t>(std::clamp(v / voxels_.side, 0.0, most - 1.0));
      };
      const std::uint32_t x1 = cell(piece->x() + outer, voxels_.width), y1 = cell(piece->y() + outer, voxels_.height);
      for (std::uint32_t y = cell(piece->y() - outer, voxels_.height); y <= y1; ++y)
        for (std::uint32_t x = cell(piece->x() - outer, voxels_.width); x <= x1; ++x) {
          if (in_use(piece->slice, x, y) == TrunkVoxels::kNone) continue;
          const VoxelMean v = mean_of(piece->slice, x, y);
          const bool inside = v.x >= piece->x0 && v.x <= piece->x1 && v.y >= piece->y0 && v.y <= piece->y1;
          if (!inside && norm(FlatPoint{v.x - piece->x(), v.y - piece->y()}) <= outer) around += v.points;
        }
    }
    return around < trunk.points;
  }

  // Of trunks that are near to each other the one with most points is kept; of equal ones the first.
  void keep_strongest(std::vector<Trunk>& trunks) const {
    std::stable_sort(trunks.begin(), trunks.end(), [](const Trunk& a, const Trunk& b) {
      return std::tie(b.points, a.y, a.x) < std::tie(a.points, b.y, b.x);
    });
    std::vector<Trunk> kept;
    for (const Trunk& t : trunks)
      if (std::none_of(kept.begin(), kept.end(), [&](const Trunk& k) {
            return norm(FlatPoint{k.x - t.x, k.y - t.y}) < params_.stems;
          }))
        kept.push_back(t);
    trunks = std::move(kept);
  }

  const TrunkVoxels& voxels_;
  const TrunkParams& params_;
  std::vector<std::uint8_t> seen_;
};

}  // namespace

TrunkVoxel& TrunkVoxels::add(std::uint32_t at_slice, std::uint32_t x, std::uint32_t y) {
  if (columns.empty()) columns.assign(std::size_t{width} * height, 0);
  std::uint32_t& column = columns[std::size_t{y} * width + x];
  if (column == 0) {
    values.resize(values.size() + slices);
    column = static_cast<std::uint32_t>(values.size() / slices);
  }
  return values[std::size_t{column - 1} * slices + at_slice];
}

std::vector<Trunk> find_trunks(const TrunkVoxels& voxels, const TrunkParams& params) {
  if (voxels.values.empty()) return {};
  return TrunkFinder(voxels, params).find();
}

}  // namespace ilot
