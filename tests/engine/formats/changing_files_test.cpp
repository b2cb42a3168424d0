// SPDX-License-Identifier: Apache-2.0
// Files that change after they were opened, in every format: what is read are the points that were counted, or fewer.
#include <fstream>

#include "tests/engine/formats/laz/laz_fixtures.h"
#include "tests/support/e57_writer.h"

namespace ilot {
namespace {

using test::Folder;
using test::read_all;
using test::slurp;
using test::spill;

// A few thousand rows each.
std::vector<std::filesystem::path> clouds(const Folder& folder) {
  std::vector<std::filesystem::path> paths;
  CloudSpec spec;
  spec.like.layout.point_format = 1;
  spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(1));
  const auto rows = test::PointMaker({1, spec.like.layout.record_length, 2}, 3).make(5000);
  for (const char* name : {"a.las", "a.laz", "a.ply", "a.xyz"}) {
    const auto writer = create_cloud(folder / name, spec);
    writer->write(rows);
    writer->finish();
    paths.push_back(folder / name);
  }
  std::ofstream ptx(folder / "a.ptx"), pcd(folder / "a.pcd");
  ptx << "50\n40\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n";
  pcd << "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2000\nHEIGHT 1\nPOINTS 2000\nDATA ascii\n";
  for (int i = 0; i < 2000; ++i) {
    ptx << i << ".125 7.25 1234.5 0.5\n";
    pcd << i << ".125 7.25 1234.5\n";
  }
  std::vector<double> steps;
  for (int i = 0; i < 2000; ++i) steps.push_back(i);
  test::E57Writer e57;
  e57.add({"s",
           "",
           {test::double_field("cartesianX", steps), test::double_field("cartesianY", steps),
            test::double_field("cartesianZ", steps)}});
  const std::string bytes = e57.finish();
  std::ofstream(folder / "a.e57", std::ios::binary) << bytes;
  for (const char* name : {"a.ptx", "a.pcd", "a.e57"}) paths.push_back(folder / name);
  return paths;
}

TEST(ChangingFiles, WhatIsAppendedAfterOpeningIsNotRead) {
  const Folder folder;
  for (const auto& path : clouds(folder)) {
    SCOPED_TRACE(path.filename());
    const auto before = read_all(*open_cloud(path), 700);
    const auto reader = open_cloud(path);
    const auto bytes = slurp(path);
    std::ofstream(path, std::ios::binary | std::ios::app)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const auto after = read_all(*reader, 700);
    EXPECT_EQ(after.valid, before.valid);
    EXPECT_TRUE(after.bytes == before.bytes);
  }
}

// Fewer rows than were counted tell whoever reads that the file changed; those that come are as they were.
TEST(ChangingFiles, WhatIsCutOffAfterOpeningIsMissing) {
  const Folder folder;
  for (const auto& path : clouds(folder)) {
    const auto bytes = slurp(path);
    const auto before = read_all(*open_cloud(path), 700);
    for (const std::size_t kept : {bytes.size() - 2, bytes.size() / 2, std::size_t{10}}) {
      SCOPED_TRACE(path.filename().string() + " cut to " + std::to_string(kept));
      spill(path, bytes);
      const auto reader = open_cloud(path);
      const std::size_t length = reader->info().layout.record_length;
      std::filesystem::resize_file(path, kept);
      std::vector<std::byte> rows(before.bytes.size());
      std::vector<std::uint8_t> valid(before.valid.size());
      const std::size_t got = reader->read(0, rows, valid);
      // The last bytes of LAZ are of its table of chunks.
      const bool untouched = path.extension() == ".laz" && kept + 2 == bytes.size();
      EXPECT_EQ(got == before.valid.size(), untouched) << got;
      EXPECT_EQ(std::memcmp(rows.data(), before.bytes.data(), got * length), 0);
    }
    spill(path, bytes);
  }
}

}  // namespace
}  // namespace ilot
