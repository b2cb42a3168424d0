// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>

#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/layered.h"
#include "engine/formats/laz/pointwise.h"

namespace ilot::laz {

class ChunkEncoder::Implementation {
 public:
  virtual ~Implementation() = default;
  virtual void encode(std::span<const std::byte> records, std::vector<std::byte>& out) = 0;

 protected:
  std::uint32_t epoch_ = 0;
};

namespace {

void append_number(std::vector<std::byte>& out, std::uint32_t v) {
  std::byte bytes[4];
  store(bytes, v);
  append(out, bytes);
}

template <class Items>
class PointwiseEncoder final : public ChunkEncoder::Implementation {
 public:
  explicit PointwiseEncoder(const ChunkLayout& layout)
      : record_length_(layout.record_length), codec_(std::make_unique<PointwiseCodec<Items>>(layout)) {}

  void encode(std::span<const std::byte> records, std::vector<std::byte>& out) override {
    encoder_.start(++epoch_);
    codec_->start(records.data());
    for (std::size_t at = record_length_; at < records.size(); at += record_length_) {
      codec_->code(encoder_, records.data() + at);
    }
    append(out, records.first(record_length_));
    append(out, encoder_.finish());
  }

 private:
  std::size_t record_length_;
  Encoder encoder_;
  std::unique_ptr<PointwiseCodec<Items>> codec_;
};

class LayeredEncoder final : public ChunkEncoder::Implementation {
 public:
  explicit LayeredEncoder(const ChunkLayout& layout) : record_length_(layout.record_length), codec_(layout) {}

  void encode(std::span<const std::byte> records, std::vector<std::byte>& out) override {
    ++epoch_;
    for (Stream<Encoder>& s : codec_.streams()) {
      s.coder.start(epoch_);
      s.active = false;
    }
    mark_constants(records);
    codec_.start(records.data());
    for (std::size_t at = record_length_; at < records.size(); at += record_length_) {
      codec_.code(records.data() + at);
    }
    codec_.streams()[kLayerXy].active = codec_.streams()[kLayerZ].active = true;
    append(out, records.first(record_length_));
    append_number(out, static_cast<std::uint32_t>(records.size() / record_length_));
    append_streams(out);
  }

 private:
  // Streams in which nothing changes are dropped at the end, so their symbols need not be coded. A stream of colours is
  // an exception, because its symbols also say that a colour is not grey.
  void mark_constants(std::span<const std::byte> records) {
    changed_.assign(record_length_, std::byte{0});
    for (std::size_t at = record_length_; at < records.size(); at += record_length_)
      mark_changes(records.data() + at, records.data());
    const LayeredPlan& plan = codec_.plan();
    const auto mark = [&](std::uint32_t layer, std::size_t first, std::size_t count) {
      const auto bytes = std::span(changed_).subspan(first, count);
      codec_.streams()[layer].constant =
          std::all_of(bytes.begin(), bytes.end(), [](std::byte b) { return b == std::byte{0}; });
    };
    mark(kLayerClass, offsetof(Point14, classification), 1);
    mark(kLayerFlags, offsetof(Point14, flags), 1);
    mark(kLayerIntensity, offsetof(Point14, intensity), 2);
    mark(kLayerUser, offsetof(Point14, user), 1);
    if (plan.nir) mark(plan.nir_layer, plan.nir, 2);
    for (std::uint32_t i = 0; i < plan.extra_count; ++i) mark(plan.extra_layer + i, plan.extra + i, 1);
  }

  void mark_changes(const std::byte* record, const std::byte* first) {
    constexpr std::size_t kWord = sizeof(std::uint64_t);
    std::byte* const changed = changed_.data();
    std::size_t i = 0;
    for (; i + kWord <= record_length_; i += kWord)
      store(changed + i,
            load<std::uint64_t>(changed + i) | (load<std::uint64_t>(record + i) ^ load<std::uint64_t>(first + i)));
    for (; i < record_length_; ++i) changed[i] |= record[i] ^ first[i];
  }

  void append_streams(std::vector<std::byte>& out) {
    streams_.clear();
    for (Stream<Encoder>& s : codec_.streams()) {
      streams_.push_back(s.active ? s.coder.finish() : std::span<const std::byte>());
      append_number(out, static_cast<std::uint32_t>(streams_.back().size()));
    }
    for (const auto& s : streams_) append(out, s);
  }

  std::size_t record_length_;
  LayeredCodec<Encoder> codec_;
  std::vector<std::byte> changed_;  // per byte of a record: the bits that differ from the first record in some record
  std::vector<std::span<const std::byte>> streams_;
};

}  // namespace

std::size_t encoder_bytes(const ChunkLayout& layout) {
  constexpr std::size_t kStandard = std::size_t{1}
                                    << 20;  // 1.0 MiB for format 3; more for each scanner channel of layered formats
  return kStandard + (layout.record_length - standard_size(layout.point_format)) * sizeof(Encoder::Model<256>);
}

ChunkEncoder::ChunkEncoder(const ChunkLayout& layout) {
  if (layout.layered()) {
    implementation_ = std::make_unique<LayeredEncoder>(layout);
  } else if (layout.item_version == 1) {
    implementation_ = std::make_unique<PointwiseEncoder<ItemsV1<Encoder>>>(layout);
  } else {
    implementation_ = std::make_unique<PointwiseEncoder<ItemsV2<Encoder>>>(layout);
  }
}
ChunkEncoder::~ChunkEncoder() = default;
ChunkEncoder::ChunkEncoder(ChunkEncoder&&) noexcept = default;
ChunkEncoder& ChunkEncoder::operator=(ChunkEncoder&&) noexcept = default;

void ChunkEncoder::encode(std::span<const std::byte> records, std::vector<std::byte>& out) {
  implementation_->encode(records, out);
}

}  // namespace ilot::laz
