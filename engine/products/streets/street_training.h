// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/products/streets/make_streets.h"

namespace ilot {

// What things are called by: a model of its own, or the default one with another's classes.
struct StreetClasses {
  const ObjectModel* base = nullptr;        // says what is whole, and what is no object
  std::optional<ObjectModel> trained = {};  // says what objects are called

  std::vector<CandidateClass> of(const std::vector<ObjectCandidate>& candidates) const;
};

// The library's model for clouds scanned from there.
const ObjectModel& library_model(StreetView view);

// Learns from the places of `train` what the things of this street are called, or reads a model that a run wrote
// (objects.model); empty: the library's model. A place belongs to the thing at it, or within half a metre; of what
// joins that with others the largest that holds no other place. Error(usage) where nothing can be learnt.
StreetClasses street_classes(const FoundStreet& street, const StreetTraining& train, const Crs& crs, Progress& progress,
                             RunRecord& record);

}  // namespace ilot
