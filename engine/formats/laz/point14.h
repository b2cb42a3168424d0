// SPDX-License-Identifier: Apache-2.0
// The core of point formats 6-10, one stream per attribute and one set of models per scanner channel.
#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include "engine/cloud/record.h"
#include "engine/formats/laz/gps_time.h"
#include "engine/formats/laz/layered_plan.h"
#include "engine/formats/laz/point14_record.h"
#include "engine/formats/laz/predict.h"

namespace ilot::laz {

// A stream and its state. When decoding, `active` says whether the stream is decoded at all. When encoding, it says
// whether anything changed in it; a stream without a change is dropped.
template <class Coder>
struct Stream {
  Coder coder;
  bool active = false;
  bool constant = false;  // encoding: nothing changes in the stream, so none of its symbols is coded
};

template <class Coder>
class Point14Codec {
 public:
  void start(const Point14& first) {
    for (auto& c : channels_) {
      if (c) c->used = false;
    }
    current_ = first.channel();
    open_channel(current_, first);
  }

  std::uint32_t channel() const { return current_; }

  // Encodes p, or decodes a point, which is last() then. Returns whether the scanner channel differs from that of the
  // last point. Decoding works in place, value by value: a copy of fields that were just written would wait for all of
  // them, and so would the next point.
  bool code(Stream<Coder>* streams, const Point14& p) {
    const std::uint32_t change = code_change(streams[kLayerXy].coder, channels_[current_]->last, p);
    Channel& c = *channels_[current_];
    if constexpr (kEncodes) {
      Point14 value = p;
      code_values(streams, c, value, change);
      c.last = value;
    } else {
      code_values(streams, c, c.last, change);
    }
    c.new_time = change & kGps;
    return change & kChannel;
  }

  const Point14& last() const { return channels_[current_]->last; }

 private:
  static constexpr bool kEncodes = Coder::kEncodes;
  enum Change : std::uint32_t { kReturnMask = 3, kReturnCount = 4, kAngle = 8, kGps = 16, kSource = 32, kChannel = 64 };
  using ByteModel = typename Coder::template Model<256>;
  template <std::uint32_t kSymbols>
  using Model = typename Coder::template Model<kSymbols>;

  struct Channel {
    Point14 last;
    bool used, new_time;
    std::int32_t last_z[8];
    std::uint16_t last_intensity[8];
    Median5 x_steps[12], y_steps[12];
    Model<128> change[8];
    Model<3> channel;
    Model<16> return_count[16], return_number[16];
    Model<13> return_number_same_time;
    IntegerCodec<Coder, 32, 2> x;
    IntegerCodec<Coder, 32, 22> y;
    IntegerCodec<Coder, 32, 20> z;
    IntegerCodec<Coder, 16, 4> intensity;
    IntegerCodec<Coder, 16, 2> angle;
    IntegerCodec<Coder, 16, 1> source;
    GpsTimeCodec<Coder, false> gps;
    Model<64> flags[64];
    ByteModel classification[64], user[64];
  };

  void open_channel(std::uint32_t index, const Point14& from) {
    if (!channels_[index]) channels_[index] = std::make_unique<Channel>();
    Channel& c = *channels_[index];
    c.used = true;
    c.new_time = false;
    c.last = from;
    std::fill(std::begin(c.last_z), std::end(c.last_z), from.z);
    std::fill(std::begin(c.last_intensity), std::end(c.last_intensity), from.intensity);
    for (std::uint32_t i = 0; i < 12; ++i) c.x_steps[i] = c.y_steps[i] = {};
    c.gps.start(from.gps_time);
  }

  bool is_open(std::uint32_t index) const { return channels_[index] && channels_[index]->used; }

  std::uint32_t changes(const Point14& previous, const Point14& p) const {
    const Point14& last = is_open(p.channel()) ? channels_[p.channel()]->last : previous;
    const std::uint32_t step = (p.r() - last.r()) & 15u;
    const std::uint32_t number = step == 0 ? 0 : step == 1 ? 1 : step == 15 ? 2 : 3;
    return number | (p.n() != last.n() ? kReturnCount : 0u) | (p.angle != last.angle ? kAngle : 0u) |
           (p.gps_time != last.gps_time ? kGps : 0u) | (p.source != last.source ? kSource : 0u) |
           (p.channel() != current_ ? kChannel : 0u);
  }

  // Codes the changed fields and switches to the scanner channel of the point.
  std::uint32_t code_change(Coder& coder, const Point14& previous, const Point14& p) {
    Channel& c = *channels_[current_];
    const std::uint32_t context =
        (previous.r() == 1 ? 1u : 0u) | (previous.r() >= previous.n() ? 2u : 0u) | (c.new_time ? 4u : 0u);
    const std::uint32_t change = coder.symbol(c.change[context], kEncodes ? changes(previous, p) : 0);
    if (change & kChannel) [[unlikely]] {
      const std::uint32_t hop = coder.symbol(c.channel, kEncodes ? (p.channel() - current_ - 1) & 3u : 0);
      current_ = (current_ + hop + 1) & 3u;
      if (!is_open(current_)) open_channel(current_, previous);
      channels_[current_]->last.set_channel(current_);
    }
    return change;
  }

