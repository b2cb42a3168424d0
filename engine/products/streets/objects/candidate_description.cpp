// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_description.h"

#include <algorithm>
#include <cmath>

#include "engine/products/streets/objects/candidate_bands.h"
#include "engine/products/streets/objects/candidate_bins.h"
#include "engine/products/streets/objects/candidate_shape.h"
#include "engine/products/streets/objects/moment_rectangle.h"
#include "engine/products/streets/objects/structures_beside.h"

namespace ilot {
namespace {

constexpr Height kModeMetres100 = 5;  // centimetres; size of the bins for the mode of heights

// Sums over the pixels of one candidate.
struct Tally {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;  // pixels
  double low = 0, low_x = 0, low_y = 0;                // low points, and the sums of their positions
  double above = 0, points = 0, slope = 0;
  double wall = 0, wall_nearest = INFINITY, crown = 0, overhang = 0;  // of what is around its pixels
  double edge = 0, edge_ground = 0, edge_standing = 0, edge_building = 0;
  Height ground = kAboveAll;
};

class Describer {
 public:
  Describer(const ComponentImages& images, const RasterScale& scale, const ObjectCandidateParams& params)
      : patch_(images.patch), scale_(scale), params_(params), own_(images.own), slope_(images.slope) {}

  std::vector<ObjectCandidate> described(const PixelLabels& labels) const {
    const std::vector<ComponentFeatures> features = document_features(labels);
    const std::vector<Tally> tallies = tally(labels);
    std::vector<ObjectCandidate> out;
    for (std::uint32_t i = 0; i < labels.count; ++i) out.push_back(candidate(features[i], tallies[i]));
    return out;
  }

 private:
  std::vector<ComponentFeatures> document_features(const PixelLabels& labels) const {
    PixelLabels seen = labels;
    std::vector<std::uint32_t> accumulation(seen.of.size(), 0);
    std::vector<std::uint8_t> any(std::size_t{seen.count} + 1, 0);
    for (std::size_t i = 0; i < seen.of.size(); ++i) {
      accumulation[i] = static_cast<std::uint32_t>(std::max(0, patch_.accumulation.values[i]));
      any[seen.of[i]] |= accumulation[i] > 0;
    }
    for (std::size_t i = 0; i < seen.of.size(); ++i)
      if (accumulation[i] == 0 && any[seen.of[i]] != 0) seen.of[i] = 0;
    const Height bin = std::max(1, scale_.units(0.01 * kModeMetres100));
    auto features = component_features(seen, own_, accumulation, {scale_.unit, scale_.pixel, bin});
    for (ComponentFeatures& f : features)
      for (auto a = static_cast<std::size_t>(ComponentFeature::mean_accumulation);
           a <= static_cast<std::size_t>(ComponentFeature::mode_accumulation); ++a)
        f[a] /= params_.mean_accumulation;
    return features;
  }

  std::vector<Tally> tally(const PixelLabels& labels) const {
    std::vector<Tally> tallies(labels.count);
    const std::size_t w = own_.width;
    for (std::size_t i = 0; i < labels.of.size(); ++i) {
      if (labels.of[i] == 0) continue;
      Tally& t = tallies[labels.of[i] - 1];
      const auto x = static_cast<double>(i % w), y = static_cast<double>(i / w);
      ++t.n;
      t.x += x, t.y += y, t.xx += x * x, t.xy += x * y, t.yy += y * y;
      const double low = std::max(0, patch_.low.values[i]);
      t.low += low, t.low_x += low * x, t.low_y += low * y;
      t.above += std::max(0, patch_.above.values[i]);
      t.points += std::max(0, patch_.accumulation.values[i]);
      t.slope += slope_.values[i];
      add_beside(StructuresBeside(patch_.beside.values[i]), t);
      for (const std::size_t q : {i - w, i - 1, i + 1, i + w})
        if (labels.of[q] != labels.of[i]) add_edge(q, t);
      if (patch_.range.values[i] != kNoHeight)
        t.ground = std::min(t.ground, patch_.range.values[i] - patch_.height.values[i]);
    }
    return tallies;
  }

