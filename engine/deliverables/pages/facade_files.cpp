// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facade_files.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "engine/deliverables/drawings/cad/dxf_writer.h"
#include "engine/deliverables/drawings/drawing_pdf.h"
#include "engine/deliverables/drawings/drawing_svg.h"
#include "engine/deliverables/solids/facade_solids.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/facade_table.h"
#include "engine/whole_file.h"

namespace ilot {

namespace {

constexpr double kPointCellMm = 0.2;  // on paper, of points in sections

void write_drawing(const std::filesystem::path& folder, const std::string& name, const Drawing& drawing,
                   const DrawingLayers& layers) {
  write_drawing_dxf(folder / (name + ".dxf"), drawing, layers);
  write_drawing_svg(folder / (name + ".svg"), drawing, layers);
  write_drawing_pdf(folder / (name + ".pdf"), drawing, layers);
}

void write_sections(const std::filesystem::path& folder, const Facade& facade, const FacadeFilesParams& params) {
  const double metres = params.drawing.metres_per_unit, cell = kPointCellMm * params.drawing.scale / 1000;
  const std::vector<NamedSection> sections = named_sections(facade, params.sections, metres, params.drawing.language);
  if (sections.empty()) return;
  const std::vector<SectionFace> faces = facade_faces(facade, metres);
  std::vector<SectionPoints> points;
  for (const NamedSection& section : sections) points.emplace_back(section.plane, params.section_half_m, cell, metres);
  constexpr Box3<Vec3> kEverywhere{{-INFINITY, -INFINITY, -INFINITY}, {INFINITY, INFINITY, INFINITY}};
  if (params.points)
    params.points(kEverywhere, [&](std::span<const ImagePoint> given) {
      std::vector<Vec3> places;
      for (const ImagePoint& p : given) places.push_back(p.position);
      for (SectionPoints& near : points) near.add(places);
    });
  for (std::size_t i = 0; i < points.size(); ++i) {
    const NamedSection& section = sections[i];
    const Drawing drawing =
        section_drawing(facade, section.plane, faces, points[i].places(), section.title, params.drawing);
    write_drawing(folder, facade_name(facade.id) + "-" + section.file, drawing, params.layers);
  }
}

std::optional<DrawingImage> write_image(const std::filesystem::path& folder, const Facade& facade,
                                        const FacadeFilesParams& params) {
  if (!params.points) return std::nullopt;
  FacadeImageParams wanted = params.image;
  wanted.metres_per_unit = params.drawing.metres_per_unit;
  const FacadeImage image = facade_image(facade, params.points, wanted);
  const std::string name = facade_name(facade.id) + ".png";
  write_facade_image(folder / name, image);
  if (image.width == 0 || image.height == 0) return std::nullopt;
  return DrawingImage{name, image.width, image.height, image.place};
}

}  // namespace

std::string facade_name(std::uint32_t id) {
  return fmt::format("facade-{:03}", id);
}

void write_row_files(const std::filesystem::path& folder, std::uint32_t row, std::span<const Facade> houses,
                     const FacadeFilesParams& params) {
  write_drawing(folder, fmt::format("row-{:03}", row), row_drawing(houses, params.drawing), params.layers);
}

void write_facade_files(const std::filesystem::path& folder, const Facade& facade, const FacadeFilesParams& params) {
  const std::string name = facade_name(facade.id);
  const auto named = [&](const char* extension) { return folder / (name + extension); };
  FacadeDrawingParams of_drawing = params.drawing;
  of_drawing.sections = params.sections;
  Drawing drawing = facade_drawing(facade, of_drawing);
  drawing.image = write_image(folder, facade, params);
  write_facade_json(named(".json"), facade);
  write_drawing(folder, name, drawing, params.layers);
  write_whole_file(named(".csv"), facade_table(facade, params.drawing.metres_per_unit));
  std::vector<FacadeSolid> solids = facade_solids(facade, params.drawing.metres_per_unit);
  const std::vector<FacadeSolid> meshes = facade_meshes(facade);
  solids.insert(solids.end(), meshes.begin(), meshes.end());
  if (!solids.empty()) {
    write_whole_file(named(".obj"), solids_obj(solids));
    write_whole_file(named(".stl"), solids_stl(solids));
  }
  write_sections(folder, facade, params);
  if (!params.page) return;
  std::optional<SvgUnderlay> under;
  if (drawing.image) under = SvgUnderlay{drawing.image->file, drawing.image->place};
  params.page->add(facade, drawing, under, params.drawing.metres_per_unit);
}

}  // namespace ilot
