// SPDX-License-Identifier: Apache-2.0
// Models of street objects in files, and what they say of streets.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "engine/products/streets/classes/object_model.h"
#include "study/street_samples.h"

namespace ilot {

ObjectModel read_model(const std::filesystem::path& path);

// The classes that a model gives to the candidates of a street.
std::vector<CandidateClass> classes_of(const Street& street, const ObjectModel& model);

// Learns what probabilities the model in a file states, from the objects that it finds in streets that it was not
// trained with, and writes it again. `clouds` are the names of the streets, for its recipe.
void learn_stated(const std::vector<Street>& streets, const std::vector<std::string>& clouds,
                  const std::filesystem::path& path);

}  // namespace ilot
