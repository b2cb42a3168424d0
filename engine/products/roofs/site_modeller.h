// SPDX-License-Identifier: Apache-2.0
// Turns one site into one building: its points are gathered, modelled, labelled and measured.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "engine/deliverables/solids/city_json.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/roofs/site_gathering.h"
#include "engine/products/roofs/solids/building_attributes.h"

namespace ilot {

// A building as it is written, except for the numbers that depend on the buildings before it.
struct SiteResult {
  std::vector<Building> levels;  // the first has id and attributes
  RoofStatus status = RoofStatus::footprint_only;
  std::string reason;
  bool thinned = false;            // modelled from a sample of its points
  std::uint32_t planes = 0;        // plane_id of the levels and labels: 1 to this, or 0
  std::vector<LabelRun> labels;    // of its points
  std::vector<EditResult> merges;  // of its faces, by hand
};

// The intermediate results of a SiteResult, for anyone who looks for the step that went wrong.
struct SiteSteps {
  GatheredSite gathered;
  RoofSteps roof;
  std::vector<std::uint32_t> face_of_point;  // per point of the site: 0 = none, else the plane_id in SiteResult
};

// kBytesOfSite is the memory to process a site, for any number of points. kBytesOfSitePoint is added for each point of
// its model.
constexpr std::uint64_t kBytesOfSite = 1u << 18, kBytesOfSitePoint = 256;

class SiteModeller {
 public:
  SiteModeller(const SiteWork& work, const RoofModelParams& params, const CityJsonParams& file, RoofLabels& labels)
      : work_(work), params_(params), file_(file), labels_(labels) {}

  // Models one site. A building with more points than work.most_points is modelled from a sample of them. Then each of
  // its points is labelled by the face above or below it (faces_at), and the heights, the rmse and the counts are over
  // all its points. If `steps` is given, it is filled; the result is the same.
  SiteResult model(std::size_t site, SiteSteps* steps = nullptr) const;

 private:
  RoofModel model_of(const GatheredSite& gathered, RoofSteps* steps) const;
  void label_sample(const SiteReader& reader, const GatheredSite& gathered, const RoofModel& model,
                    PointMeasures& measures, SiteResult& result) const;
  void label_all(const SiteReader& reader, const RoofSite& site, const RoofModel& model, PointMeasures& measures,
                 SiteResult& result) const;
  void add_notes(std::size_t number, const GatheredSite& gathered, const RoofModel& model,
                 BuildingAttributes& attributes) const;
  // Adds volumes and areas of walls behind the area of the outline.
  void add_sizes(std::size_t number, const RoofSite& site, std::span<const Building> levels,
                 BuildingAttributes& attributes) const;
  // The outlines so near that walls may be common, from the site's anchor.
  std::vector<SitePolygon> neighbours_of(std::size_t number) const;
  std::vector<Building> levels_of(const RoofSite& site, RoofModel& model) const;

  const SiteWork& work_;
  RoofModelParams params_;
  CityJsonParams file_;
  RoofLabels& labels_;
};

}  // namespace ilot
