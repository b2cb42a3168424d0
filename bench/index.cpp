// SPDX-License-Identifier: Apache-2.0
// Times the way from a file on disk to blocks on disk, against decoding alone: seconds per million points and the
// median of their ratios, pair by pair. usage: bench_index FILE FOLDER [THREADS] [PAIRS]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/pass/index.h"
#include "engine/pass/input_lattice.h"
#include "kernels/core/parallel.h"
#include "kernels/core/quantile.h"

namespace {

using namespace ilot;
using Inputs = std::vector<std::unique_ptr<PointReader>>;

template <class Body>
double seconds_of(const Body& body) {
  const auto start = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Decodes all rows with all their attributes into memory that is not used.
void decode(PointReader& reader) {
  const std::vector<std::uint64_t> cuts = reader.boundaries();
  const std::size_t length = reader.info().layout.record_length;
  parallel_for(cuts.size() - 1, [&](std::size_t i) {
    const std::uint64_t rows = cuts[i + 1] - cuts[i];
    std::vector<std::byte> records(rows * length);
    std::vector<std::uint8_t> valid(rows);
    if (reader.read(cuts[i], records, valid) != rows) throw Error("a row could not be read");
  });
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: bench_index FILE FOLDER [THREADS] [PAIRS]\n");
    return 2;
  }
  const std::filesystem::path folder = argv[2];
  const int threads = argc > 3 ? std::atoi(argv[3]) : 2, pairs = argc > 4 ? std::atoi(argv[4]) : 7;
  Inputs inputs;
  inputs.push_back(open_cloud(argv[1]));
  const double millions = static_cast<double>(inputs[0]->info().points) / 1e6;
  const InputLattice lattice = common_lattice(inputs, 1);
  IndexParams params;
  params.unit = lattice.unit;
  params.multiple = lattice.multiple;
  std::vector<double> decoding, indexing, ratios;
  with_threads(threads, [&] {
    for (int i = 0; i < pairs; ++i) {
      decoding.push_back(seconds_of([&] { decode(*inputs[0]); }) / millions);
      std::filesystem::remove_all(folder);
      indexing.push_back(seconds_of([&] { build_index(inputs, params, folder, {}); }) / millions);
      ratios.push_back(indexing.back() / decoding.back());
    }
  });
  std::filesystem::remove_all(folder);
  std::printf("threads %d  decode %.4f s/M  blocks on disk %.4f s/M  ratio %.3f (median of %d pairs)\n", threads,
              upper_median(decoding), upper_median(indexing), upper_median(ratios), pairs);
}
