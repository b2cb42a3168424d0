// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/make_streets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/layers/kerbs_gpkg.h"
#include "engine/deliverables/layers/pavements_gpkg.h"
#include "engine/deliverables/layers/streets_gpkg.h"
#include "engine/deliverables/layers/trees_gpkg.h"
#include "engine/deliverables/maps/street_book.h"
#include "engine/deliverables/maps/street_map.h"
#include "engine/model/point_label.h"
#include "engine/products/product_edits.h"
#include "engine/products/streets/edits/object_edits.h"
#include "engine/products/streets/ground/street_mask.h"
#include "engine/products/streets/ground/structures.h"
#include "engine/products/streets/ground/tiled_artefacts.h"
#include "engine/products/streets/ground/tiled_ground.h"
#include "engine/products/streets/objects/long_objects.h"
#include "engine/products/streets/objects/object_selection.h"
#include "engine/products/streets/objects/vehicle_sizes.h"
#include "engine/products/streets/pavements/carriageways.h"
#include "engine/products/streets/pavements/pavement_areas.h"
#include "engine/products/streets/street_codes.h"
#include "engine/products/streets/street_cover.h"
#include "engine/products/streets/street_kerbs.h"
#include "engine/products/streets/street_labels.h"
#include "engine/products/streets/street_pavements.h"
#include "engine/products/streets/street_places.h"
#include "engine/products/streets/street_rasters.h"
#include "engine/products/streets/street_training.h"
#include "engine/products/streets/street_trees.h"
#include "engine/products/streets/stretch_index.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

// Choice: lost scan lines leave two or three empty rows; wider ones are shadows.
constexpr double kStepsOfGap = 5;          // pixels; least limit for the width of a gap between scan lines
constexpr std::uint64_t kLeastPoints = 3;  // least number of points of an object [Hernandez and Marcotegui 2008, 5.3]
// Choice: a person is lower; a trunk without points in the last 25 cm below its crown is taken for an object.
constexpr double kTrunkShare = 0.9;  // of the height from which crowns are taken out
// Derived: a square of two pixels, the smallest that is no line. From the street a pole is one pixel, with a point in
// many of its bins.
constexpr double kPixelsFromAir = 4;  // least number of pixels of a candidate
// Derived: two sampling steps, as a pixel is half of one; a surface may lack a point in between.
constexpr std::uint32_t kPixelsApart = 4;  // pixels; a wider gap lies between two objects

constexpr const char* kLeftOutFromAir =
    "streets: houses, gaps between them, kerbs and pavements are left out, as from the air they are hardly seen";

GroundParams ground_params(const StreetsSettings& s, const RasterScale& scale) {
  return {s.flat, std::max(s.longest_gap, kStepsOfGap * scale.pixel), s.advanced.gap_step, s.longest_link};
}

ObjectCandidateParams candidate_params(const StreetsSettings& s, const RasterScale& scale, StreetView view,
                                       double mean_accumulation) {
  ObjectCandidateParams params;
  const double pixel = scale.pixel * scale.pixel;
  const double least = view == StreetView::air ? std::max(s.least_area, kPixelsFromAir * pixel) : pixel;
  params.separation.least_area = least;
  params.separation.least_top = std::max(s.least_area, least);
  params.separation.rise = s.rise;
  params.least_points = kLeastPoints;
  params.columns_apart = view == StreetView::street;
  if (view == StreetView::street) params.pixels_apart = kPixelsApart;
  params.mean_accumulation = mean_accumulation;
  return params;
}

CityBlocksParams blocks_params(const AdvancedStreets& s) {
  CityBlocksParams params;
  params.least_facade = s.facade_height;
  params.least_length = s.facade_length;
  params.depth = s.cross_street_depth;
  params.least_gap = s.cross_street_width;
  return params;
}

Vec3 place_of(const TileRaster& raster, double x, double y, Height z) {
  return {raster.crs_x(x + 0.5), raster.crs_y(y + 0.5), z * raster.unit};  // centres of pixels are at whole numbers
}

