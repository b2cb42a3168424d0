// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/products/streets/make_streets.h"

namespace ilot {

// The models that give object candidates their classes: a base model and, where one was trained, a second model with
// its classes.
struct StreetClasses {
  const ObjectModel* base = nullptr;        // decides which candidates are whole and which are no objects
  std::optional<ObjectModel> trained = {};  // decides the class of each object

  std::vector<CandidateClass> of(const std::vector<ObjectCandidate>& candidates) const;
  const OwnClasses& own() const { return trained ? trained->own : base->own; }
};

// The model of the library for clouds with this view.
const ObjectModel& library_model(StreetView view);

// Trains the classes of this street's objects on the places in `train`, or reads a model that an earlier run wrote
// (objects.model). If `train` is empty, the model of the library is used. A place belongs to the separated candidate at
// that place, or to the nearest one within half a metre. Of the joins that contain this candidate, the largest one that
// contains no other place is the sample. Names that are none of ours are classes of one's own. How many samples a model
// of the other folds classifies as they are stands in the model's recipe and in the record. Throws Error(usage) where
// nothing can be trained.
StreetClasses street_classes(const FoundStreet& street, const StreetTraining& train, const Crs& crs, Progress& progress,
                             RunRecord& record);

}  // namespace ilot
