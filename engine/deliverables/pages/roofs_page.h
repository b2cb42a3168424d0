// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "engine/model/building.h"

namespace ilot {

// roofs.html: how many buildings have each status, a plan of the roofs, and drawings over points of the cloud. Drawn
// are the buildings with most points off their faces, those with the most faces, and some that are chosen by chance. It
// is one file that needs no other; the same buildings give the same bytes. Memory is bounded: after a certain number of
// faces the plan ends and says so.
class RoofsPage {
 public:
  RoofsPage(const std::filesystem::path& path, double metres_per_unit)
      : path_(path), metres_per_unit_(metres_per_unit) {}

  // Adds a building with its levels of detail. The first level has the attributes under their plain names
  // (building_fields.h). `points` are all or some of its points (coordinates of the CRS), `share_off` is the share of
  // its points that lie on no face.
  void add(std::span<const Building> levels, std::span<const Vec3> points, double share_off);

  // Writes the file. Throws Error.
  void finish();

 private:
  struct Sample {
    std::string id, caption;
    Building building;  // its finest level
    std::vector<Vec3> points;
  };
  struct Choice {
    const char* title;
    std::multimap<double, Sample> samples;  // by rank; the last ones are removed when there are too many
  };

  void draw_in_plan(const Building& building, const std::string& caption);
  void keep(Choice& choice, double rank, const Sample& sample);

  std::filesystem::path path_;
  double metres_per_unit_;
  std::map<std::string, std::uint64_t> by_status_;
  std::vector<std::array<std::string, 3>> fallen_;  // id, status, reason
  std::uint64_t buildings_ = 0, drawn_ = 0, faces_drawn_ = 0;
  std::string plan_;
  Vec3 origin_;
  std::array<double, 4> frame_{};  // of the plan: left, top, right, bottom
  std::array<Choice, 3> choices_{{{"Most points off their faces", {}}, {"Most faces", {}}, {"By lot", {}}}};
};

}  // namespace ilot
