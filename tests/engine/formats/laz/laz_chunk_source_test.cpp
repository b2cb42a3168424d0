// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk_source.h"

#include "tests/engine/formats/laz/laz_fixtures.h"

namespace ilot::laz {
namespace {

using test::Folder;
using test::PointMaker;
using test::spill;

constexpr std::size_t kBefore = 100, kBehind = 3000;  // bytes of the file around the chunk

struct ChunkFile {
  ChunkFile(const std::filesystem::path& path, const ChunkLayout& layout, std::size_t points)
      : records(PointMaker(layout, 7).make(points)) {
    ChunkEncoder(layout).encode(records, chunk);
    std::vector<std::byte> bytes(kBefore, std::byte{0x11});
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    bytes.resize(bytes.size() + kBehind, std::byte{0x5A});
    spill(path, bytes);
  }
  std::vector<std::byte> records, chunk;
};

// Several windows long, in each version of the items, and in pieces that fit no window.
TEST(LazChunkSource, LongStreamsPassThroughAWindow) {
  const Folder folder;
  for (const int version : {1, 2}) {
    const ChunkLayout layout{3, 47, static_cast<std::uint8_t>(version)};
    const ChunkFile made(folder / "chunk", layout, 200'000);
    ASSERT_GT(made.chunk.size(), std::size_t{3} << 20);
    const InputFile file(folder / "chunk");
    ChunkSource source(file, layout);
    for (const std::size_t behind : {std::size_t{0}, kBehind}) {  // the chunk's size is known, or only bounded
      ASSERT_TRUE(source.begin(kBefore, made.chunk.size() + behind, 200'000));
      std::vector<std::byte> read(made.records.size());
      for (std::size_t at = 0; at < 200'000; at += 33'333)
        ASSERT_TRUE(source.next(std::span(read).subspan(at * 47, std::min<std::size_t>(33'333, 200'000 - at) * 47)));
      EXPECT_TRUE(read == made.records);
      EXPECT_EQ(source.consumed(), made.chunk.size());
      EXPECT_EQ(source.ended_well(), behind == 0);
    }
  }
}

// One record uses up a quarter of a window.
TEST(LazChunkSource, LongestRecords) {
  const Folder folder;
  for (const int version : {1, 2}) {
    const ChunkLayout layout{1, 65535, static_cast<std::uint8_t>(version)};
    const ChunkFile made(folder / "chunk", layout, 120);
    const InputFile file(folder / "chunk");
    ChunkSource source(file, layout);
    std::vector<std::byte> read(made.records.size());
    ASSERT_TRUE(source.begin(kBefore, made.chunk.size(), 120) && source.next(read));
    EXPECT_TRUE(read == made.records);
    EXPECT_TRUE(source.ended_well());
  }
}

TEST(LazChunkSource, AChunkThatTheFileNoLongerHasIsNoChunk) {
  const Folder folder;
  const ChunkLayout layout{3, 47, 1};
  const ChunkFile made(folder / "chunk", layout, 200'000);
  const InputFile file(folder / "chunk");
  ChunkSource source(file, layout);
  ASSERT_TRUE(source.begin(kBefore, made.chunk.size(), 200'000));
  std::filesystem::resize_file(folder / "chunk", kBefore + made.chunk.size() / 2);  // while it is read
  std::vector<std::byte> read(made.records.size());
  EXPECT_FALSE(source.next(read));
  EXPECT_FALSE(source.ended_well());
  EXPECT_FALSE(source.begin(kBefore + made.chunk.size() / 2, 100, 1)) << "there is nothing";
}

}  // namespace
}  // namespace ilot::laz
