// SPDX-License-Identifier: Apache-2.0
#include "engine/labels/labelled_clouds.h"

#include <gtest/gtest.h>

#include "engine/products/facades/facade_labels.h"
#include "engine/products/planes/plane_labels.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/streets/street_labels.h"
#include "kernels/neighbours/normals.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

using test::CloudStore;

std::uint32_t plane_of(InputOrder order) {
  return static_cast<std::uint32_t>((row_of(order) * 7 + file_of(order)) % 5);
}

// Labels that are a function of the input row, as if passes had found them.
void write_labels(const Store& store) {
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) {
    std::vector<std::uint32_t> plane;
    std::vector<PackedNormal> normal;
    std::vector<std::uint8_t> boundary;
    for (const InputOrder order : store.read(b, columns::kOrder)) {
      plane.push_back(plane_of(order));
      normal.push_back({static_cast<std::int16_t>(row_of(order) % 30000), -32767, 0, 0});
      boundary.push_back(row_of(order) % 3 == 0);
    }
    store.write(b, columns::kPlane, plane);
    store.write(b, columns::kNormals, normal);
    store.write(b, columns::kBoundary, boundary);
  }
}

// Four times the plane z = 0.
std::vector<JoinedPlane> level_planes() {
  return std::vector<JoinedPlane>(4);
}

struct Rows {
  std::vector<std::byte> bytes;
  std::size_t length = 0, count = 0;
};

Rows read_rows(PointReader& reader) {
  Rows rows{{}, reader.info().layout.record_length, reader.info().points};
  rows.bytes.resize(rows.length * rows.count);
  std::vector<std::uint8_t> valid(rows.count);
  EXPECT_EQ(reader.read(0, rows.bytes, valid), rows.count);
  return rows;
}

std::size_t offset_of_label(const PointReader& reader) {
  for (const ExtraField& field : reader.info().layout.extra)
    if (field.name == "label") return field.offset;
  throw std::out_of_range("label");
}

TEST(LabelledClouds, RowsComeBackInInputOrderWithAllTheirBytes) {
  const auto points = test::points_over_tiles(12000, 1);
  for (const auto& [block_points, in_memory] :
       {std::pair{1u << 20, false}, std::pair{900u, false}, std::pair{1u << 20, true}, std::pair{900u, true}}) {
    const CloudStore cloud(points, {block_points, 2000, 3});
    write_labels(cloud.store());
    const std::vector<std::uint32_t> final_id{0, 3, 0, 1, 2};  // joined plane 2 was dropped
    const std::vector<ProductLabels> labels{plane_labels({final_id, level_planes(), true})};
    PassContext context;
    context.metres_per_unit = 0.5;
    std::uint64_t expected = 0;
    std::optional<RowsInMemory> rows;
    if (in_memory) {
      std::vector<std::uint64_t> counts;
      for (const auto& input : cloud.inputs()) counts.push_back(input->info().points);
      context.budget_bytes = 1;
      EXPECT_FALSE(rows_in_memory(cloud.store(), counts, labels, context).has_value());
      context.budget_bytes = std::uint64_t{1} << 30;
      rows = rows_in_memory(cloud.store(), counts, labels, context);
      ASSERT_TRUE(rows.has_value());
      EXPECT_FALSE(cloud.store().has(0, columns::kPlaneRows));
    } else {
      rows_pass(cloud.store(), labels, {});
    }
    const std::uint64_t labelled = write_labelled_clouds(cloud.store(), cloud.inputs(), labels, cloud.folder() / "out",
                                                         {context, false, rows ? &*rows : nullptr});
    for (std::uint64_t f = 0; f < 3; ++f) {
      const auto out = open_cloud(cloud.folder() / "out" / ("cloud" + std::to_string(f) + ".laz"));
      const Rows was = read_rows(*cloud.inputs()[f]), is = read_rows(*out);
      ASSERT_EQ(is.count, was.count);
      ASSERT_EQ(is.length, was.length + 4 + 4 + 1 + 12);
      for (std::size_t i = 0; i < is.count; ++i) {
        const std::byte* row = is.bytes.data() + i * is.length;
        const std::byte* before = was.bytes.data() + i * was.length;
        ASSERT_TRUE(std::equal(before, before + was.length, row)) << "file " << f << " row " << i;
        const std::uint32_t id = final_id[plane_of(input_order(f, i))];
        ASSERT_EQ(load<std::uint32_t>(row + was.length), id);
        const double z = 0.5 * test::kUnit * load<std::int32_t>(before + 8);
        ASSERT_EQ(load<float>(row + was.length + 4), id == 0 ? 0.0f : static_cast<float>(z));
        ASSERT_EQ(load<std::uint8_t>(row + was.length + 8), i % 3 == 0);
        ASSERT_EQ(load<float>(row + was.length + 9), static_cast<float>(i % 30000) / 32767.0f);
        ASSERT_EQ(load<float>(row + was.length + 13), -1.0f);
        expected += id != 0;
      }
    }
    EXPECT_EQ(labelled, expected);
  }
}

