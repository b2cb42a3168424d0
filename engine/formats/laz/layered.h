// SPDX-License-Identifier: Apache-2.0
// All items of one point of formats 6-10, in a stream for each attribute.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "engine/cloud/record.h"
#include "engine/formats/laz/chunk.h"
#include "engine/formats/laz/colour.h"
#include "engine/formats/laz/layered_plan.h"
#include "engine/formats/laz/point14.h"
#include "engine/formats/laz/wavepacket.h"

namespace ilot::laz {

template <class Coder>
class LayeredCodec {
 public:
  using Byte = std::conditional_t<Coder::kEncodes, const std::byte, std::byte>;

  explicit LayeredCodec(const ChunkLayout& layout)
      : plan_(layout), own_channel_(layout.item_version == 4), streams_(plan_.layers) {}

  const LayeredPlan& plan() const { return plan_; }
  std::vector<Stream<Coder>>& streams() { return streams_; }
  const std::vector<Stream<Coder>>& streams() const { return streams_; }

  void start(const std::byte* first) {
    const Point14 p = Point14::from(first);
    core_.start(p);
    for (auto& t : tails_) {
      if (t) t->used = false;
    }
    tail_ = p.channel();
    open_tail(tail_, first);
  }

  void code(Byte* record) {
    Point14 p{};
    if constexpr (kEncodes) p = Point14::from(record);
    const bool new_channel = core_.code(streams_.data(), p);
    if constexpr (!kEncodes) core_.last().to(record);
    if (plan_.record_length > Point14::kSize) code_tail(record, new_channel);
  }

 private:
  static constexpr bool kEncodes = Coder::kEncodes;
  using ByteModel = typename Coder::template Model<256>;

  // Models of the items behind the core, and the last record's bytes behind the core: one set for each
  // scanner channel.
  struct Tail {
    explicit Tail(const LayeredPlan& plan) : last(plan.record_length), extra(plan.extra_count) {}
    bool used = false;
    std::vector<std::byte> last;  // as a record, of which the core is not used
    std::vector<ByteModel> extra;
    RgbCodec<Coder> rgb{};
    NirCodec<Coder> nir{};
    WavepacketCodec<Coder> wave{};
  };

  void open_tail(std::uint32_t index, const std::byte* last) {
    if (!tails_[index]) tails_[index] = std::make_unique<Tail>(plan_);
    Tail& t = *tails_[index];
    t.used = true;
    t.wave.start();
    std::copy_n(last, t.last.size(), t.last.begin());
  }

  // The models to code by and the last values to predict from need not belong together: item version 3 takes
  // channel 0 for a point that stays in its channel, and on a change to a set in use keeps the old one's
  // values for one point.
  void code_tail(Byte* record, bool new_channel) {
    const std::uint32_t wanted = own_channel_ || new_channel ? core_.channel() : 0;
    std::uint32_t values = tail_;
    if (wanted != tail_) [[unlikely]] {
      const bool fresh = !tails_[wanted] || !tails_[wanted]->used;
      if (fresh) open_tail(wanted, tails_[tail_]->last.data());
      if (fresh || own_channel_) values = wanted;
      tail_ = wanted;
    }
    Tail& models = *tails_[tail_];
    std::byte* last = tails_[values]->last.data();
    const std::size_t size = plan_.record_length - Point14::kSize;
    if constexpr (!kEncodes) std::memcpy(record + Point14::kSize, last + Point14::kSize, size);
    if (plan_.rgb) code_rgb(models, last, record);
    if (plan_.nir) code_nir(models, last, record);
    if (plan_.wave) code_wave(models, last, record);
    if (plan_.extra_count) code_extra(models, last, record);
    std::memcpy(last + Point14::kSize, record + Point14::kSize, size);
  }

  static bool is_left_out(const Stream<Coder>& s) { return kEncodes ? s.constant : !s.active; }

  void code_rgb(Tail& models, const std::byte* last, Byte* record) {
    Stream<Coder>& s = streams_[plan_.rgb_layer];
    if (is_left_out(s)) return;
    Rgb value = load<Rgb>(record + plan_.rgb);
    const std::uint32_t changed = models.rgb.code(s.coder, load<Rgb>(last + plan_.rgb), value);
    s.active |= changed != 0;
    if constexpr (!kEncodes) store(record + plan_.rgb, value);
  }
  void code_nir(Tail& models, const std::byte* last, Byte* record) {
    Stream<Coder>& s = streams_[plan_.nir_layer];
    if (is_left_out(s)) return;
    auto value = load<std::uint16_t>(record + plan_.nir);
    const std::uint32_t changed = models.nir.code(s.coder, load<std::uint16_t>(last + plan_.nir), value);
    s.active |= changed != 0;
    if constexpr (!kEncodes) store(record + plan_.nir, value);
  }
  void code_wave(Tail& models, const std::byte* last, Byte* record) {
    Stream<Coder>& s = streams_[plan_.wave_layer];
    if (is_left_out(s)) return;
    Wavepacket w = Wavepacket::from(record + plan_.wave);
    models.wave.code(s.coder, Wavepacket::from(last + plan_.wave), w);
    s.active |= std::memcmp(last + plan_.wave, record + plan_.wave, kWavepacketSize) != 0;
    if constexpr (!kEncodes) w.to(record + plan_.wave);
  }
  void code_extra(Tail& models, const std::byte* last, Byte* record) {
    for (std::uint32_t i = 0; i < plan_.extra_count; ++i) {
      Stream<Coder>& s = streams_[plan_.extra_layer + i];
      if (is_left_out(s)) continue;
      const auto before = static_cast<std::uint32_t>(last[plan_.extra + i]);
      const auto after = static_cast<std::uint32_t>(record[plan_.extra + i]);
      const std::uint32_t difference = s.coder.symbol(models.extra[i], (after - before) & 255u);
      s.active |= difference != 0;
      if constexpr (!kEncodes) record[plan_.extra + i] = static_cast<std::byte>(before + difference);
    }
  }

  LayeredPlan plan_;
  bool own_channel_;
  std::vector<Stream<Coder>> streams_;
  Point14Codec<Coder> core_;
  std::array<std::unique_ptr<Tail>, 4> tails_;
  std::uint32_t tail_ = 0;
};

}  // namespace ilot::laz
