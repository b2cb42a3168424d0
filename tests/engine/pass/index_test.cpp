// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/index.h"

#include <atomic>

#include "engine/formats/las/las.h"
#include "tests/engine/formats/fixtures.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

// Counts the rows that are read through it.
class Counting final : public PointReader {
 public:
  explicit Counting(const std::filesystem::path& path) : inner_(open_cloud(path)) {}
  const CloudInfo& info() const override { return inner_->info(); }
  bool random_access() const override { return inner_->random_access(); }
  std::vector<std::uint64_t> boundaries() const override { return inner_->boundaries(); }
  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t got = inner_->read(first, records, valid);
    rows += got;
    return got;
  }
  std::atomic<std::uint64_t> rows{0};

 private:
  std::unique_ptr<PointReader> inner_;
};

struct Indexed {
  IndexResult result;
  std::uint64_t rows_read = 0, advanced = 0;
  std::uint64_t accounted() const {
    std::uint64_t sum = result.store.points();
    for (const std::uint64_t n : result.rejected) sum += n;
    return sum;
  }
};

Indexed index(const std::filesystem::path& input, const IndexParams& params, const std::filesystem::path& folder) {
  std::vector<std::unique_ptr<PointReader>> inputs;
  auto counting = std::make_unique<Counting>(input);
  const Counting& counted = *counting;
  inputs.push_back(std::move(counting));
  std::atomic<std::uint64_t> advanced{0};
  PassContext context;
  context.advance = [&](std::uint64_t n) { advanced += n; };
  IndexResult result = build_index(inputs, params, folder, context);
  return {std::move(result), counted.rows, advanced};
}

// The same rows in the same order without the octree.
void copy_as_las(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto reader = open_cloud(from);
  const auto writer = create_las(to, {reader->info(), {}, ""});
  writer->write(test::read_all(*reader).bytes);
  writer->finish();
}

TEST(Index, AnOctreeSavesReadingButChangesNothing) {
  ILOT_DATA_OR_SKIP(data);
  const auto octree = data / "ign/77050_627755.copc.laz";
  const test::Folder folder;
  copy_as_las(octree, folder / "plain.las");
  const test::Rows rows = test::read_all(*open_cloud(octree));
  const RecordLayout layout = open_cloud(octree)->info().layout;
  const std::uint64_t all = rows.valid.size();
  Rng rng(3);
  std::uint64_t read = 0;
  for (int round = 0; round < 12; ++round) {
    const Vec3 p = test::world(rows, layout, rng.below(static_cast<std::uint32_t>(all)));
    IndexParams params;
    params.unit = round % 2 ? layout.scale[0] : 0.0007;  // the second makes rounding matter
    params.run_points = params.block_points = 5000;
    const auto lattice = [&](double v) { return static_cast<std::int64_t>(v / params.unit); };
    const double reach = round < 3 ? 0 : round;
    params.filter.keep = IndexBox{{lattice(p.x - reach), lattice(p.y - reach), -(std::int64_t{1} << 52)},
                                  {lattice(p.x + reach), lattice(p.y + reach), std::int64_t{1} << 52}};
    const std::string name = std::to_string(round);
    const Indexed with = index(octree, params, folder / ("with" + name));
    const Indexed without = index(folder / "plain.las", params, folder / ("without" + name));
    EXPECT_EQ(test::whole_column(with.result.store, columns::kCodes),
              test::whole_column(without.result.store, columns::kCodes));
    EXPECT_EQ(test::whole_column(with.result.store, columns::kOrder),
              test::whole_column(without.result.store, columns::kOrder));
    EXPECT_EQ(with.result.rejected, without.result.rejected);
    EXPECT_EQ(with.accounted(), all);
    EXPECT_EQ(with.advanced, all);
    EXPECT_EQ(without.rows_read, all);
    read += with.rows_read;
  }
  EXPECT_LT(read, 12 * all * 9 / 10) << "the octree saves something";
}

TEST(Index, AnAreaFarFromTheOctreeReadsNothing) {
  ILOT_DATA_OR_SKIP(data);
  const test::Folder folder;
  IndexParams params;
  params.filter.keep = IndexBox{{0, 0, 0}, {5, 5, 5}};
  const Indexed far = index(data / "ign/77050_627755.copc.laz", params, folder / "store");
  EXPECT_EQ(far.rows_read, 0u);
  EXPECT_EQ(far.result.store.points(), 0u);
  EXPECT_EQ(far.result.rejected[static_cast<std::size_t>(Rejection::outside)], far.accounted());
}

}  // namespace
}  // namespace ilot
