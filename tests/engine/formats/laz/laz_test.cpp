// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/laz.h"

#include <set>
#include <thread>

#include "kernels/core/parallel.h"
#include "tests/engine/formats/laz/laz_fixtures.h"

namespace ilot {
namespace {

using test::Folder;
using test::PointMaker;
using test::read_all;
using test::slurp;
using test::spill;

CloudSpec spec_of(std::uint8_t format, std::uint16_t extra = 0) {
  CloudSpec spec;
  spec.like.layout.point_format = format;
  spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format) + extra);
  if (extra > 0)
    spec.like.layout.extra = {
        {"more", "", FieldType::opaque, static_cast<std::uint16_t>(standard_size(format)), extra}};
  spec.software = "test";
  return spec;
}

std::vector<std::byte> points_of(const CloudSpec& spec, std::size_t count, std::uint64_t key = 1) {
  const auto& l = spec.like.layout;
  return PointMaker({l.point_format, l.record_length, static_cast<std::uint8_t>(l.point_format < 6 ? 2 : 3)}, key)
      .make(count);
}

void write_file(const std::filesystem::path& path, const CloudSpec& spec, std::span<const std::byte> rows,
                std::uint32_t chunk_points = 50000) {
  const auto writer = create_laz(path, spec, {chunk_points});
  ASSERT_EQ(writer->record_length(), spec.like.layout.record_length);
  const std::size_t step = 777 * writer->record_length();
  for (std::size_t at = 0; at < rows.size(); at += step)
    writer->write(rows.subspan(at, std::min(step, rows.size() - at)));
  writer->finish();
}

TEST(Laz, WritesAndReadsEveryFormat) {
  const Folder folder;
  for (std::uint8_t format = 0; format <= 10; ++format) {
    for (const std::uint16_t extra : {0, 3}) {
      SCOPED_TRACE(testing::Message() << "format " << int(format) << " extra " << extra);
      const CloudSpec spec = spec_of(format, extra);
      for (const std::size_t count : {0, 1, 1000, 1001, 12345}) {
        const auto rows = points_of(spec, count);
        write_file(folder / "a.laz", spec, rows, 1000);
        const auto reader = open_cloud(folder / "a.laz");
        EXPECT_EQ(reader->info().format, "laz");
        ASSERT_EQ(reader->info().points, count);
        EXPECT_TRUE(reader->info().warnings.empty());
        EXPECT_EQ(reader->boundaries().size(), std::max<std::size_t>(1, (count + 999) / 1000 + 1));
        EXPECT_TRUE(read_all(*reader, 333).bytes == rows);
      }
    }
  }
  EXPECT_EQ(folder.files(), 1u);
}

