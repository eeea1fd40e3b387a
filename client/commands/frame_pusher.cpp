#include "client/commands/frame_pusher.h"

#include <cmath>
#include <stdexcept>

#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kAhead = 3;  // frames that are on the way, so that the server need not wait

}  // namespace

void FramePusher::push(std::int64_t done_ns) {
  const double rate_hz = stream_.opened().resolved().timing().frame_rate_hz();
  const std::int64_t done =
      std::llround(secondsOf(done_ns) * rate_hz);  // the newest frame whose events have come
  while (!ended_ && sent_ <= done + kAhead && send()) {
  }
  if (!ended_ || stream_.closed()) return;
  if (sent_ < 2) throw std::runtime_error("events need at least two frames");
  if (done == sent_ - 1) stream_.closeKnown();
}

// Returns false where the source has ended or the server has no room.
bool FramePusher::send() {
  if (!next_) next_ = frames_.next();
  ended_ = !next_;
  if (ended_) return false;
  try {
    stream_.push(*next_);
  } catch (const Refused& refused) {
    if (refused.code == v1::CODE_RESOURCE_EXHAUSTED) return false;
    throw std::runtime_error("frame " + std::to_string(sent_) + ": " + refused.what());
  }
  next_.reset();
  ++sent_;
  return true;
}

}  // namespace saccade::client
