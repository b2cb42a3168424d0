// SPDX-License-Identifier: Apache-2.0
// A STEP file (ISO 10303-21) with the frame of an IFC 4.3 model (ISO 16739-1).
#pragma once
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/deliverables/exports/export_frame.h"
#include "engine/formats/file.h"

namespace ilot {

using StepId = std::uint32_t;

// How values stand in a STEP file: a text in quotes, ASCII alone; a real with its point; a list of references.
std::string step_text(std::string_view text);
std::string step_real(double value);
std::string step_place(Vec3 place);  // (x,y,z)
std::string step_list(const std::vector<StepId>& ids);

// A globally unique id that depends on the words alone, as IFC writes it: 22 characters, in quotes.
std::string ifc_guid(std::initializer_list<std::string_view> words);

// Writes entities as they come, numbered from 1. The file appears at finish() or not at all.
class StepFile {
 public:
  explicit StepFile(const std::filesystem::path& path);
  StepId add(const std::string& entity);  // "IFCWALL(...)"
  void finish();

  const std::filesystem::path& path() const { return file_.path(); }

 private:
  OutputFile file_;
  StepId last_ = 0;
};

// The parts of a model that everything else refers to.
struct IfcModel {
  StepId project = 0, context = 0, site = 0, site_placement = 0;
};

// Metres from the frame's origin, which IfcMapConversion states where the CRS is known, and the description of the site
// otherwise.
IfcModel ifc_start(StepFile& file, const ExportFrame& frame, const std::string& name);

StepId ifc_placement(StepFile& file, StepId beside, Vec3 at, Vec3 axis = {0, 0, 1}, Vec3 right = {1, 0, 0});
StepId ifc_shape(StepFile& file, const IfcModel& model, const char* kind, StepId item);
void ifc_aggregate(StepFile& file, std::string_view words, StepId whole, const std::vector<StepId>& parts);
void ifc_contain(StepFile& file, std::string_view words, StepId building, const std::vector<StepId>& elements);

// Name and typed value: "IFCLENGTHMEASURE(1.2)". The set belongs to the element.
using IfcProperties = std::vector<std::pair<std::string, std::string>>;
void ifc_properties(StepFile& file, std::string_view words, StepId element, const char* set,
                    const IfcProperties& properties);

}  // namespace ilot
