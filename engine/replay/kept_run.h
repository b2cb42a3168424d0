// SPDX-License-Identifier: Apache-2.0
// A finished run whose store was kept. It is opened so that one of its units can be computed again.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/pass/index.h"
#include "engine/products/streets/make_streets.h"
#include "engine/report/progress.h"
#include "engine/run/inputs/open_inputs.h"
#include "engine/run/options.h"

namespace ilot {

struct KeptRunPlaces {
  std::filesystem::path out;
  std::filesystem::path store;               // empty = out/.store
  std::filesystem::path stations;            // stations that the run was given, if any: run.json does not name the file
  std::vector<std::filesystem::path> edits;  // likewise
  std::optional<Area> within;                // polygons that the run was given, if any: run.json has only their box
  TrainObjectModel learn;                    // the training method of the run, for places of objects
};

// A folder that looks like a store: every file in it is a link to a file of the kept store. The output of a pass
// replaces the link, so the kept store does not change. The folder is removed at the end.
class ScratchStore {
 public:
  ScratchStore(const std::filesystem::path& kept, std::filesystem::path scratch);
  ~ScratchStore();
  ScratchStore(const ScratchStore&) = delete;
  ScratchStore& operator=(const ScratchStore&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

// Returns the options of the run as run.json records them. Throws a usage Error when there is no run, when another one
// works there, or when its store was not kept.
RunOptions kept_options(const KeptRunPlaces& places);

// All inputs of the products. The store is a ScratchStore in `scratch`.
class KeptRun {
 public:
  // Throws a usage Error that names what has changed: inputs, footprints, settings.
  KeptRun(const KeptRunPlaces& places, const std::filesystem::path& scratch, Progress& progress);
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  const RunOptions& options() const { return options_; }
  const RunInputs& inputs() const { return inputs_; }
  const PassContext& context() const { return context_; }
  const Store& store() const { return index_->store; }
  const StreetTraining& training() const { return training_; }
  bool made(const char* product) const;

 private:
  RunOptions options_;
  StreetTraining training_;
  RunInputs inputs_;
  PassContext context_;
  std::optional<ScratchStore> scratch_;
  std::optional<IndexResult> index_;
};

// The content of a file; empty when it cannot be read.
std::string text_of(const std::filesystem::path& path);

}  // namespace ilot