  static void add_beside(StructuresBeside beside, Tally& t) {
    t.wall += beside.distance();
    t.wall_nearest = std::min(t.wall_nearest, beside.distance());
    t.crown += beside.structure() == Structure::crown;
    t.overhang += beside.structure() == Structure::overhang;
  }

  // What the pixel `q` beside an edge shows.
  void add_edge(std::size_t q, Tally& t) const {
    const StructuresBeside beside(patch_.beside.values[q]);
    ++t.edge;
    if (own_.values[q] != kNoHeight)
      ++t.edge_standing;
    else if (beside.structure() == Structure::wall || beside.structure() == Structure::roof)
      ++t.edge_building;
    else if (patch_.accumulation.values[q] > 0)
      ++t.edge_ground;
  }

  ObjectCandidate candidate(const ComponentFeatures& document, const Tally& t) const {
    ObjectCandidate out;
    const double n = std::max(1.0, t.n), x = t.x / n, y = t.y / n;
    const double xx = t.xx / n - x * x, xy = t.xy / n - x * y, yy = t.yy / n - y * y;
    const MomentRectangle rectangle = moment_rectangle(xx, xy, yy, scale_.pixel);
    out.length = rectangle.length, out.width = rectangle.width, out.heading_deg = rectangle.heading_deg;
    out.x = static_cast<double>(patch_.x) + (t.low > 0 ? t.low_x / t.low : x);
    out.y = static_cast<double>(patch_.y) + (t.low > 0 ? t.low_y / t.low : y);
    out.middle_x = static_cast<double>(patch_.x) + x;
    out.middle_y = static_cast<double>(patch_.y) + y;
    out.ground = t.ground == kAboveAll ? 0 : t.ground;
    out.points = static_cast<std::uint64_t>(t.above);
    out.pixels = static_cast<std::uint32_t>(t.n);
    std::copy(document.begin(), document.end(), out.features.begin());
    const auto set = [&](CandidateFeature f, double v) { out.features[static_cast<std::size_t>(f)] = v; };
    out.features[static_cast<std::size_t>(ComponentFeature::area)] = t.n * scale_.pixel * scale_.pixel;
    set(CandidateFeature::low_share, t.above > 0 ? t.low / t.above : 0);
    set(CandidateFeature::ground_share, t.points > 0 ? 1 - t.above / t.points : 0);
    set(CandidateFeature::roughness, t.slope / n * scale_.unit);
    set(CandidateFeature::length, out.length);
    set(CandidateFeature::width, out.width);
    const double edge = std::max(1.0, t.edge);
    set(CandidateFeature::wall_distance, t.n > 0 ? t.wall_nearest : 0);
    set(CandidateFeature::wall_mean, t.wall / n);
    set(CandidateFeature::crown_share, t.crown / n);
    set(CandidateFeature::overhang_share, t.overhang / n);
    set(CandidateFeature::edge_ground, t.edge_ground / edge);
    set(CandidateFeature::edge_standing, t.edge_standing / edge);
    set(CandidateFeature::edge_building, t.edge_building / edge);
    set(CandidateFeature::seen_points, t.above);
    set(CandidateFeature::pixel_size, scale_.pixel);
    return out;
  }

  const Patch& patch_;
  const RasterScale& scale_;
  const ObjectCandidateParams& params_;
  const Image& own_;
  const Image& slope_;
};

}  // namespace

std::vector<ObjectCandidate> describe(const PixelLabels& labels, const ComponentImages& images,
                                      const RasterScale& scale, const ObjectCandidateParams& params) {
  std::vector<ObjectCandidate> out = Describer(images, scale, params).described(labels);
  set_shapes(labels, images, scale, out);
  set_bin_features(labels, images, scale, out);
  set_band_features(labels, images, scale, out);
  return out;
}

}  // namespace ilot
