// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/watershed.h"

#include "kernels/morphology/radix_heap.h"
#include "kernels/rasters/padded.h"

namespace ilot {
namespace {

// A pixel waits from the time when the first basin touches it until the water is as high as the pixel.
class WatershedFlood {
 public:
  WatershedFlood(const Image& relief, const PixelLabels& markers, Adjacency adjacency)
      : frame_(relief.width, relief.height),
        neighbours_(step_count(adjacency)),
        steps_(frame_.steps()),
        relief_(padded(relief, kNoHeight)),
        labels_(padded<std::uint32_t>(relief.width, relief.height, markers.of, 0)),
        waiting_(frame_.size(), 0) {
    for (std::size_t i = 0; i < relief_.size(); ++i)
      if (relief_[i] == kNoHeight) labels_[i] = 0;
  }

  void run() {
    touch_around_markers();
    std::vector<std::uint32_t> front, next;
    while (!queue_.empty()) {
      const Height level = queue_.pop_level(front);
      for (; !front.empty(); front.swap(next)) {
        label_front(front);
        next.clear();
        for (const std::uint32_t p : front) touch_around(p, level, next);
      }
    }
  }

  std::vector<std::uint32_t> labels() const { return unpadded<std::uint32_t>(frame_, labels_); }

 private:
  void touch_around_markers() {
    std::vector<std::uint32_t> none;
    for (std::uint32_t y = 0; y < frame_.height; ++y)
      for (std::size_t p = frame_.row(y); p < frame_.row(y) + frame_.width; ++p)
        if (labels_[p] != 0) touch_around(static_cast<std::uint32_t>(p), kNoHeight, none);
  }

  // Visits the neighbours that are dry and do not wait yet. Those that are not above the water go into the next wave,
  // the others wait on the shore.
  void touch_around(std::uint32_t p, Height level, std::vector<std::uint32_t>& next) {
    for (std::size_t s = 0; s < neighbours_; ++s) {
      const std::uint32_t q = p + steps_[s];
      if (labels_[q] != 0 || waiting_[q] != 0 || relief_[q] == kNoHeight) continue;
      waiting_[q] = 1;
      if (relief_[q] <= level) {
        next.push_back(q);
      } else {
        queue_.push(relief_[q], q);
      }
    }
  }

  // The whole wave uses the labels from before the wave.
  void label_front(const std::vector<std::uint32_t>& front) {
    chosen_.clear();
    for (const std::uint32_t p : front) {
      std::uint32_t least = 0;  // minus 1, so that "none" is the highest value
      for (std::size_t s = 0; s < neighbours_; ++s) least = std::min(least - 1, labels_[p + steps_[s]] - 1) + 1;
      chosen_.push_back(least);
    }
    for (std::size_t i = 0; i < front.size(); ++i) labels_[front[i]] = chosen_[i];
  }

  PaddedFrame frame_;
  std::size_t neighbours_;
  std::array<std::uint32_t, 8> steps_;
  std::vector<Height> relief_;
  std::vector<std::uint32_t> labels_;
  std::vector<std::uint8_t> waiting_;
  RadixHeap queue_;
  std::vector<std::uint32_t> chosen_;
};

}  // namespace

PixelLabels watershed(const Image& relief, const PixelLabels& markers, Adjacency adjacency) {
  assert(relief.size() == markers.of.size());
  WatershedFlood flood(relief, markers, adjacency);
  flood.run();
  return {relief.width, relief.height, markers.count, flood.labels()};
}

}  // namespace ilot
