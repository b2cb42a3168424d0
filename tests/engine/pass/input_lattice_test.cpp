// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/input_lattice.h"

#include <gtest/gtest.h>

#include "engine/pass/index.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;
using Inputs = std::vector<std::unique_ptr<PointReader>>;

// Raw integers as they are, at a scale; offsets in the unit of the CRS.
void write(const fs::path& path, const std::vector<Index3>& raw, double scale, double offset = 0) {
  CloudSpec spec;
  spec.like.layout.point_format = 0;
  spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(0));
  spec.like.layout.scale = {scale, scale, scale};
  spec.like.layout.offset = {offset, offset, 0};
  const std::size_t length = spec.like.layout.record_length;
  std::vector<std::byte> records(raw.size() * length);
  for (std::size_t i = 0; i < raw.size(); ++i) {
    PointFields f;
    f.x = static_cast<std::int32_t>(raw[i].x);
    f.y = static_cast<std::int32_t>(raw[i].y);
    f.z = static_cast<std::int32_t>(raw[i].z);
    encode_fields(f, std::span(records).subspan(i * length, length), 0);
  }
  const auto writer = create_cloud(path, spec);
  writer->write(records);
  writer->finish();
}

std::vector<Index3> times(std::vector<Index3> points, std::int64_t by) {
  for (Index3& p : points) p = {p.x * by, p.y * by, p.z * by};
  return points;
}

// A house's worth of points, in millimetres.
std::vector<Index3> house(std::size_t n = 4000) {
  Rng rng(5);
  std::vector<Index3> points;
  for (std::size_t i = 0; i < n; ++i)
    points.push_back({static_cast<std::int64_t>(rng.below(20000)), static_cast<std::int64_t>(rng.below(20000)),
                      static_cast<std::int64_t>(rng.below(9000))});
  return points;
}

IndexResult indexed(const Inputs& inputs, const InputLattice& lattice, const fs::path& folder) {
  IndexParams params;
  params.unit = lattice.unit;
  params.multiple = lattice.multiple;
  return build_index(inputs, params, folder, {});
}

class InputLatticeOf : public testing::Test {
 protected:
  Inputs open(const std::vector<const char*>& names) {
    Inputs inputs;
    for (const char* name : names) inputs.push_back(open_cloud(folder_.path() / name));
    return inputs;
  }
  fs::path at(const char* name) { return folder_.path() / name; }
  TemporaryFolder folder_;
};

TEST_F(InputLatticeOf, WholeMillimetresAreTheSameInAnyFinerScale) {
  write(at("mm.las"), house(), 0.001, 651000);
  const Inputs plain = open({"mm.las"});
  const InputLattice wanted = common_lattice(plain, 1);
  EXPECT_EQ(wanted, (InputLattice{0.001, 1}));
  const IndexResult of_plain = indexed(plain, wanted, at("plain"));
  for (const auto& [scale, multiple] : {std::pair{1e-4, 10}, {1e-5, 100}, {1e-6, 1000}, {2e-4, 5}}) {
    write(at("fine.las"), times(house(), multiple), scale, 651000);
    const Inputs fine = open({"fine.las"});
    const InputLattice lattice = common_lattice(fine, 1);
    EXPECT_EQ(lattice, (InputLattice{0.001, multiple})) << scale;
    const fs::path folder = at(("store" + std::to_string(multiple)).c_str());
    const IndexResult found = indexed(fine, lattice, folder);
    ASSERT_EQ(found.lattice, lattice);
    EXPECT_EQ(found.store.blocks().size(), of_plain.store.blocks().size());
    EXPECT_EQ(test::positions(found.store), test::positions(of_plain.store));
    // What is measured from a lattice place is a whole number too.
    const LatticeMap map(fine[0]->info().layout, lattice.unit);
    EXPECT_EQ(map.offset_from({651000000, 651000000, 0}, 7 * multiple, -3 * multiple, 0).x, 7.0);
  }
}

