// SPDX-License-Identifier: Apache-2.0
// All items of one point of formats 6-10, with one stream for each attribute.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "engine/cloud/record.h"
#include "engine/formats/laz/channel_sets.h"
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

  explicit LayeredCodec(const ChunkLayout& layout) : plan_(layout), sets_(layout), streams_(plan_.layers) {}

  const LayeredPlan& plan() const { return plan_; }
  std::vector<Stream<Coder>>& streams() { return streams_; }
  const std::vector<Stream<Coder>>& streams() const { return streams_; }

  void start(const std::byte* first) {
    const Point14 p = Point14::from(first);
    core_.start(p);
    sets_.start(p.channel());
    open_tail(p.channel(), first);
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

  // The models of the items behind the core and the last record's bytes behind the core: one set for each scanner
  // channel.
  struct Tail {
    explicit Tail(const LayeredPlan& plan) : last(plan.record_length), extra(plan.extra_count) {}
    std::vector<std::byte> last;  // a whole record, whose core is not used
    std::vector<ByteModel> extra;
    RgbCodec<Coder> rgb{};
    NirCodec<Coder> nir{};
    WavepacketCodec<Coder> wave{};
  };

  void open_tail(std::uint32_t index, const std::byte* last) {
    if (!tails_[index]) tails_[index] = std::make_unique<Tail>(plan_);
    Tail& t = *tails_[index];
    t.wave.start();
    std::copy_n(last, t.last.size(), t.last.begin());
  }

  void code_tail(Byte* record, bool new_channel) {
    const ChannelSets::Choice set = sets_.next(core_.channel(), new_channel);
    if (set.opened) [[unlikely]]
      open_tail(set.models, tails_[set.origin]->last.data());
    Tail& models = *tails_[set.models];
    std::byte* last = tails_[set.values]->last.data();
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
  ChannelSets sets_;
  std::vector<Stream<Coder>> streams_;
  Point14Codec<Coder> core_;
  std::array<std::unique_ptr<Tail>, 4> tails_;
};

}  // namespace ilot::laz
