// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

// Behind the core, layered chunks keep a set of models and of last values for each scanner channel: which of them a
// point goes by. The models to code by and the last values to predict from need not belong together: item version 3
// takes channel 0 for a point that stays in its channel, and on a change to a set in use keeps the old one's values for
// one point.
class ChannelSets {
 public:
  struct Choice {
    std::uint32_t models = 0, values = 0;
    std::uint32_t origin = 0;  // opened: the set whose last values the new one starts with
    bool opened = false;
  };

  explicit ChannelSets(const ChunkLayout& layout) : own_channel_(layout.item_version == 4) {}

  // The first point of a chunk.
  void start(std::uint32_t channel) {
    used_ = {};
    used_[channel] = true;
    current_ = channel;
  }

  // The next point, and whether its channel is another than that of the point before.
  Choice next(std::uint32_t channel, bool new_channel) {
    const std::uint32_t wanted = own_channel_ || new_channel ? channel : 0;
    Choice choice{current_, current_, current_, false};
    if (wanted == current_) [[likely]]
      return choice;
    choice.models = wanted;
    choice.opened = !used_[wanted];
    if (choice.opened || own_channel_) choice.values = wanted;
    used_[wanted] = true;
    current_ = wanted;
    return choice;
  }

 private:
  bool own_channel_;
  std::array<bool, 4> used_{};
  std::uint32_t current_ = 0;
};

}  // namespace ilot::laz
