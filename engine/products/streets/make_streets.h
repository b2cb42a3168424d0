// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/edit.h"
#include "engine/model/street.h"
#include "engine/products/product_output.h"
#include "engine/products/streets/blocks/city_blocks.h"
#include "engine/products/streets/classes/object_model.h"
#include "engine/products/streets/classes/training_sample.h"
#include "engine/products/streets/ground/terrain.h"
#include "engine/products/streets/street_tiles.h"
#include "engine/settings/settings.h"

namespace ilot {

// A street that is segmented but not yet classified.
struct FoundStreet {
  std::unique_ptr<StreetTiles> tiles;       // all layers
  std::vector<ObjectCandidate> candidates;  // by number in the layer "candidates", from 1
  std::vector<StreetStretch> stretches;
  TerrainCounts terrain;
  PointDensity density;
  StreetView view = StreetView::street;  // where it was scanned from
};

// Runs all steps from the images to the features of the object candidates [Hernandez and Marcotegui 2008, 2.2 to 5.2].
// It works in tiles on disk. The memory is that of a few tiles and of the borders of all tiles.
FoundStreet find_street(const Store& store, const StreetsSettings& settings, const PassContext& context,
                        const SeeTile& see = {});

// The size of a pixel of a street's raster, and the values from which it was chosen.
struct StreetPixel {
  PointDensity density;
  StreetView view = StreetView::street;
  double metres = 0;
};
StreetPixel street_pixel(const Store& store, const StreetsSettings& settings, const PassContext& context);

// The training data for the classes of objects on streets.
struct StreetTraining {
  std::filesystem::path places;  // places of known objects, or a model that a run wrote; empty = none
  TrainObjectModel learn;        // trains a model from places; empty: only models are read
};

// The intermediate results of a StreetPlan, for anyone who looks for the step that went wrong.
struct StreetSteps {
  SeeTile see;  // input; receives the images as they are written
  std::optional<TileRaster> raster;
  std::vector<ObjectCandidate> candidates;  // parts, then their joins (find_object_candidates)
  std::vector<CandidateClass> classes;
  std::vector<std::uint8_t> taken;               // per candidate: 1 = it is selected as whole
  std::vector<std::uint32_t> candidate_of_part;  // per number in the layer "candidates": the taken candidate; [0] = 0
  std::vector<std::uint32_t> object_of;          // per candidate + 1: its object, 0 for none
  std::vector<StreetObject> objects;
};

// Runs find_street, classifies each candidate by the default model or by one that is trained from `train`
// (street_classes), and writes all results: the files of the folder (streets/) and the column "street" (StreetLabel) of
// every block. Objects whose base lies outside of the wanted area are left out. Of the `edits` those of streets are
// made on the objects (edits/object_edits.h) and counted in the record. If `steps` is given, it is filled.
void make_streets(const Store& store, const Settings& settings, const StreetTraining& train, const Crs& crs,
                  const PassContext& context, const ProductOutput& out, std::span<const Edit> edits = {},
                  StreetSteps* steps = nullptr);

}  // namespace ilot
