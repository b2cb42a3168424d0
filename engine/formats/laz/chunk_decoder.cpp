// SPDX-License-Identifier: Apache-2.0
#include <optional>

#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/layered.h"
#include "engine/formats/laz/pointwise.h"

namespace ilot::laz {

namespace {

std::uint32_t layer_field(const LayeredPlan& plan, std::uint32_t layer) {
  constexpr std::uint32_t kCore[kCoreLayers] = {~0u,         kFieldZ,    kFieldClass,  kFieldFlags,  kFieldIntensity,
                                                kFieldAngle, kFieldUser, kFieldSource, kFieldGpsTime};
  if (layer < kCoreLayers) return kCore[layer];
  if (layer >= plan.extra_layer) return kFieldExtra;
  if (layer == plan.rgb_layer) return kFieldRgb;
  return layer == plan.nir_layer ? kFieldNir : kFieldWavepacket;
}

}  // namespace

class ChunkDecoder::Implementation {
 public:
  virtual ~Implementation() = default;
  virtual bool begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t fields) = 0;
  virtual void go_on(std::span<const std::byte> rest) = 0;
  virtual bool next(std::byte* records, std::size_t count) = 0;
  virtual std::size_t consumed() const = 0;
  virtual bool ended_well() const = 0;

  bool fill(std::span<std::byte> records) {
    const std::size_t count = records.size() / record_length_;
    if (count > left_) return false;
    std::size_t done = 0;
    if (at_first_ && count > 0) {
      std::memcpy(records.data(), chunk_.data(), record_length_);
      at_first_ = false;
      done = 1;
    }
    left_ -= count;
    return next(records.data() + done * record_length_, count - done);
  }

 protected:
  explicit Implementation(std::size_t record_length) : record_length_(record_length) {}
  void restart(std::span<const std::byte> chunk, std::uint64_t points) {
    chunk_ = chunk;
    left_ = points;
    at_first_ = true;
    ++epoch_;
  }

  std::size_t record_length_;
  std::span<const std::byte> chunk_;
  std::uint64_t left_ = 0;
  std::uint32_t epoch_ = 0;
  bool at_first_ = false;
};

namespace {

template <class Items>
class PointwiseDecoder final : public ChunkDecoder::Implementation {
 public:
  explicit PointwiseDecoder(const ChunkLayout& layout)
      : Implementation(layout.record_length), codec_(std::make_unique<PointwiseCodec<Items>>(layout)) {}

  bool begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t) override {
    if (chunk.size() < record_length_ + 4) return false;
    restart(chunk, points);
    decoder_.start(chunk, chunk.subspan(record_length_), epoch_);
    codec_->start(chunk.data());
    first_.assign(chunk.begin(), chunk.begin() + static_cast<std::ptrdiff_t>(record_length_));
    chunk_ = first_;
    end_ = chunk.size();
    return true;
  }
  void go_on(std::span<const std::byte> rest) override {
    end_ = consumed() + rest.size();
    decoder_.move_to(rest);
  }
  bool next(std::byte* records, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) codec_->code(decoder_, records + i * record_length_);
    return !decoder_.overrun();
  }
  std::size_t consumed() const override { return record_length_ + decoder_.consumed(); }
  bool ended_well() const override { return !decoder_.overrun() && consumed() == end_; }

 private:
  Decoder decoder_;
  std::unique_ptr<PointwiseCodec<Items>> codec_;
  std::vector<std::byte> first_;  // the raw point, which is needed longer than its window
  std::size_t end_ = 0;           // of the part of the chunk that was given so far
};

class LayeredDecoder final : public ChunkDecoder::Implementation {
 public:
  explicit LayeredDecoder(const ChunkLayout& layout)
      : Implementation(layout.record_length), layout_(layout), codec_(layout), sizes_(codec_.plan().layers) {}