  // p may be c.last: each value is read before it is written.
  static void code_values(Stream<Coder>* streams, Channel& c, Point14& p, std::uint32_t change) {
    const bool new_time = change & kGps;
    code_returns(streams[kLayerXy].coder, c, change, p);
    const std::uint32_t last_return = p.r() >= p.n();
    const std::uint32_t cpr = (p.r() == 1 ? 2u : 0u) | last_return;
    code_coordinates(streams, c, p, new_time);
    code_attributes(streams, c, p, cpr, new_time);
    code_rare(streams, c, p, change);
  }

  static void code_returns(Coder& coder, Channel& c, std::uint32_t change, Point14& p) {
    const std::uint32_t last_n = c.last.n(), last_r = c.last.r();
    std::uint32_t n = last_n, r = last_r;
    if (change & kReturnCount) n = coder.symbol(c.return_count[last_n], p.n());
    // 0: the same as before, 1: the next, 2: the previous, all without a branch; 3: any other.
    r = (r + (0xF10u >> 4 * (change & kReturnMask))) & 15u;
    if ((change & kReturnMask) == 3) {
      if (change & kGps) {
        r = coder.symbol(c.return_number[last_r], p.r());
      } else {
        r = (last_r + 2 + coder.symbol(c.return_number_same_time, (p.r() - last_r - 2) & 15u)) & 15u;
      }
    }
    p.returns = static_cast<std::uint8_t>(n << 4 | r);
  }

  static void code_coordinates(Stream<Coder>* streams, Channel& c, Point14& p, bool new_time) {
    const std::uint32_t n = p.n(), r = p.r(), single = n == 1;
    const std::uint32_t w = 2u * kReturnMap16[n][r] + (new_time ? 1u : 0u);
    Coder& xy = streams[kLayerXy].coder;
    p.x = code_step(xy, c.x, c.x_steps[w], c.last.x, p.x, single);
    p.y = code_step(xy, c.y, c.y_steps[w], c.last.y, p.y, single + y_context(c.x.last_bits()));
    if (!kEncodes && !streams[kLayerZ].active) return;
    const std::uint32_t bits = (c.x.last_bits() + c.y.last_bits()) / 2;
    std::int32_t& last_z = c.last_z[std::min(n > r ? n - r : r - n, 7u)];
    last_z = p.z = c.z.code(streams[kLayerZ].coder, last_z, p.z, single + z_context(bits));
  }

  // Calls body with the coder of the stream when the stream is coded; records whether the value changed.
  template <class Value, class Body>
  static void layer(Stream<Coder>& stream, Value last, Value& value, const Body& body) {
    if constexpr (kEncodes) {
      if (stream.constant) return;
      stream.active |= value != last;
      body(stream.coder);
    } else if (stream.active) {
      value = static_cast<Value>(body(stream.coder));
    }
  }

  // Codes the attributes for which every point has a symbol.
  static void code_attributes(Stream<Coder>* streams, Channel& c, Point14& p, std::uint32_t cpr, bool new_time) {
    const Point14& last = c.last;
    layer(streams[kLayerClass], last.classification, p.classification, [&](Coder& coder) {
      return coder.symbol(c.classification[(last.classification & 31u) << 1 | (cpr == 3)], p.classification);
    });
    std::uint32_t flags = p.flag_bits();
    layer(streams[kLayerFlags], last.flag_bits(), flags,
          [&](Coder& coder) { return coder.symbol(c.flags[last.flag_bits()], flags); });
    if constexpr (!kEncodes) p.set_flag_bits(flags);
    layer(streams[kLayerIntensity], last.intensity, p.intensity, [&](Coder& coder) {
      std::uint16_t& before = c.last_intensity[2 * cpr + (new_time ? 1u : 0u)];
      return before = static_cast<std::uint16_t>(c.intensity.code(coder, before, p.intensity, cpr));
    });
    layer(streams[kLayerUser], last.user, p.user,
          [&](Coder& coder) { return coder.symbol(c.user[last.user >> 2], p.user); });
  }

  // Codes the attributes for which only changed points have a symbol.
  static void code_rare(Stream<Coder>* streams, Channel& c, Point14& p, std::uint32_t change) {
    const Point14& last = c.last;
    if (change & kAngle) {
      layer(streams[kLayerAngle], last.angle, p.angle, [&](Coder& coder) {
        return static_cast<std::int16_t>(c.angle.code(coder, last.angle, p.angle, change & kGps ? 1 : 0));
      });
    }
    if (change & kSource) {
      layer(streams[kLayerSource], last.source, p.source,
            [&](Coder& coder) { return c.source.code(coder, last.source, p.source, 0); });
    }
    if (change & kGps) {
      layer(streams[kLayerGps], last.gps_time, p.gps_time, [&](Coder& coder) { return c.gps.code(coder, p.gps_time); });
    }
  }

  std::array<std::unique_ptr<Channel>, 4> channels_;
  std::uint32_t current_ = 0;
};

}  // namespace ilot::laz
