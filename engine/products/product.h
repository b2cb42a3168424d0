// SPDX-License-Identifier: Apache-2.0
// What a run knows of a product. Each product has one record (products/NAME/product.h); engine/run/products.h lists
// them.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/pass/measure.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/store.h"

namespace ilot {

struct PlanesResult;
struct PlannedSite;
struct StreetTraining;

// What a product is given, and what products leave for each other.
struct ProductRun {
  const Store& store;
  const RunInputs& inputs;
  const Settings& settings;
  const PassContext& context;
  const std::vector<PlannedSite>* footprints = nullptr;  // nullptr: no file of them was given
  const StreetTraining* training = nullptr;
  std::function<bool(const char* product)> asked;  // by --products
  std::filesystem::path folder;                    // of all results
  Progress& progress;
  RunRecord& record;
  std::shared_ptr<PlanesResult> planes = nullptr;  // by the product planes, which products found among planes use
};

// Whether a cloud suits a product, and why: half a sentence.
struct Suitability {
  bool yes = false;
  std::string reason;
};

// What a product adds to the index, each point: bytes of the store and of the results, seconds of one processor.
struct ProductCost {
  double store_bytes = 0, result_bytes = 0, microseconds = 0;
};

struct Product {
  const char* name = "";            // in --products and run.json, of its settings and of its folder
  bool found_among_planes = false;  // planes are made first, asked for or not
  bool reads_classes = false;       // the store keeps class codes and echoes for it
  ProductCost cost;
  Suitability (*suitability)(const CloudInfo& info, const CloudMeasure& measure) = nullptr;
  // Makes the product: its columns in the store, its files, its counts in the record. A product of nothing is recorded
  // as skipped, with the reason.
  void (*make)(ProductRun& run) = nullptr;
  std::string (*summary)(const RunRecord& record) = nullptr;  // "12 buildings"; empty: it did not run
};

// Records that a product came to nothing, and says so.
void skip_product(ProductRun& run, const Product& product, const std::string& reason);

// "0.021 m between points".
std::string step_text(const CloudMeasure& measure);

}  // namespace ilot