TEST_F(InputLatticeOf, AFinerPointIsKeptExactly) {
  auto raw = times(house(), 100);
  raw[raw.size() - 5].y += 50;
  write(at("fine.las"), raw, 1e-5);
  const Inputs inputs = open({"fine.las"});
  const InputLattice likely = common_lattice(inputs, 1);
  EXPECT_EQ(likely.multiple, 100) << "the sample does not see the point";
  const IndexResult first = indexed(inputs, likely, at("store"));
  EXPECT_EQ(first.lattice, (InputLattice{0.0005, 50}));
  EXPECT_EQ(first.store.points(), 0u);
  EXPECT_EQ(indexed(inputs, likely, at("store")).lattice, first.lattice) << "a run that is resumed knows it";
  const IndexResult second = indexed(inputs, first.lattice, at("store"));
  EXPECT_EQ(second.lattice, first.lattice);
  std::vector<Index3> wanted;
  for (const Index3& p : raw) wanted.push_back({p.x / 50, p.y / 50, p.z / 50});
  EXPECT_EQ(test::positions(second.store), test::in_global_order(wanted));
}

TEST_F(InputLatticeOf, StraysAreNotAsked) {
  auto raw = times(house(), 100);
  raw.push_back({INT32_MIN + 1, INT32_MAX, 17});  // as clipped ones are, 21 km off
  write(at("fine.las"), raw, 1e-5);
  const Inputs inputs = open({"fine.las"});
  const InputLattice likely = common_lattice(inputs, 1);
  const IndexResult found = indexed(inputs, likely, at("store"));
  EXPECT_EQ(found.lattice, (InputLattice{0.001, 100}));
  EXPECT_EQ(found.rejected[static_cast<std::size_t>(Rejection::stray)], 1u);
  EXPECT_EQ(found.store.points(), raw.size() - 1);
}

TEST_F(InputLatticeOf, RaysWithoutAnEchoSayNothing) {
  auto raw = times(house(), 100);
  raw.insert(raw.begin(), 3000, Index3{-2147480003, 17, 1});
  write(at("fine.las"), raw, 1e-5);
  EXPECT_EQ(common_lattice(open({"fine.las"}), 1), (InputLattice{0.001, 100}));
}

TEST_F(InputLatticeOf, AllInputsShareIt) {
  write(at("a.las"), times(house(), 100), 1e-5);
  write(at("b.las"), house(), 0.01);
  write(at("c.las"), times(house(), 2), 2.5e-4);
  EXPECT_EQ(common_lattice(open({"b.las"}), 1), InputLattice(0.01));
  EXPECT_EQ(common_lattice(open({"a.las", "b.las"}), 1), (InputLattice{0.001, 100}));
  EXPECT_EQ(common_lattice(open({"b.las", "a.las"}), 1), (InputLattice{0.001, 100}));
  EXPECT_EQ(common_lattice(open({"a.las", "c.las"}), 1), (InputLattice{0.0005, 50}));
}

TEST_F(InputLatticeOf, IsTheScaleWhereThatIsNeeded) {
  write(at("fine.las"), house(), 1e-5);
  EXPECT_EQ(common_lattice(open({"fine.las"}), 1, 1e-5), InputLattice(1e-5));
  write(at("tenth.las"), house(), 1e-4);
  EXPECT_EQ(common_lattice(open({"tenth.las"}), 1), InputLattice(1e-4));
  write(at("off.las"), times(house(), 100), 1e-5, 0.000003);
  EXPECT_EQ(common_lattice(open({"off.las"}), 1, 1e-5), InputLattice(1e-5)) << "its offset is on no lattice";
  write(at("zeros.las"), std::vector<Index3>(100), 1e-5);
  EXPECT_EQ(common_lattice(open({"zeros.las"}), 1, 1e-5), InputLattice(1e-5));
}

TEST_F(InputLatticeOf, IsNeverFinerThanTheFinestStep) {
  for (const auto& [name, scale] : {std::pair{"fine.las", 1e-5}, {"finest.las", 1e-7}}) {
    write(at(name), house(), scale);
    EXPECT_EQ(common_lattice(open({name}), 1), InputLattice(1e-4)) << "a tenth of a millimetre at least";
    EXPECT_EQ(common_lattice(open({name}), 0.3048), InputLattice(1e-4 / 0.3048));
  }
}

}  // namespace
}  // namespace ilot
