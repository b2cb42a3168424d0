// SPDX-License-Identifier: Apache-2.0
// Things of scanned streets beside their truth: what a machine that calls them by name learns from and is judged by.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"

namespace ilot {

// What one cloud gave: things with their truth, and how many objects there were to find.
struct Street {
  std::vector<TrainingSample> samples;      // groups are blocks
  std::vector<ObjectCandidate> candidates;  // of the samples: pixels and parts; all of them only where just studied
  std::vector<std::uint32_t> object;        // that a sample overlaps by half; 0 = none
  std::vector<double> overlaps;             // with it: common points over those of both
  std::map<std::string, std::uint64_t> objects;  // seen, by class
  std::map<std::uint32_t, PointLabel> classes;   // of objects
  std::uint64_t blocks = 0, ground = 0, ground_found = 0;
};

// The classes of objects, as truth files name them.
const std::vector<std::string>& object_classes();
PointLabel label_of(const std::string& name);
std::string name_of(PointLabel label);

// Finds a cloud's things as a run does and compares them with the truth beside it; prints the objects that no thing
// overlaps by half. Throws where there is no truth. cut > 0: without what is higher above the road, metres; the trunks
// of trees are objects then, of class other.
Street study(const std::filesystem::path& cloud, double cut = 0);

// A file of what was studied, and back.
void save(const Street& street, const std::filesystem::path& path);
Street load(const std::filesystem::path& path);

// Of each object that is found the sample that overlaps it best, by the object's number.
std::map<std::uint32_t, std::size_t> best_samples(const Street& street);

// Gives samples their roles: of the things that overlap an object by half the best one and those nearly as good are
// it; what lies below in the tree of joins is part of it, what lies above is several.
void set_roles(Street& street);

}  // namespace ilot
