// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/pages/facade_files.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/deliverables/drawings/cad/dxf_reader.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/validity/validate_drawing.h"
#include "tests/support/facades.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::set<std::string> files_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) names.insert(entry.path().filename().string());
  return names;
}

Facade filed_facade() {
  FacadeElement window = drawn("window", wall_rectangle(1, 1, 2, 3));
  window.depth_m = -0.2;
  Facade facade = facade_of({window, drawn("sill", wall_rectangle(0.9, 0.9, 2.1, 1))});
  facade.id = 12;
  return facade;
}

TEST(FacadeFiles, WritesWhatThereIs) {
  const TemporaryFolder flat, whole;
  Facade plain = filed_facade();
  plain.elements[0].depth_m = 0;
  write_facade_files(flat.path(), plain);
  EXPECT_EQ(files_in(flat.path()), (std::set<std::string>{"facade-012.json", "facade-012.dxf", "facade-012.svg",
                                                          "facade-012.pdf", "facade-012.csv"}));

  FacadeFilesParams params;
  FacadesPage page(whole.path() / "facades.html", params.layers);
  params.page = &page;
  params.sections.levels = {2};
  params.points = [](const Box3<Vec3>&, const std::function<void(std::span<const ImagePoint>)>& take) {
    const std::vector<ImagePoint> points{{{1.5, 0.1, 2}, {1, 2, 3}}};
    take(points);
  };
  write_facade_files(whole.path(), filed_facade(), params);
  page.finish();
  EXPECT_EQ(
      files_in(whole.path()),
      (std::set<std::string>{"facade-012.json", "facade-012.dxf", "facade-012.svg", "facade-012.pdf", "facade-012.csv",
                             "facade-012.obj", "facade-012.stl", "facade-012.png", "facade-012.pgw",
                             "facade-012-section-level-2.00.dxf", "facade-012-section-level-2.00.svg",
                             "facade-012-section-level-2.00.pdf", "facades.html"}));
  EXPECT_EQ(facade_json(read_facade_json(whole.path() / "facade-012.json")), facade_json(filed_facade()));
  for (const char* name : {"facade-012.dxf", "facade-012-section-level-2.00.dxf"})
    EXPECT_TRUE(validate_drawing_file(whole.path() / name).empty()) << name;
}

TEST(FacadeFiles, AreTheSameBytesEachTime) {
  const TemporaryFolder once, again;
  write_facade_files(once.path(), filed_facade());
  write_facade_files(again.path(), filed_facade());
  for (const std::string& name : files_in(once.path()))
    EXPECT_EQ(test::file_bytes(once.path() / name), test::file_bytes(again.path() / name));
}

// DXF and SVG come from one drawing: what one shows the other has, on the layer of the same name.
TEST(FacadeFiles, DxfAndSvgAgree) {
  const TemporaryFolder folder;
  write_facade_files(folder.path(), filed_facade());
  const std::string svg = test::file_bytes(folder.path() / "facade-012.svg");
  constexpr std::size_t kLinesOfDimension = 5;
  std::size_t paths = 0, texts = 0, drawn_texts = 0, drawn_paths = 0;
  for (std::size_t at = svg.find("<path"); at != std::string::npos; at = svg.find("<path", at + 1)) ++paths;
  for (std::size_t at = svg.find("<text"); at != std::string::npos; at = svg.find("<text", at + 1)) ++texts;
  const DxfDrawing dxf = read_dxf(folder.path() / "facade-012.dxf");
  for (const DxfEntity& e : dxf.entities) {
    if (e.layer == "Defpoints") continue;  // the edge of the paper
    drawn_texts += e.type == "TEXT" || e.type == "DIMENSION";
    drawn_paths += e.type == "LWPOLYLINE" || e.type == "ARC" || e.type == "POINT";
    drawn_paths += e.type == "DIMENSION" ? kLinesOfDimension : 0;
    EXPECT_NE(svg.find("data-layer=\"" + e.layer + "\""), std::string::npos) << e.layer;
  }
  EXPECT_EQ(texts, drawn_texts);
  EXPECT_EQ(paths, drawn_paths);
}

}  // namespace
}  // namespace ilot