// Choice: what vehicles may measure with their load, and half a metre more; a tall person under an umbrella.
constexpr double kHighestVan = 4.5, kHighestOfOthers = 2.5;  // metres

// The height up to which an object of this class is one whatever lies between its points. A higher one has a crown, a
// sign or an awning above it. Posts and what is of no known kind may reach up to these.
double usual_height(PointLabel label) {
  switch (label) {
    case PointLabel::van:
      return kHighestVan;
    case PointLabel::car:
    case PointLabel::two_wheeler:
    case PointLabel::pedestrian:
    case PointLabel::bollard:
    case PointLabel::bin:
    case PointLabel::bench:
    case PointLabel::planter:
    case PointLabel::cabinet:
      return kHighestOfOthers;
    default:
      return INFINITY;
  }
}

// Metres above the ground; what is higher is no part of an object of this class.
double top_of(const ObjectCandidate& candidate, PointLabel label) {
  const double highest = candidate.features[static_cast<std::size_t>(ComponentFeature::max_height)];
  return highest > usual_height(label) ? candidate.own_top : INFINITY;
}

StreetObject object_of(const FoundStreet& street, const StretchIndex& blocks, const ObjectCandidate& candidate,
                       const CandidateClass& what, const OwnClasses& own) {
  const TileRaster& raster = street.tiles->raster();
  StreetObject o;
  o.label = what.label;
  o.class_name = class_name_of(what.label, own);
  o.probability = what.probability;
  o.base = place_of(raster, candidate.x, candidate.y, candidate.ground);
  o.middle = place_of(raster, candidate.middle_x, candidate.middle_y, candidate.ground);
  o.height_m = std::min(candidate.features[static_cast<std::size_t>(ComponentFeature::max_height)],
                        top_of(candidate, what.label));
  o.length_m = candidate.length;
  o.width_m = candidate.width;
  o.heading_deg = candidate.heading_deg;
  o.area_m2 = candidate.features[static_cast<std::size_t>(ComponentFeature::area)];
  o.points = candidate.points;
  const BlockAddress address = blocks.address(candidate.x, candidate.y);
  o.stretch = address.stretch;
  o.block = address.block;
  return o;
}

void add_parts(const FoundStreet& street, StreetPlan& plan) {
  const TileRaster& raster = street.tiles->raster();
  const auto part_of = [&](std::size_t s, std::size_t number, const StretchPart& part) {
    const StreetStretch& stretch = street.stretches[s];
    const auto at = [&](double along) {
      const double pixels = along / raster.scale.pixel;
      return place_of(raster, stretch.x + pixels * stretch.dx, stretch.y + pixels * stretch.dy, 0);
    };
    return FacadePart{static_cast<std::uint32_t>(s + 1),
                      static_cast<std::uint32_t>(number + 1),
                      at(part.from),
                      at(part.to),
                      part.to - part.from,
                      part.height};
  };
  for (std::size_t s = 0; s < street.stretches.size(); ++s) {
    for (std::size_t b = 0; b < street.stretches[s].blocks.size(); ++b)
      plan.blocks.push_back(part_of(s, b, street.stretches[s].blocks[b]));
    for (std::size_t g = 0; g < street.stretches[s].gaps.size(); ++g)
      plan.gaps.push_back(part_of(s, g, street.stretches[s].gaps[g]));
  }
}

void record_choices(const StreetsSettings& settings, const FoundStreet& street, RunRecord& record) {
  const bool air = street.view == StreetView::air;
  if (!settings.pixel)
    record.chosen.push_back(
        {"streets.pixel", street.tiles->raster().scale.pixel,
         fmt::format("{} at {:.1f} points a square metre, in steps of 5 cm",
                     air ? "contains a point nine times in ten" : "half of the sampling step", street.density.median)});
  if (!settings.view)
    record.chosen.push_back(
        {"streets.view", std::string(kStreetViews[static_cast<std::size_t>(street.view)]),
         fmt::format("{:.1f} % of the points lie in square metres with more than four times as many as most have, "
                     "which is {:.1f}, and the 9th decile of points of a square metre is {:.0f} times the 1st: {}",
                     100 * street.density.dense_share, street.density.median, street.density.spread,
                     air ? "what is upright was hardly seen" : "it was scanned from the ground")});
}

