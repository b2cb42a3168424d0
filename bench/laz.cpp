// SPDX-License-Identifier: Apache-2.0
// LAZ: decoding, selective decoding and encoding of a real file in memory, in points per second. The file is
// ILOT_BENCH_LAZ (any .laz). Otherwise files of ILOT_DATA are used for formats 3, 6 (made from 8), 7 and 8.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "engine/error.h"
#include "engine/formats/laz/chunk_index.h"
#include "engine/formats/laz/laz.h"
#include "kernels/core/parallel.h"

namespace {

using namespace ilot;

struct Chunk {
  std::vector<std::byte> bytes, records;
};

struct Sample {
  laz::ChunkLayout layout;
  std::vector<Chunk> chunks;
  std::size_t points = 0;

  void add(std::vector<std::byte> records) {
    Chunk c;
    laz::ChunkEncoder(layout).encode(records, c.bytes);
    points += records.size() / layout.record_length;
    c.records = std::move(records);
    chunks.push_back(std::move(c));
  }
};

Sample load_sample(const std::filesystem::path& path) {
  const auto reader = open_cloud(path);
  const auto& l = reader->info().layout;
  Sample sample{{l.point_format, l.record_length, static_cast<std::uint8_t>(l.point_format < 6 ? 2 : 3)}, {}, 0};
  const auto bounds = reader->boundaries();
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    std::vector<std::byte> records((bounds[i + 1] - bounds[i]) * l.record_length);
    std::vector<std::uint8_t> valid(bounds[i + 1] - bounds[i]);
    reader->read(bounds[i], records, valid);
    sample.add(std::move(records));
  }
  return sample;
}

// Keeps only the core of each record.
Sample as_format_6(const Sample& from) {
  Sample sample{{6, 30, 3}, {}, 0};
  for (const Chunk& c : from.chunks) {
    std::vector<std::byte> records;
    for (std::size_t at = 0; at < c.records.size(); at += from.layout.record_length) {
      records.insert(records.end(), &c.records[at], &c.records[at] + 30);
    }
    sample.add(std::move(records));
  }
  return sample;
}

void count_points(benchmark::State& state, const Sample& sample) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.points));
}

void decode(benchmark::State& state, const Sample& sample, std::uint32_t fields, int threads) {
  constexpr std::size_t kCopies = 16;  // chunks differ in size; with this number two threads get equal work
  const std::size_t count = sample.chunks.size() * kCopies;
  std::vector<std::unique_ptr<laz::ChunkDecoder>> decoders;
  std::vector<std::vector<std::byte>> out(count);
  for (std::size_t i = 0; i < count; ++i) {
    decoders.push_back(std::make_unique<laz::ChunkDecoder>(sample.layout));
    out[i].resize(sample.chunks[i / kCopies].records.size());
  }
  with_threads(threads, [&] {
    for (auto _ : state) {
      parallel_for(count, [&](std::size_t i) {
        const bool ok = laz::decode_chunk(*decoders[i], sample.chunks[i / kCopies].bytes, out[i],
                                          sample.layout.record_length, fields);
        if (!ok) throw Error("a chunk did not decode");
      });
    }
  });
  if (fields == kAllFields && out[0] != sample.chunks[0].records) state.SkipWithError("wrong points");
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(sample.points * kCopies));
}

void encode(benchmark::State& state, const Sample& sample) {
  laz::ChunkEncoder encoder(sample.layout);
  std::vector<std::byte> out;
  for (auto _ : state) {
    for (const Chunk& c : sample.chunks) {
      out.clear();
      encoder.encode(c.records, out);
      benchmark::DoNotOptimize(out.data());
    }
  }
  count_points(state, sample);
}

void add_benchmarks(const std::string& name, Sample loaded) {
  const auto sample = std::make_shared<const Sample>(std::move(loaded));
  const std::string prefix = "laz/" + name;
  const auto add = [](const std::string& title, auto body) {
    benchmark::RegisterBenchmark(title.c_str(), body)->UseRealTime()->Unit(benchmark::kMillisecond);
  };
  for (const int threads : {1, 2}) {
    add(prefix + "/decode/threads:" + std::to_string(threads),
        [=](benchmark::State& s) { decode(s, *sample, kAllFields, threads); });
  }
  if (sample->layout.layered()) {
    add(prefix + "/decode_xyz_class", [=](benchmark::State& s) { decode(s, *sample, kFieldZ | kFieldClass, 1); });
  }
  add(prefix + "/encode", [=](benchmark::State& s) { encode(s, *sample); });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const char *file = std::getenv("ILOT_BENCH_LAZ"), *data = std::getenv("ILOT_DATA");
  if (file) {
    add_benchmarks("file", load_sample(file));
  } else if (data) {
    const std::filesystem::path ign = std::filesystem::path(data) / "ign";
    add_benchmarks("format3", load_sample(ign / "77050_627755_pf3.laz"));
    const Sample eight = load_sample(ign / "77050_627755_pf8.laz");
    add_benchmarks("format6", as_format_6(eight));
    add_benchmarks("format7", load_sample(std::filesystem::path(data) / "minimalhouse/minimal_house_12.laz"));
    add_benchmarks("format8", eight);
  }
  benchmark::RunSpecifiedBenchmarks();
}
