// SPDX-License-Identifier: Apache-2.0
// Models of street objects in files, and what they say of streets.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/products/streets/classes/object_model.h"
#include "study/street_samples.h"

namespace ilot {

ObjectModel read_model(const std::filesystem::path& path);

// The classes that a model gives to the candidates of a street.
std::vector<CandidateClass> classes_of(const Street& street, const ObjectModel& model);

// What the model in a file learns from streets that it was not trained with.
struct HeldOut {
  std::vector<std::string> clouds;  // names of the streets, for its recipe
  bool weights = false;             // those of the roles are learnt too
};

// Learns what probabilities the model in a file states, from the objects that it finds in the streets, and writes it
// again. `samples` are those of all streets.
void learn_stated(std::span<const Street> streets, std::span<const TrainingSample> samples, const HeldOut& from,
                  const std::filesystem::path& path);

}  // namespace ilot