// The lines on the map about what is not looked for. The run says it too.
std::vector<std::string> left_out(StreetView view, const ProductOutput& out) {
  if (view == StreetView::street) return {};
  out.record.warnings.push_back(kLeftOutFromAir);
  out.progress.warn(kLeftOutFromAir);
  return {"Seen from the air: houses, gaps between", "houses, kerbs and pavements are left out."};
}

// What a candidate carries: a crown if it is a trunk, an overhang if it is a pillar. It reaches up to where that was
// taken out.
Structure carried(const FoundStreet& street, const ObjectCandidate& candidate) {
  const Cells& cells = street.tiles->cells();
  if (candidate.features[static_cast<std::size_t>(ComponentFeature::max_height)] < kTrunkShare * kClearance)
    return Structure::none;
  const auto cell = [&](double pixel) { return static_cast<std::int64_t>((pixel + 0.5) / cells.factor); };
  const Image structure =
      layer_window(cells.layers, "structure", cell(candidate.middle_x), cell(candidate.middle_y), 1, 1);
  return static_cast<Structure>(structure.values[0]);
}

// The classes of candidates. Trunks are vegetation, and pillars are none, as they belong to a building.
std::vector<CandidateClass> classes_without_trunks(const FoundStreet& street, std::vector<CandidateClass> classes) {
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (group_of(classes[i].label) == PointLabel::car || !is_street_object(classes[i].label)) continue;
    const Structure above = carried(street, street.candidates[i]);
    if (above == Structure::crown) classes[i].label = PointLabel::vegetation;
    if (is_overhang(above)) classes[i].label = PointLabel::none;
  }
  return classes;
}

constexpr double kLeastHedge = 1;  // Choice: metres; trunks are narrower

// What the pixels of an object are for a pavement. Hedges and walls of gardens are found by how they stand in a row.
PavementPixel standing_of(PointLabel label, const ObjectCandidate& candidate) {
  if (label == PointLabel::vegetation && candidate.length < kLeastHedge) return PavementPixel::loose;  // a trunk
  switch (label) {
    case PointLabel::fence:
      return PavementPixel::fence;
    case PointLabel::car:
    case PointLabel::van:
    case PointLabel::two_wheeler:
    case PointLabel::pedestrian:
      return PavementPixel::loose;
    default:
      return PavementPixel::object;
  }
}

// Labels the points and finds what is made of labelled points. Points around the wanted area have a part in this, and
// lose their labels afterwards.
void add_layers(const Store& store, const FoundStreet& street, const ObjectLabels& labels, double least_height,
                const PassContext& context, std::span<const PavementPixel> standing, StreetPlan& plan) {
  const StreetTiles& tiles = *street.tiles;
  PassContext all = context;
  all.wanted = {};
  if (context.wanted) all.advance = [](std::uint64_t) {};
  write_street_labels(store, tiles, labels, least_height, all);
  plan.trees = find_street_trees(store, tiles, street.view, context);
  // From the air too few points are on both sides of a step (docs/streets.md).
  if (street.view == StreetView::street) plan.kerbs = find_street_kerbs(store, tiles, street.density, context);
  if (context.wanted) write_street_labels(store, tiles, labels, least_height, context);
  plan.widths = find_pavement_widths(tiles, plan.kerbs, standing);
  mark_unsure_widths(plan.widths);
  plan.pavements = join_pavements(plan.widths, context.metres_per_unit);
  plan.carriageways = find_carriageways(plan.kerbs, context.metres_per_unit);
}

}  // namespace

StreetPixel street_pixel(const Store& store, const StreetsSettings& settings, const PassContext& context) {
  StreetPixel pixel;
  pixel.density = point_density(store, context);
  pixel.view = settings.view.value_or(view_of(pixel.density));
  pixel.metres = settings.pixel.value_or(pixel_for(pixel.density.median, pixel.view));
  return pixel;
}