// Names that are made unique must not meet a name that some other input has by itself.
TEST(LabelledClouds, NoInputOverwritesTheOutputOfAnother) {
  const TemporaryFolder folder;
  std::vector<std::unique_ptr<PointReader>> inputs;
  std::int64_t x = 0;
  for (const char* name : {"p/x/a.las", "q/x/a.las", "r/x_a_2.las", "s/x_a.las", "t/x/a.las"}) {
    std::filesystem::create_directories((folder.path() / name).parent_path());
    test::write_cloud(folder.path() / name, {{++x, 0, 0}});
    inputs.push_back(open_cloud(folder.path() / name));
  }
  IndexParams params;
  params.unit = test::kUnit;
  const Store store = build_index(inputs, params, folder.path() / "store", {}).store;
  write_labels(store);
  const std::vector<ProductLabels> labels{plane_labels({{0, 1, 2, 3, 4}, level_planes(), false})};
  rows_pass(store, labels, {});
  write_labelled_clouds(store, inputs, labels, folder.path() / "out", {});
  std::vector<std::int32_t> found;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "out"))
    found.push_back(load<std::int32_t>(read_rows(*open_cloud(entry.path())).bytes.data()));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, (std::vector<std::int32_t>{1, 2, 3, 4, 5}));
}

// The streams of compressed inputs are copied, those of others coded: what comes out holds the same rows.
TEST(LabelledClouds, CompressedInputsGiveTheSameRows) {
  const TemporaryFolder folder;
  const auto points = test::points_over_tiles(3000, 4);
  std::vector<std::uint8_t> classes(points.size());
  for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = static_cast<std::uint8_t>(i % 7);
  std::vector<Rows> outputs;
  for (const char* name : {"c.las", "c.laz"}) {
    test::write_cloud(folder.path() / name, points, classes, 7);
    const test::FilesStore files(folder.path(), {name}, 900);
    write_labels(*files.cloud);
    const std::vector<ProductLabels> labels{plane_labels({{0, 1, 2, 3, 4}, level_planes(), true})};
    rows_pass(*files.cloud, labels, {});
    write_labelled_clouds(*files.cloud, files.inputs, labels, folder.path() / "out", {});
    outputs.push_back(read_rows(*open_cloud(folder.path() / "out" / "c.laz")));
    std::filesystem::remove_all(folder.path() / "store");
  }
  EXPECT_EQ(outputs[0].length, standard_size(7) + 21);
  EXPECT_EQ(outputs[0].count, points.size());
  EXPECT_TRUE(outputs[0].bytes == outputs[1].bytes);
}

// A cloud that has labels already, as that of an earlier run: its fields keep their values under names of their own.
TEST(LabelledClouds, FieldsOfTheInputWithOurNamesAreSetApart) {
  const TemporaryFolder folder;
  test::write_cloud(folder.path() / "c.laz", test::points_over_tiles(500, 2));
  fs::path input = folder.path() / "c.laz";
  std::vector<std::string> names;
  for (const char* out : {"first", "second", "third"}) {
    fs::create_directories(folder.path() / out);
    fs::copy_file(input, folder.path() / out / "c.laz");
    const test::FilesStore files(folder.path() / out, {"c.laz"}, 900);
    write_labels(*files.cloud);
    const std::vector<ProductLabels> labels{plane_labels({{0, 1, 2, 3, 4}, level_planes(), true})};
    rows_pass(*files.cloud, labels, {});
    write_labelled_clouds(*files.cloud, files.inputs, labels, folder.path() / out / "points", {});
    const Rows was = read_rows(*files.inputs[0]);
    input = folder.path() / out / "points" / "c.laz";
    const auto cloud = open_cloud(input);
    const Rows is = read_rows(*cloud);
    ASSERT_EQ(is.count, was.count);
    for (std::size_t i = 0; i < is.count; ++i)
      ASSERT_TRUE(std::equal(was.bytes.begin() + static_cast<std::ptrdiff_t>(i * was.length),
                             was.bytes.begin() + static_cast<std::ptrdiff_t>((i + 1) * was.length),
                             is.bytes.begin() + static_cast<std::ptrdiff_t>(i * is.length)));
    names.clear();
    for (const ExtraField& field : cloud->info().layout.extra) names.push_back(field.name);
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size()) << "no name is there twice";
  }
  for (const char* name : {"plane_id", "plane_id_input", "plane_id_input2"})
    EXPECT_TRUE(std::ranges::find(names, name) != names.end()) << name;
}

