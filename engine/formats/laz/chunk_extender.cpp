// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/chunk_extender.h"

#include <algorithm>
#include <array>

#include "engine/cloud/record.h"
#include "engine/formats/laz/channel_sets.h"
#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/encoder.h"
#include "engine/formats/laz/layered_plan.h"
#include "engine/formats/laz/point14_record.h"

namespace ilot::laz {
namespace {

using ByteModel = Encoder::Model<256>;

// How the bytes of a row are coded: which models are used, and which row is the reference.
struct RowContext {
  std::uint32_t models = 0, before = 0;
};

std::vector<RowContext> row_contexts(const ChunkLayout& layout, std::span<const std::byte> records) {
  const std::size_t rows = records.size() / layout.record_length;
  const auto channel_of = [&](std::size_t row) {
    return Point14::from(records.data() + row * layout.record_length).channel();
  };
  ChannelSets sets(layout);
  std::array<std::uint32_t, 4> last_row{};  // for each set
  std::uint32_t channel = channel_of(0);
  sets.start(channel);
  std::vector<RowContext> contexts(rows);
  for (std::uint32_t row = 1; row < rows; ++row) {
    const std::uint32_t before = channel;
    channel = channel_of(row);
    const ChannelSets::Choice set = sets.next(channel, channel != before);
    if (set.opened) last_row[set.models] = last_row[set.origin];
    contexts[row] = {set.models, last_row[set.values]};
    last_row[set.values] = row;
  }
  return contexts;
}

// Codes one byte of all rows. False: nothing changes in it, and it has no stream.
bool code_byte(const std::byte* first, std::size_t stride, std::span<const RowContext> rows,
               std::array<ByteModel, 4>& models, Encoder& coder) {
  const auto value = [&](std::size_t row) { return static_cast<std::uint32_t>(first[row * stride]); };
  bool constant = true;
  for (std::size_t row = 1; row < rows.size() && constant; ++row) constant = value(row) == value(0);
  if (constant) return false;
  for (std::size_t row = 1; row < rows.size(); ++row)
    coder.symbol(models[rows[row].models], (value(row) - value(rows[row].before)) & 255u);
  return true;
}

}  // namespace

bool extend_chunk(const ChunkLayout& layout, std::span<const std::byte> chunk, std::span<const std::byte> records,
                  std::span<const std::byte> appended, std::vector<std::byte>& out) {
  if (!layout.layered() || records.empty()) return false;
  const std::size_t rows = records.size() / layout.record_length, length = appended.size() / rows;
  const LayeredExtent extent = layered_extent(layout, chunk, chunk.size());
  if (extent.points != rows) return false;
  const std::vector<RowContext> contexts = row_contexts(layout, records);
  std::array<ByteModel, 4> models{};
  Encoder coder;
  std::vector<std::byte> streams, sizes(4 * length);
  for (std::size_t i = 0; i < length; ++i) {
    coder.start(static_cast<std::uint32_t>(i + 1));
    const std::size_t begin = streams.size();
    if (code_byte(appended.data() + i, length, contexts, models, coder)) append(streams, coder.finish());
    store(sizes.data() + 4 * i, static_cast<std::uint32_t>(streams.size() - begin));
  }
  const std::size_t head = LayeredPlan(layout).fixed_bytes();
  append(out, chunk.first(layout.record_length));
  append(out, appended.first(length));
  append(out, chunk.subspan(layout.record_length, head - layout.record_length));
  append(out, sizes);
  append(out, chunk.subspan(head, extent.bytes - head));
  append(out, streams);
  return true;
}

}  // namespace ilot::laz
