// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/rays.h"

#include <algorithm>

namespace ilot {

void Rays::Iterator::next() {
  constexpr std::uint64_t kPiece = 1024;
  for (; all_->run_ < all_->runs_.size(); ++all_->run_, all_->done_ = 0) {
    const RayRun& run = all_->runs_[all_->run_];
    if (all_->done_ == run.count) continue;
    const std::uint64_t first = run.first + all_->done_;
    if (const Ray* memory = all_->column_->in_memory()) {
      at_ = memory + first;
      end_ = memory + run.first + run.count;
      all_->done_ = run.count;
      return;
    }
    all_->buffer_.resize(std::min(kPiece, run.count - all_->done_));
    all_->column_->read(first, all_->buffer_);
    all_->done_ += all_->buffer_.size();
    at_ = all_->buffer_.data();
    end_ = at_ + all_->buffer_.size();
    return;
  }
  at_ = end_ = nullptr;
}

}  // namespace ilot
