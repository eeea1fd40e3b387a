#include "app/budget.h"

#include "app/refusal.h"
#include "frame/image.h"

namespace saccade {

// Measured on streams of 1 and 17 sensors; a sensor with all its options on takes three times the plainest.
long streamBytes(int width, int height, int sensors) {
  constexpr long kFeedBytes = 260, kSensorBytes = 24;  // for a pixel
  const long pixels = (long{width} + 2 * ImageF::kBorder) * (long{height} + 2 * ImageF::kBorder);
  return pixels * (kFeedBytes + kSensorBytes * sensors);
}

std::shared_ptr<void> Budget::reserve(long bytes) {
  std::lock_guard lock(mutex_);
  if (streams_ + 1 > kMaxStreams) {
    throw Refusal(v1::CODE_RESOURCE_EXHAUSTED, {},
                  "there are " + std::to_string(kMaxStreams) + " streams, the most this server has");
  }
  if (bytes_ + bytes > kMaxStreamBytes) {
    const auto mib = [](long n) { return std::to_string(n >> 20) + " MiB"; };
    throw Refusal(v1::CODE_RESOURCE_EXHAUSTED, "view",
                  "with its sensors this view takes about " + mib(bytes) + "; of " + mib(kMaxStreamBytes) +
                      " for all streams, " + mib(bytes_) + " are taken");
  }
  ++streams_;
  bytes_ += bytes;
  return {this, [bytes](Budget* budget) {
            std::lock_guard lock(budget->mutex_);
            --budget->streams_;
            budget->bytes_ -= bytes;
          }};
}

}  // namespace saccade
