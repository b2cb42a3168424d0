// SPDX-License-Identifier: Apache-2.0
// What a run needs to know about a product. Each product has one record (products/NAME/product.h);
// engine/run/products.h lists them.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/columns/run_inputs.h"
#include "engine/model/facade_opening.h"
#include "engine/pass/context.h"
#include "engine/pass/measure.h"
#include "engine/products/product_labels.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

struct PlanesResult;
struct PlannedSite;
struct StreetTraining;

// The input of a product, and what products pass on to each other.
struct ProductRun {
  const Store& store;
  const RunInputs& inputs;
  const Settings& settings;
  const PassContext& context;
  const std::vector<PlannedSite>* footprints = nullptr;  // nullptr: no file of footprints was given
  const StreetTraining* training = nullptr;
  std::function<bool(const char* product)> asked;  // whether the product is asked for by --products
  bool outlines_wanted = false;                    // a product that is found among planes follows
  std::filesystem::path folder;                    // folder of all results
  Progress& progress;
  RunRecord& record;
  std::shared_ptr<PlanesResult> planes = nullptr;  // by the product planes, for products that are found among planes
  std::vector<FacadeOpening> openings = {};        // by the product facades, for buildings
};

// Whether a cloud suits a product, and the reason as half a sentence.
struct Suitability {
  bool yes = false;
  std::string reason;
};

// The cost per point that a product adds to the index: bytes of the store, bytes of the results, microseconds of one
// processor.
struct ProductCost {
  double store_bytes = 0, result_bytes = 0, microseconds = 0;
};

struct Product {
  const char* name = "";            // name in --products and run.json, of its settings and of its folder
  bool found_among_planes = false;  // the planes are made first, even if they are not asked for
  bool reads_classes = false;       // the store keeps class codes and echoes for the product
  bool reads_colours = false;       // it reads the column "colour" where an input has colours
  bool reads_stations = false;      // it reads the column "station" where there are several stations
  ProductCost cost;
  Suitability (*suitability)(const CloudInfo& info, const CloudMeasure& measure) = nullptr;
  // Makes the product: its columns in the store, its files, and its counts in the record. A product that finds nothing
  // is recorded as skipped, with the reason.
  void (*make)(ProductRun& run) = nullptr;
  // What it says of points, after all products are made; run.planes is still set. Takes from the run what it needs.
  ProductLabels (*labels)(ProductRun& run) = nullptr;
  std::string (*summary)(const RunRecord& record) = nullptr;  // "12 buildings"; empty: the product did not run
  const char* main_file = "";                                 // of its results, the one to open first; relative to OUT
};

// Records that a product was skipped, and reports it.
void skip_product(ProductRun& run, const Product& product, const std::string& reason);

// A text such as "0.021 m between points".
std::string step_text(const CloudMeasure& measure);

}  // namespace ilot
