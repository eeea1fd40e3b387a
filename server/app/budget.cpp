#include "app/budget.h"

#include "app/refusal.h"

namespace saccade {

std::shared_ptr<void> Budget::reserve(long pixels) {
  std::lock_guard lock(mutex_);
  if (streams_ + 1 > kMaxStreams) {
    throw Refusal(v1::CODE_RESOURCE_EXHAUSTED, {},
                  "there are " + std::to_string(kMaxStreams) + " streams, the most this server has");
  }
  if (pixels_ + pixels > kMaxOpenPixels) {
    throw Refusal(v1::CODE_RESOURCE_EXHAUSTED, "view",
                  "the views of all streams together may have " + std::to_string(kMaxOpenPixels) + " pixels");
  }
  ++streams_;
  pixels_ += pixels;
  return {this, [pixels](Budget* budget) {
            std::lock_guard lock(budget->mutex_);
            --budget->streams_;
            budget->pixels_ -= pixels;
          }};
}

}  // namespace saccade
