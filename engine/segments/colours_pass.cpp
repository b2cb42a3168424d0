// SPDX-License-Identifier: Apache-2.0
#include "engine/segments/colours_pass.h"

#include <algorithm>
#include <array>
#include <string>

#include "engine/cloud/record.h"
#include "engine/error.h"
#include "engine/pass/pass.h"
#include "kernels/core/radix_sort.h"
#include "kernels/core/rng.h"
#include "kernels/planes/colour_classes.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kBytesPerPoint = 40;
constexpr std::uint64_t kRows = 1 << 16;  // read or gathered at a time
constexpr std::uint64_t kSample = std::uint64_t{1} << 17;

struct RawColour {
  std::uint16_t r = 0, g = 0, b = 0;
};

fs::path colour_file(const Store& store, std::size_t file) {
  return store.folder() / "colours" / ("f" + std::to_string(file));
}

// The colours of one input by row, and at the end the largest channel.
void write_colours(PointReader& input, const fs::path& path) {
  const RecordLayout& layout = input.info().layout;
  const std::size_t at = *rgb_offset(layout.point_format);
  std::vector<std::byte> records(kRows * layout.record_length);
  std::vector<std::uint8_t> valid(kRows);
  std::vector<RawColour> colours;
  RawColour most;
  ColumnWriter writer(path);
  for (std::uint64_t first = 0; first < input.info().points; first += kRows) {
    const std::uint64_t n = std::min(kRows, input.info().points - first);
    if (input.read(first, std::span(records).first(n * layout.record_length), std::span(valid).first(n)) != n)
      throw Error(input.info().path.string() + ": can no longer be read in full; the file changed during the run");
    colours.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const std::byte* rgb = records.data() + i * layout.record_length + at;
      colours[i] = {load<std::uint16_t>(rgb), load<std::uint16_t>(rgb + 2), load<std::uint16_t>(rgb + 4)};
      if (valid[i] != 0) most.r = std::max({most.r, colours[i].r, colours[i].g, colours[i].b});
    }
    writer.append<RawColour>(colours);
  }
  writer.append<RawColour>(std::span(&most, 1));
  writer.commit();
}

// Colours of one input by row, read in windows that follow rising rows.
class ColourFile {
 public:
  explicit ColourFile(const fs::path& path) : reader_(path), rows_(reader_.size() / sizeof(RawColour) - 1) {
    RawColour most;
    reader_.read<RawColour>(rows_, std::span(&most, 1));
    shift_ = most.r > 255 ? 8 : 0;
  }
  StoredColour at(std::uint64_t row) {
    if (row < first_ || row >= first_ + window_.size()) {
      first_ = row;
      window_.resize(std::min(kRows, rows_ - row));
      reader_.read<RawColour>(first_, window_);
    }
    const RawColour& c = window_[row - first_];
    const auto byte = [&](std::uint16_t v) { return static_cast<StoredColour>(v >> shift_); };
    return byte(c.r) << 16 | byte(c.g) << 8 | byte(c.b);
  }

 private:
  ColumnReader reader_;
  std::uint64_t rows_, first_ = 0;
  int shift_ = 0;
  std::vector<RawColour> window_;
};

void gather(const Store& store, std::uint32_t block, const std::vector<std::uint8_t>& coloured) {
  const auto order = store.read<InputOrder>(block, "order");
  std::vector<StoredColour> colour(order.size(), kNoColour);
  std::unique_ptr<ColourFile> file;
  std::uint64_t open = UINT64_MAX;
  for (const std::uint32_t i : sorted_order(order)) {
    const std::uint64_t from = file_of(order[i]);
    if (coloured[from] == 0) continue;
    if (from != open) file = std::make_unique<ColourFile>(colour_file(store, open = from));
    colour[i] = file->at(row_of(order[i]));
  }
  store.write<StoredColour>(block, "colour", colour);
}

Lab lab_of(StoredColour c) {
  return ilot::lab_of(static_cast<std::uint8_t>(c >> 16), static_cast<std::uint8_t>(c >> 8),
                      static_cast<std::uint8_t>(c));
}

}  // namespace

bool colours_pass(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                  const PassContext& context) {
  std::vector<std::uint8_t> coloured(inputs.size());
  std::vector<PassTask> tasks;
  std::vector<std::size_t> files;
  for (std::size_t f = 0; f < inputs.size(); ++f) {
    const RecordLayout& layout = inputs[f]->info().layout;
    if (!rgb_offset(layout.point_format) || inputs[f]->info().points == 0) continue;
    coloured[f] = 1;
    files.push_back(f);
    tasks.push_back({kRows * (layout.record_length + sizeof(RawColour)), inputs[f]->info().points});
  }
  if (files.empty()) return false;
  fs::create_directories(store.folder() / "colours");
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const fs::path path = colour_file(store, files[i]);
    if (!fs::exists(path)) write_colours(*inputs[files[i]], path);
  });
  tasks.clear();
  for (const Block& b : store.blocks()) tasks.push_back({b.points * kBytesPerPoint, b.points});
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    if (!store.has(block, "colour")) gather(store, block, coloured);
  });
  return true;
}

std::uint32_t ColourPalette::class_of(StoredColour colour) const {
  if (colour == kNoColour) return 0;
  const Lab lab = lab_of(colour);
  std::uint32_t best = 0;
  double least = 0;
  for (std::uint32_t c = 0; c < centre.size(); ++c) {
    double d2 = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double d = lab[axis] - centre[c][axis];
      d2 += d * d;
    }
    if (best != 0 && d2 >= least) continue;
    best = c + 1;
    least = d2;
  }
  return best;
}

ColourPalette colour_palette(const Store& store, std::uint32_t k, std::uint64_t seed) {
  const std::uint64_t stride = std::max<std::uint64_t>(1, store.points() / kSample);
  std::vector<std::uint8_t> r, g, b;
  for (std::uint32_t block = 0; block < store.blocks().size(); ++block) {
    const std::uint32_t points = store.blocks()[block].points;
    for (std::uint32_t first = 0; first < points; first += kRows) {
      const auto n = std::min(static_cast<std::uint32_t>(kRows), points - first);
      const auto codes = store.read<std::uint64_t>(block, "codes", first, n);
      const auto colours = store.read<StoredColour>(block, "colour", first, n);
      for (std::size_t i = 0; i < n; ++i) {
        if (colours[i] == kNoColour || mix64(codes[i]) % stride != 0) continue;
        r.push_back(static_cast<std::uint8_t>(colours[i] >> 16));
        g.push_back(static_cast<std::uint8_t>(colours[i] >> 8));
        b.push_back(static_cast<std::uint8_t>(colours[i]));
      }
    }
  }
  ColourClassParams params;
  params.k = k;
  params.key = seed;
  return {colour_classes({r, g, b, {}}, params).centre};
}

}  // namespace ilot
