// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/model/street.h"
#include "engine/products/streets/blocks/city_blocks.h"
#include "engine/products/streets/classes/object_model.h"
#include "engine/products/streets/classes/training_sample.h"
#include "engine/products/streets/ground/tiled_ground.h"
#include "engine/products/streets/street_tiles.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"

namespace ilot {

// A street taken apart, before anything is called by its name.
struct FoundStreet {
  std::unique_ptr<StreetTiles> tiles;       // all layers
  std::vector<ObjectCandidate> candidates;  // by number in the layer "candidates", from 1
  std::vector<StreetStretch> stretches;
  GroundZones ground;
  PointDensity density;
  StreetView view = StreetView::street;  // where it was scanned from
};

// From the images to the features of all that stands there (Hernandez and Marcotegui 2008, 2.2 to 5.2). Works in tiles
// on disk; memory is that of a few tiles and of their borders.
FoundStreet find_street(const Store& store, const StreetsSettings& settings, const PassContext& context,
                        const SeeTile& see = {});

// Metres of a pixel of a street's raster, and what it was chosen by.
struct StreetPixel {
  PointDensity density;
  StreetView view = StreetView::street;
  double metres = 0;
};
StreetPixel street_pixel(const Store& store, const StreetsSettings& settings, const PassContext& context);

// What things on streets are, to learn from.
struct StreetTraining {
  std::filesystem::path places;  // or a model that a run wrote; empty = none
  TrainObjectModel learn;        // how places become a model; empty: only models are read
};

// What was found on the way to a StreetPlan, for whoever looks for the step that went wrong.
struct StreetSteps {
  SeeTile see;  // given; the images as they are written
  std::optional<TileRaster> raster;
  std::vector<ObjectCandidate> candidates;  // parts, then what joins them (find_object_candidates)
  std::vector<CandidateClass> classes;
  std::vector<std::uint8_t> taken;  // per thing: it is whole
  std::vector<std::uint32_t>
      candidate_of_part;                 // per number in the layer "candidates" the thing that was taken; [0] = 0
  std::vector<std::uint32_t> object_of;  // per thing + 1: the object that it is, 0 for none
  std::vector<StreetObject> objects;
};

// find_street, the class of each thing by the default model or as learnt from `train` (street_classes), and all that is
// written: the files of `folder` (streets/) and the column "street" (StreetLabel) of every block. Objects whose base is
// not wanted are left out. Where `steps` are given they are filled.
void make_streets(const Store& store, const Settings& settings, const StreetTraining& train, const Crs& crs,
                  const PassContext& context, const std::filesystem::path& folder, Progress& progress,
                  RunRecord& record, StreetSteps* steps = nullptr);

}  // namespace ilot