// Points of the classes 0 and 1 get the class of their label, whatever the format; other classes and all other bytes
// stay.
TEST(LabelledClouds, ClassesAreWrittenWhereThereAreNone) {
  const auto points = test::points_over_tiles(3000, 4);
  std::vector<std::uint8_t> classes(points.size());
  for (std::size_t i = 0; i < classes.size(); ++i) classes[i] = static_cast<std::uint8_t>(i % 7);
  for (const auto& [name, format] : {std::pair("c.las", 1), {"c.laz", 1}, {"c.laz", 7}}) {
    const TemporaryFolder folder;
    test::write_cloud(folder.path() / name, points, classes, static_cast<std::uint8_t>(format));
    const test::FilesStore files(folder.path(), {name}, 900);
    for (std::uint32_t b = 0; b < files.cloud->blocks().size(); ++b) {
      std::vector<RoofLabel> labels(files.cloud->blocks()[b].points);
      for (std::size_t i = 0; i < labels.size(); ++i) labels[i].label = static_cast<PointLabel>(i % 5);
      files.cloud->write(b, columns::kRoof, labels);
    }
    const std::vector<ProductLabels> labels{roof_labels(false)};
    rows_pass(*files.cloud, labels, {});
    write_labelled_clouds(*files.cloud, files.inputs, labels, folder.path() / "plain", {});
    write_labelled_clouds(*files.cloud, files.inputs, labels, folder.path() / "out", {{}, true});
    const Rows was = read_rows(*open_cloud(folder.path() / "plain" / "c.laz"));
    Rows is = read_rows(*open_cloud(folder.path() / "out" / "c.laz"));
    ASSERT_EQ(is.length, was.length);
    ASSERT_EQ(is.count, points.size());
    const std::size_t label_at = offset_of_label(*open_cloud(folder.path() / "out" / "c.laz"));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < is.count; ++i) {
      const std::span row(is.bytes.data() + i * is.length, is.length);
      const std::span before(was.bytes.data() + i * was.length, was.length);
      PointFields fields = decode_fields(row, static_cast<std::uint8_t>(format));
      const auto given = decode_fields(before, static_cast<std::uint8_t>(format)).classification;
      const auto label = static_cast<PointLabel>(before[label_at]);
      const bool open = given <= 1;
      const int expected = open && label == PointLabel::ground                                ? 2
                           : open && (label == PointLabel::roof || label == PointLabel::wall) ? 6
                                                                                              : given;
      ASSERT_EQ(fields.classification, expected) << name << " " << i;
      changed += fields.classification != given;
      fields.classification = given;
      encode_fields(fields, row, static_cast<std::uint8_t>(format));
      ASSERT_TRUE(std::ranges::equal(row, before)) << name << " " << i;
    }
    EXPECT_GT(changed, points.size() / 10);
  }
}