  bool begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t fields) override {
    const LayeredExtent extent = layered_extent(layout_, chunk, chunk.size());
    if (extent.points != points || points == 0) return false;
    restart(chunk.first(extent.bytes), points);
    std::size_t at = codec_.plan().fixed_bytes();
    for (std::uint32_t i = 0; i < codec_.plan().layers; ++i) {
      sizes_[i] = load<std::uint32_t>(chunk.data() + record_length_ + 4 + 4 * std::size_t{i});
      Stream<Decoder>& s = codec_.streams()[i];
      s.active = sizes_[i] > 0 && (fields & layer_field(codec_.plan(), i)) != 0;
      if (s.active) s.coder.start(chunk_, chunk_.subspan(at, sizes_[i]), epoch_);
      at += sizes_[i];
    }
    if (!codec_.streams()[kLayerXy].active) return false;
    codec_.start(chunk_.data());
    return true;
  }
  void go_on(std::span<const std::byte>) override {}  // its streams are side by side, so the chunk is given whole
  bool next(std::byte* records, std::size_t count) override {
    for (std::size_t i = 0; i < count; ++i) codec_.code(records + i * record_length_);
    for (const Stream<Decoder>& s : codec_.streams()) {
      if (s.active && s.coder.overrun()) return false;
    }
    return true;
  }
  std::size_t consumed() const override { return chunk_.size(); }
  bool ended_well() const override {
    for (std::size_t i = 0; i < sizes_.size(); ++i) {
      const Stream<Decoder>& s = codec_.streams()[i];
      if (s.active && (s.coder.overrun() || s.coder.consumed() != sizes_[i])) return false;
    }
    return true;
  }

 private:
  ChunkLayout layout_;
  LayeredCodec<Decoder> codec_;
  std::vector<std::uint32_t> sizes_;
};

}  // namespace

ChunkDecoder::ChunkDecoder(const ChunkLayout& layout) {
  if (layout.layered()) {
    implementation_ = std::make_unique<LayeredDecoder>(layout);
  } else if (layout.item_version == 1) {
    implementation_ = std::make_unique<PointwiseDecoder<ItemsV1<Decoder>>>(layout);
  } else {
    implementation_ = std::make_unique<PointwiseDecoder<ItemsV2<Decoder>>>(layout);
  }
}
ChunkDecoder::~ChunkDecoder() = default;
ChunkDecoder::ChunkDecoder(ChunkDecoder&&) noexcept = default;
ChunkDecoder& ChunkDecoder::operator=(ChunkDecoder&&) noexcept = default;

bool ChunkDecoder::begin(std::span<const std::byte> chunk, std::uint64_t points, std::uint32_t fields) {
  return points > 0 && implementation_->begin(chunk, points, fields);
}
void ChunkDecoder::go_on(std::span<const std::byte> rest) {
  implementation_->go_on(rest);
}
bool ChunkDecoder::next(std::span<std::byte> records) {
  return implementation_->fill(records);
}
std::size_t ChunkDecoder::consumed() const {
  return implementation_->consumed();
}
bool ChunkDecoder::ended_well() const {
  return implementation_->ended_well();
}

bool decode_chunk(ChunkDecoder& decoder, std::span<const std::byte> chunk, std::span<std::byte> records,
                  std::uint16_t record_length, std::uint32_t fields) {
  return decoder.begin(chunk, records.size() / record_length, fields) && decoder.next(records) && decoder.ended_well();
}

std::size_t layered_head(const ChunkLayout& layout) {
  return LayeredPlan(layout).fixed_bytes();
}

LayeredExtent layered_extent(const ChunkLayout& layout, std::span<const std::byte> head, std::uint64_t available) {
  const LayeredPlan plan(layout);
  if (head.size() < plan.fixed_bytes()) return {};
  const std::byte* sizes = head.data() + plan.record_length + 4;
  std::uint64_t bytes = plan.fixed_bytes();
  for (std::uint32_t i = 0; i < plan.layers; ++i) {
    const auto size = load<std::uint32_t>(sizes + 4 * std::size_t{i});
    if (size > 0 && size < 4) return {};
    bytes += size;
  }
  if (bytes > available) return {};
  return {load<std::uint32_t>(head.data() + plan.record_length), bytes};
}

}  // namespace ilot::laz
