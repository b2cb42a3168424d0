// SPDX-License-Identifier: Apache-2.0
// Object candidates of scanned streets with their truth. A classifier learns from them and is evaluated on them.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/products/streets/classes/training_sample.h"
#include "ilot/settings.h"
#include "study/cut_reader.h"
#include "study/street_bounds.h"

namespace ilot {

// The result for one cloud: object candidates with their truth, and the number of objects that could be found.
struct Street {
  std::vector<TrainingSample> samples;           // groups are blocks
  std::vector<ObjectCandidate> candidates;       // of the samples, with pixels and parts; all only after study()
  std::vector<std::uint32_t> object;             // the object that a sample overlaps by half; 0 = none
  std::vector<double> overlaps;                  // overlap with that object: intersection over union of the points
  std::map<std::string, std::uint64_t> objects;  // objects that were seen, by class
  std::map<std::uint32_t, PointLabel> classes;   // of objects
  std::uint64_t blocks = 0, ground = 0, ground_found = 0;
  StreetBounds bounds;                     // without trunks; only after study()
  std::map<std::uint32_t, double> unions;  // by object: greatest overlap of any union of parts; only after study()
  StreetView view = StreetView::street;    // only after study()
};

// Returns the classes of objects as truth files name them.
const std::vector<std::string>& object_classes();
PointLabel label_of(const std::string& name);
std::string name_of(PointLabel label);

// Finds the object candidates of a cloud as a run does, and compares them with the truth in the same folder. Prints the
// objects that no candidate overlaps by half. Throws where there is no truth. The trunks of trees are objects too, of
// class other.
Street study(const std::filesystem::path& cloud, const Leaving& leaving = {});

// Writes the result of study() to a file, and reads it back.
void save(const Street& street, const std::filesystem::path& path);
Street load(const std::filesystem::path& path);

// Returns for each object that is found the sample that overlaps it best, by the number of the object.
std::map<std::uint32_t, std::size_t> best_samples(const Street& street);

// Gives samples their roles. Among the candidates that overlap an object by half, the best one and those nearly as good
// are the object. Candidates below them in the tree of joins are parts of it. Candidates above them are merged.
void set_roles(Street& street);

}  // namespace ilot