FoundStreet find_street(const Store& store, const StreetsSettings& settings, const PassContext& context,
                        const SeeTile& see) {
  FoundStreet street;
  const StreetPixel pixel = street_pixel(store, settings, context);
  street.density = pixel.density;
  street.view = pixel.view;
  street.tiles = std::make_unique<StreetTiles>(store, context, pixel.metres, pixel.density.median, see);
  const StreetTiles& tiles = *street.tiles;
  const RasterScale& scale = tiles.raster().scale;
  ArtefactParams artefacts;
  artefacts.least_height = settings.least_height;
  artefacts.highest_kerb = settings.advanced.highest_kerb;
  artefacts.least_plateau = settings.advanced.least_pavement;
  street.terrain = find_terrain(tiles.cells());
  tiles.draw_heights(street.view);
  find_structures(tiles.cells(), street.view);
  tiles.take_out_overhead();
  fill_ground_tiled(tiles.layers(), scale, ground_params(settings, scale));
  find_street_mask(tiles.layers(), tiles.cells());
  find_artefacts_tiled(tiles.layers(), scale, artefacts);
  put_on_terrain(tiles.layers(), tiles.cells(), artefacts.highest_kerb, artefacts.least_height);
  tiles.spread_level(artefacts.ring_reach);
  const ObjectCandidateParams params = candidate_params(settings, scale, street.view, tiles.mean_accumulation());
  tiles.count_above(settings.least_height, params.low_height);
  street.candidates = find_object_candidates(tiles.layers(), scale, params);
  // From the air roofs hide facades, and a line through the pixels of roofs is no front of a house (docs/streets.md).
  if (street.view == StreetView::street)
    street.stretches = find_city_blocks(tiles.layers(), scale, blocks_params(settings.advanced));
  return street;
}

namespace {

// The whole candidates and their classes, with the edits of streets. Merges append candidates to those of the street.
// Tells what became of each edit.
SelectedObjects selected_objects(const StreetClasses& model, std::span<const Edit> all, const PassContext& context,
                                 double unit, EditTally tally, FoundStreet& street) {
  SelectedObjects selected;
  selected.classes = classes_without_trunks(street, model.of(street.candidates));
  deny_too_large_vehicles(
      street.candidates,
      {street.tiles->raster().scale.pixel, model.base->classes.size(), street.view == StreetView::street},
      selected.classes);
  if (street.view == StreetView::street) {
    deny_rough_vehicles(street.candidates, model.base->classes.size(), selected.classes);
    if (!model.trained) name_long_strips(street.candidates, street.tiles->raster().scale.pixel, selected.classes);
  }
  selected.taken = select_objects(street.candidates, selected.classes);
  selected.by_hand.assign(street.candidates.size(), 0);
  std::vector<const Edit*> edits = edits_of(all, "streets");
  std::erase_if(edits, [&](const Edit* edit) {
    const bool outside = lies_outside(*edit, context, unit);
    if (outside) tally.outside();
    return outside;
  });
  if (edits.empty()) return selected;
  selected.candidates = std::move(street.candidates);
  const auto at = [&](Vec3 place) { return part_at(street, place); };
  const std::vector<EditResult> results = edit_objects(edits, at, street.tiles->raster().scale.pixel, selected);
  street.candidates = std::move(selected.candidates);
  for (std::size_t i = 0; i < edits.size(); ++i) tally.add(*edits[i], results[i]);
  return selected;
}

void write_files(const FoundStreet& street, const StreetPlan& plan, double metres_per_unit, const Crs& crs,
                 const ProductOutput& out) {
  write_objects_gpkg(out.folder / "objects.gpkg", plan, crs);
  write_blocks_gpkg(out.folder / "blocks.gpkg", plan, crs);
  write_kerbs_gpkg(out.folder / "kerbs.gpkg", plan, crs);
  write_pavements_gpkg(out.folder / "pavements.gpkg", plan, metres_per_unit, crs);
  write_trees_gpkg(out.folder / "trees.gpkg", plan, crs);
  write_street_rasters(*street.tiles, out.folder, crs);
  const std::vector<std::string> notes = left_out(street.view, out);
  write_street_map(out.folder, plan, metres_per_unit, notes);
  write_street_book(out.folder, plan, metres_per_unit, notes, street_cover(*street.tiles));
}

}  // namespace

