// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <cstdint>

#include "engine/formats/laz/chunk.h"

namespace ilot::laz {

// For the items behind the core, layered chunks keep a set of models and of last values for each scanner channel. This
// class selects the set for each point. The models for coding and the last values for prediction may come from
// different sets: item version 3 takes channel 0 for a point that stays in its channel, and after a change to a channel
// that is already in use it keeps the values of the old one for one point.
class ChannelSets {
 public:
  struct Choice {
    std::uint32_t models = 0, values = 0;
    std::uint32_t origin = 0;  // for a new set: the set whose last values it starts with
    bool opened = false;
  };

  explicit ChannelSets(const ChunkLayout& layout) : own_channel_(layout.item_version == 4) {}

  // Takes the first point of a chunk.
  void start(std::uint32_t channel) {
    used_ = {};
    used_[channel] = true;
    current_ = channel;
  }

  // Takes the next point; new_channel says whether its channel differs from that of the previous point.
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