// A chunk has 16 MiB of rows at most.
TEST(Laz, LongRowsComeInSmallerChunks) {
  const Folder folder;
  const CloudSpec spec = spec_of(0, 59'980);
  const auto rows = points_of(spec, 300);
  write_file(folder / "a.laz", spec, rows);
  const auto reader = open_cloud(folder / "a.laz");
  EXPECT_EQ(reader->boundaries(), (std::vector<std::uint64_t>{0, (std::size_t{16} << 20) / 60'000, 300}));
  EXPECT_TRUE(read_all(*reader, 100).bytes == rows);
}

TEST(Laz, SameBytesForAnyNumberOfThreads) {
  const Folder folder;
  const CloudSpec spec = spec_of(7, 2);
  const auto rows = points_of(spec, 20000);
  std::vector<std::vector<std::byte>> files;
  for (const int threads : {1, 2, 3, 8}) {
    with_threads(threads, [&] { write_file(folder / "a.laz", spec, rows, 500); });
    files.push_back(slurp(folder / "a.laz"));
    EXPECT_TRUE(files.back() == files.front()) << threads;
  }
}

TEST(Laz, ReadsAnyRangeFromAnyThread) {
  const Folder folder;
  const CloudSpec spec = spec_of(3);
  const auto rows = points_of(spec, 9000);
  write_file(folder / "a.laz", spec, rows, 700);
  const auto reader = open_cloud(folder / "a.laz");
  EXPECT_TRUE(reader->random_access());
  std::vector<std::thread> threads;
  std::atomic<int> wrong{0};
  for (std::uint64_t t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      Rng rng(t);
      for (int i = 0; i < 60; ++i) {
        const std::uint64_t first = rng.below(9100), count = 1 + rng.below(i % 2 ? 20 : 3000);
        std::vector<std::byte> out(count * 34);
        std::vector<std::uint8_t> valid(count);
        const std::size_t got = reader->read(first, out, valid);
        const std::uint64_t expected = first >= 9000 ? 0 : std::min(count, 9000 - first);
        if (got != expected || std::memcmp(out.data(), rows.data() + first * 34 * (got > 0), got * 34) != 0) ++wrong;
      }
    });
  }
  for (auto& t : threads) t.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Laz, NothingAppearsWithoutFinish) {
  const Folder folder;
  const CloudSpec spec = spec_of(6);
  create_laz(folder / "a.laz", spec)->write(points_of(spec, 10));
  EXPECT_EQ(folder.files(), 0u);
}

TEST(Laz, CutFilesKeepTheirWholeChunks) {
  const Folder folder;
  for (const std::uint8_t format : {1, 7}) {
    const CloudSpec spec = spec_of(format);
    const std::size_t length = spec.like.layout.record_length;
    const auto rows = points_of(spec, 5000);
    write_file(folder / "whole.laz", spec, rows, 1000);
    const auto whole = slurp(folder / "whole.laz");
    const test::OpenedLaz opened(folder / "whole.laz");
    for (std::size_t cut = 1; cut < 5; ++cut) {
      auto part = whole;
      part.resize(opened.index.chunks[cut].offset + 5);
      spill(folder / "cut.laz", part);
      const auto reader = open_cloud(folder / "cut.laz");
      EXPECT_EQ(reader->info().points, 1000 * cut);
      EXPECT_EQ(reader->info().declared_points, 5000u);
      EXPECT_EQ(reader->info().warnings.size(), 1u);
      const auto read = read_all(*reader);
      ASSERT_EQ(read.bytes.size(), 1000 * cut * length);
      EXPECT_EQ(std::memcmp(read.bytes.data(), rows.data(), read.bytes.size()), 0);
    }
    auto part = whole;
    part.resize(opened.index.chunks[0].offset + 40);
    spill(folder / "cut.laz", part);
    EXPECT_THROW(open_cloud(folder / "cut.laz"), Error) << "no chunk is whole";
  }
}

TEST(Laz, TableMayBeNamedAtTheEndOrNotAtAll) {
  const Folder folder;
  for (const std::uint8_t format : {0, 6}) {
    CloudSpec spec = spec_of(format);
    const auto rows = points_of(spec, 2500);
    write_file(folder / "a.laz", spec, rows, 1000);
    auto bytes = slurp(folder / "a.laz");
    const auto place = load<std::uint32_t>(&bytes[las::kPointOffset]);
    const auto table = load<std::uint64_t>(&bytes[place]);
    store(&bytes[place], std::int64_t{-1});
    bytes.resize(bytes.size() + 8);
    store(&bytes[bytes.size() - 8], table);
    spill(folder / "end.laz", bytes);
    const auto at_end = open_cloud(folder / "end.laz");
    EXPECT_TRUE(at_end->info().warnings.empty());
    EXPECT_TRUE(read_all(*at_end).bytes == rows);

    store(&bytes[place], std::uint64_t{place});
    store(&bytes[bytes.size() - 8], std::uint64_t{0});
    spill(folder / "none.laz", bytes);
    const auto unfinished = open_cloud(folder / "none.laz");
    EXPECT_EQ(unfinished->info().warnings.size(), 1u);
    EXPECT_TRUE(read_all(*unfinished).bytes == rows);
  }
}

// As compressors before 2011 wrote them: one stream without a table, items of version 1.
std::vector<std::byte> in_version_1(const std::vector<std::byte>& file, const CloudSpec& spec,
                                    std::span<const std::byte> rows) {
  const auto points = load<std::uint32_t>(&file[las::kPointOffset]);
  std::vector<std::byte> out(file.begin(), file.begin() + points);
  const RecordLayout& l = spec.like.layout;
  const laz::ChunkLayout layout{l.point_format, l.record_length, 1};
  const auto record = laz::laszip_record({layout, true});
  std::copy(record.begin(), record.end(), out.end() - static_cast<std::ptrdiff_t>(record.size()));
  laz::ChunkEncoder(layout).encode(rows, out);
  return out;
}

TEST(Laz, ReadsFilesFromBefore2011) {
  const Folder folder;
  for (std::uint8_t format = 0; format <= 5; ++format) {
    for (const std::uint16_t extra : {0, 3}) {
      SCOPED_TRACE(testing::Message() << "format " << int(format) << " extra " << extra);
      const CloudSpec spec = spec_of(format, extra);
      const std::size_t length = spec.like.layout.record_length;
      const auto rows = points_of(spec, 5000);
      write_file(folder / "new.laz", spec, rows);
      auto bytes = in_version_1(slurp(folder / "new.laz"), spec, rows);
      spill(folder / "old.laz", bytes);
      const auto reader = open_cloud(folder / "old.laz");
      EXPECT_TRUE(reader->info().warnings.empty());
      EXPECT_FALSE(reader->random_access());
      EXPECT_TRUE(read_all(*reader, 777).bytes == rows);

      const auto points = load<std::uint32_t>(&bytes[las::kPointOffset]);
      bytes.resize(points + (bytes.size() - points) / 2);
      spill(folder / "cut.laz", bytes);
      const auto cut = open_cloud(folder / "cut.laz");
      EXPECT_EQ(cut->info().warnings.size(), 1u);
      EXPECT_GT(cut->info().points, 1000u);
      const auto read = read_all(*cut).bytes;
      ASSERT_EQ(read.size(), cut->info().points * length);
      EXPECT_EQ(std::memcmp(read.data(), rows.data(), read.size()), 0);
    }
  }
}

TEST(Laz, DamagedFilesAreRefusedOrRead) {
  const Folder folder;
  test::DamageTally tally;
  Rng rng(5);
  for (const int kind : {3, 8, 1}) {  // a point format; 1: of before 2011
    const CloudSpec spec = spec_of(static_cast<std::uint8_t>(kind), 1);
    const auto rows = points_of(spec, 700);
    write_file(folder / "a.laz", spec, rows, 100);
    const auto whole = kind == 1 ? in_version_1(slurp(folder / "a.laz"), spec, rows) : slurp(folder / "a.laz");
    for (int round = 0; round < 400; ++round) {
      auto bytes = whole;
      if (round % 4 == 0) bytes.resize(rng.below(bytes.size()));
      const std::uint64_t from = round % 2 ? 0 : std::min<std::uint64_t>(bytes.size(), 300);
      for (std::uint64_t i = 0; i < 1 + rng.below(6) && bytes.size() > from; ++i) {
        bytes[from + rng.below(bytes.size() - from)] = static_cast<std::byte>(rng.below(256));
      }
      // A count of points beyond all bounds is the index's to refuse; here it would only take long.
      if (bytes.size() > 255 && load<std::uint64_t>(&bytes[las::kCount]) > 100000) continue;
      spill(folder / "b.laz", bytes);
      test::expect_refused_or_read(folder / "b.laz", test::DamageFound::while_reading, tally);
      if (HasFatalFailure()) return;
    }
  }
  EXPECT_GT(tally.read, 50);
  EXPECT_GT(tally.refused, 50);
}

TEST(Laz, BrokenConformanceFilesAreRefusedWithAReason) {
  ILOT_DATA_OR_SKIP(data);
  std::size_t files = 0;
  for (const char* name : {"coder", "compressor", "size", "type", "version"}) {
    const auto path = data / "conformance/laszip/data" / (std::string("broken_") + name + ".laz");
    try {
      open_cloud(path);
      ADD_FAILURE() << path << " was opened";
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(path.filename()), std::string::npos) << e.what();
      ++files;
    }
  }
  EXPECT_EQ(files, 5u);
}

TEST(Laz, UncompressedTwinsHoldTheSamePoints) {
  ILOT_DATA_OR_SKIP(data);
  const std::pair<const char*, const char*> twins[] = {
      {"laz-rs/point10.laz", "laz-rs/point10.las"},
      {"laz-rs/point-time.laz", "laz-rs/point-time.las"},
      {"laz-rs/point-color.laz", "laz-rs/point-color.las"},
      {"laz-rs/point-time-color.laz", "laz-rs/point-time-color.las"},
      {"laz-rs/extra-bytes.laz", "laz-rs/extra-bytes.las"},
      {"pdal/laszip/laszip-generated.laz", "pdal/laszip/basefile.las"},
      {"pdal/laszip/liblas-generated.laz", "pdal/laszip/basefile.las"},
      {"pdal/laz/simple.laz", "pdal/las/simple.las"},
      {"laz-rs/point-version-1-point-wise.laz", "laz-rs/point-version-1-point-wise.las"},
      {"pdal/laz/simple-laszip-compressor-version-1.2r0.laz", "pdal/las/simple.las"}};
  for (const auto& [laz, las] : twins) {
    SCOPED_TRACE(laz);
    const auto a = open_cloud(data / "conformance" / laz), b = open_cloud(data / "conformance" / las);
    EXPECT_EQ(a->info().points, b->info().points);
    EXPECT_TRUE(read_all(*a).bytes == read_all(*b).bytes);
  }
}

// What a run asks for is what full decoding gives.
TEST(Laz, SelectedFieldsEqualFullDecoding) {
  ILOT_DATA_OR_SKIP(data);
  for (const char* name :
       {"ign/77050_627755_pf8.laz", "minimalhouse/minimal_house_12.laz", "ign/77050_627755_pf3.laz"}) {
    SCOPED_TRACE(name);
    const auto all = open_cloud(data / name), some = open_cloud(data / name);
    some->limit_to(kFieldZ | kFieldClass);
    const auto a = read_all(*all, 5000).bytes, b = read_all(*some, 5000).bytes;
    ASSERT_EQ(a.size(), b.size());
    const auto& layout = all->info().layout;
    const std::size_t returns = 14, kind = layout.point_format >= 6 ? 16 : 15;
    for (std::size_t at = 0; at < a.size(); at += layout.record_length) {
      ASSERT_EQ(std::memcmp(&a[at], &b[at], 12), 0) << at;
      ASSERT_EQ(a[at + returns], b[at + returns]) << at;
      ASSERT_EQ(a[at + kind], b[at + kind]) << at;
    }
  }
}

// Rewriting a file of fixed chunks gives its compressed bytes again, through the whole reader and writer.
TEST(Laz, RewrittenFilesHaveTheSameChunks) {
  ILOT_DATA_OR_SKIP(data);
  const Folder folder;
  for (const char* name : {"delft/ahn3_cropped_1.laz", "ign/77050_627755_pf8.laz", "lastools/fusa.laz"}) {
    SCOPED_TRACE(name);
    const auto reader = open_cloud(data / name);
    CloudSpec spec;
    spec.like = reader->info();
    const auto writer = create_cloud(folder / "again.laz", spec);
    writer->write(read_all(*reader, 50000).bytes);
    writer->finish();
    const test::OpenedLaz before(data / name), after(folder / "again.laz");
    ASSERT_EQ(before.index.chunks.size(), after.index.chunks.size());
    for (std::size_t i = 0; i < before.index.chunks.size(); ++i) {
      EXPECT_TRUE(before.bytes(before.index.chunks[i]) == after.bytes(after.index.chunks[i])) << i;
    }
  }
}

}  // namespace
}  // namespace ilot