TEST(LabelledClouds, RowsThatNeverEnteredTheStoreStayWithoutLabel) {
  const TemporaryFolder folder;
  const auto points = test::points_over_tiles(3000, 2);
  test::write_cloud(folder.path() / "c.las", points);
  std::vector<std::unique_ptr<PointReader>> inputs;
  inputs.push_back(open_cloud(folder.path() / "c.las"));
  IndexParams params;
  params.unit = test::kUnit;
  params.filter.keep = IndexBox{{-200, -200, -200}, {200, 200, 200}};
  const Store store = build_index(inputs, params, folder.path() / "store", {}).store;
  write_labels(store);
  const std::vector<ProductLabels> labels{plane_labels({{0, 1, 2, 3, 4}, level_planes(), false})};
  rows_pass(store, labels, {});
  write_labelled_clouds(store, inputs, labels, folder.path() / "out", {});
  const Rows rows = read_rows(*open_cloud(folder.path() / "out" / "c.laz"));
  ASSERT_EQ(rows.count, points.size());
  for (std::size_t i = 0; i < rows.count; ++i) {
    const std::uint32_t wanted = params.filter.keep->contains(points[i]) ? plane_of(input_order(0, i)) : 0;
    ASSERT_EQ(load<std::uint32_t>(rows.bytes.data() + i * rows.length + 20), wanted);
  }
}

// The class of a building counts before that of a facade, and that before that of a street. What a building says of
// points that are not its own counts last. A point of a building that is on none of its faces has the class that the
// next product gives.
TEST(LabelledClouds, ClassesCountInTheOrderOfTheProducts) {
  struct Case {
    RoofLabel roof;
    FacadeLabel facade;
    StreetLabel street;
    PointLabel wanted;
    bool labelled;
  };
  const std::vector<Case> cases{
      {{1, 4, PointLabel::roof}, {2, 3, PointLabel::window}, {5, PointLabel::car}, PointLabel::roof, true},
      {{0, 0, PointLabel::vegetation}, {2, 3, PointLabel::window}, {5, PointLabel::car}, PointLabel::window, true},
      {{0, 0, PointLabel::vegetation}, {}, {5, PointLabel::car}, PointLabel::car, true},
      {{0, 0, PointLabel::vegetation}, {}, {}, PointLabel::vegetation, true},
      {{0, 0, PointLabel::vegetation}, {0, 3, PointLabel::none}, {}, PointLabel::none, false},
      {{1, 0, PointLabel::none}, {}, {5, PointLabel::car}, PointLabel::car, true},
      {{1, 0, PointLabel::none}, {2, 3, PointLabel::facade}, {5, PointLabel::car}, PointLabel::facade, true},
      {{1, 0, PointLabel::none}, {}, {}, PointLabel::none, true},
      {{0, 0, PointLabel::vegetation}, {0, 3, PointLabel::none}, {0, PointLabel::facade}, PointLabel::facade, true},
      {{}, {}, {5, PointLabel::none}, PointLabel::none, true},
      {{}, {}, {}, PointLabel::none, false}};
  std::vector<Index3> points;
  for (std::size_t i = 0; i < cases.size(); ++i) points.push_back({static_cast<std::int64_t>(i), 0, 0});
  const CloudStore cloud(points, {1u << 20, 2000, 1});
  const auto write = [&](auto column, auto Case::*label) {
    std::vector<std::decay_t<decltype(cases[0].*label)>> values;
    for (const InputOrder order : cloud.store().read(0, columns::kOrder)) values.push_back(cases[row_of(order)].*label);
    cloud.store().write(0, column, values);
  };
  write(columns::kRoof, &Case::roof);
  write(columns::kFacade, &Case::facade);
  write(columns::kStreet, &Case::street);
  const std::vector<ProductLabels> labels{roof_labels(false), facade_labels(), street_labels()};
  rows_pass(cloud.store(), labels, {});
  const StretchLabels rows = collect_labels(cloud.store(), sample_rows(cloud.store()), 0, cases.size(), labels);
  std::uint64_t labelled = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    EXPECT_EQ(rows.classes[i], cases[i].wanted) << i;
    EXPECT_EQ(rows.labelled[i] != 0, cases[i].labelled) << i;
    labelled += cases[i].labelled;
  }
  EXPECT_EQ(count_labelled(cloud.store(), labels, {}), labelled);
  EXPECT_EQ(write_labelled_clouds(cloud.store(), cloud.inputs(), labels, cloud.folder() / "out", {}), labelled);
  const auto out = open_cloud(cloud.folder() / "out" / "cloud0.laz");
  std::vector<std::string> names;
  for (const ExtraField& field : out->info().layout.extra) names.push_back(field.name);
  EXPECT_EQ(names, (std::vector<std::string>{"plane_id", "unit_id", "object_id", "facade_id", "element_id", "label"}));
}

}  // namespace
}  // namespace ilot