void make_streets(const Store& store, const Settings& settings, const StreetTraining& train, const Crs& crs,
                  const PassContext& context, const ProductOutput& out, std::span<const Edit> edits,
                  StreetSteps* steps) {
  out.progress.begin_stage("streets", 2 * store.points(), {store.points(), "points"});
  std::filesystem::create_directories(out.folder);
  FoundStreet street = find_street(store, settings.streets, context, steps == nullptr ? SeeTile{} : steps->see);
  record_choices(settings.streets, street, out.record);
  const StreetClasses model = street_classes(street, train, crs, out.progress, out.record);
  if (model.trained) write_whole_file(out.folder / "objects.model", object_model_text(*model.trained));
  SelectedObjects selected = selected_objects(model, edits, context, store.unit(), {out.progress, out.record}, street);
  const std::vector<CandidateClass>& classes = selected.classes;
  const std::vector<std::uint8_t>& taken = selected.taken;
  const std::vector<std::uint32_t> candidate_of = candidate_of_part(street.candidates, taken);
  if (!model.trained) name_by_codes(store, *street.tiles, settings, candidate_of, selected, out.record);
  StreetPlan plan;
  std::vector<std::uint32_t> object_of_candidate(street.candidates.size() + 1, 0);
  const StretchIndex blocks(street.stretches, street.tiles->raster().scale, settings.streets.advanced.block_distance);
  const double unit = store.unit();
  for (std::size_t i = 0; i < street.candidates.size(); ++i) {
    const ObjectCandidate& candidate = street.candidates[i];
    if (taken[i] == 0 || !is_street_object(classes[i].label)) continue;
    const bool by_hand = selected.by_hand[i] != 0;
    const bool fence = classes[i].label == PointLabel::fence && street.view == StreetView::street;
    if (!by_hand && (candidate.points < kLeastPoints || (candidate.length > kLongestObject && !fence))) continue;
    StreetObject object = object_of(street, blocks, candidate, classes[i], model.own());
    object.by_hand = by_hand;
    if (context.wanted && !context.wanted({std::llround(object.base.x / unit), std::llround(object.base.y / unit), 0}))
      continue;
    object.id = static_cast<std::uint32_t>(plan.objects.size() + 1);
    object_of_candidate[i + 1] = object.id;
    plan.objects.push_back(object);
  }
  if (steps != nullptr) {
    const SeeTile see = std::move(steps->see);
    *steps = {see,   street.tiles->raster(), street.candidates,   classes,
              taken, candidate_of,           object_of_candidate, plan.objects};
  }
  ObjectLabels labels{{0}, {PointLabel::none}, {0}};
  std::vector<PavementPixel> standing{PavementPixel::object};
  for (std::size_t part = 1; part < candidate_of.size(); ++part) {
    const std::uint32_t candidate = candidate_of[part];
    const PointLabel label = classes[candidate - 1].label;
    labels.object.push_back(object_of_candidate[candidate]);
    labels.label.push_back(is_street_object(label) && object_of_candidate[candidate] == 0 ? PointLabel::none : label);
    labels.top.push_back(top_of(street.candidates[candidate - 1], labels.label.back()));
    standing.push_back(standing_of(label, street.candidates[candidate - 1]));
  }
  add_parts(street, plan);
  add_layers(store, street, labels, settings.streets.least_height, context, standing, plan);
  write_files(street, plan, context.metres_per_unit, crs, out);
  out.record.streets =
      StreetCounts{plan.objects.size(), plan.blocks.size(), plan.gaps.size(),      plan.trees.size(),
                   plan.kerbs.size(),   plan.widths.size(), plan.pavements.size(), plan.carriageways.size()};
  out.progress.end_stage();
}

}  // namespace ilot
