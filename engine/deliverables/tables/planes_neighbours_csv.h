// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/model/segment.h"
#include "engine/whole_file_writer.h"

namespace ilot {

// One line per pair of planes that touch, header line first. Columns and units: docs/outputs.md. Numbers are the
// shortest that read back to the same bits. Nothing appears before finish().
class PlanesNeighboursCsv {
 public:
  explicit PlanesNeighboursCsv(const std::filesystem::path& path);
  void add(const PlaneNeighbours& pair);
  void finish() { file_.finish(); }

 private:
  WholeFileWriter file_;
};

}  // namespace ilot
