// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/model/segment.h"
#include "engine/whole_file_writer.h"

namespace ilot {

// Writes a header line, then one line for each pair of planes that touch. Columns and units: docs/outputs.md. Numbers
// are the shortest ones that are read back as the same bits. No file appears before finish().
class PlanesNeighboursCsv {
 public:
  explicit PlanesNeighboursCsv(const std::filesystem::path& path);
  void add(const PlaneNeighbours& pair);
  void finish() { file_.finish(); }

 private:
  WholeFileWriter file_;
};

}  // namespace ilot
