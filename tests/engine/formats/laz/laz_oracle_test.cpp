// SPDX-License-Identifier: Apache-2.0
// Both directions against another implementation: npm's laz-perf 0.0.7 (WebAssembly), through tests/oracles.
// Skipped loudly without node and the package: npm install laz-perf@0.0.7 in the folder that ILOT_NPM names.
#include <cstdlib>

#include "engine/formats/laz/laz.h"
#include "tests/engine/formats/laz/laz_fixtures.h"

namespace ilot {
namespace {

constexpr const char* kScript = ILOT_SOURCE_DIR "/tests/oracles/lazperf_decode.mjs";

bool npm_has_laz_perf() {
  const char* npm = std::getenv("ILOT_NPM");
  return npm && std::filesystem::exists(std::filesystem::path(npm) / "node_modules/laz-perf") &&
         std::system("node --version > /dev/null 2>&1") == 0;
}

#define LAZ_PERF_OR_SKIP() \
  if (!npm_has_laz_perf()) GTEST_SKIP() << "no node, or no laz-perf below ILOT_NPM: nothing was compared"

// False when laz-perf cannot decode the file.
bool decode_by_laz_perf(const std::filesystem::path& in, const std::filesystem::path& out) {
  std::filesystem::remove(out);
  const std::string command =
      "node '" + std::string(kScript) + "' '" + in.string() + "' '" + out.string() + "' 2> /dev/null";
  return std::system(command.c_str()) == 0;
}

TEST(LazOracle, RealFilesDecodeToTheSameBytes) {
  ILOT_DATA_OR_SKIP(data);
  LAZ_PERF_OR_SKIP();
  const test::Folder folder;
  std::size_t compared = 0;
  for (const auto& path : test::laz_files(data)) {
    std::unique_ptr<PointReader> reader;
    try {
      reader = open_cloud(path);
    } catch (const Error&) {
      continue;
    }
    SCOPED_TRACE(path);
    if (!decode_by_laz_perf(path, folder / "out.raw")) continue;
    EXPECT_TRUE(test::read_all(*reader, 50000).bytes == test::slurp(folder / "out.raw"));
    ++compared;
  }
  EXPECT_GE(compared, 40u);
}

// All formats that laz-perf knows, with several scanner channels, extra bytes, a chunk of one point at the
// end.
TEST(LazOracle, OurFilesDecodeToTheSameBytes) {
  LAZ_PERF_OR_SKIP();
  const test::Folder folder;
  for (const std::uint8_t format : {0, 1, 2, 3, 6, 7, 8}) {
    for (const std::uint16_t extra : {0, 4}) {
      SCOPED_TRACE(testing::Message() << "format " << int(format) << " extra " << extra);
      CloudSpec spec;
      spec.like.layout.point_format = format;
      spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format) + extra);
      const laz::ChunkLayout layout{format, spec.like.layout.record_length,
                                    static_cast<std::uint8_t>(format < 6 ? 2 : 3)};
      const auto rows = test::PointMaker(layout, format + 100u).make(8001);
      const auto writer = create_laz(folder / "a.laz", spec, {2000});
      writer->write(rows);
      writer->finish();
      ASSERT_TRUE(decode_by_laz_perf(folder / "a.laz", folder / "out.raw"));
      EXPECT_TRUE(test::slurp(folder / "out.raw") == rows);
    }
  }
}

}  // namespace
}  // namespace ilot
