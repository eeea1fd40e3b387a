#include "client/commands/preview.h"

#include <algorithm>
#include <stdexcept>

#include "client/commands/preview_picture.h"
#include "client/terminal/console.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kShownNs = 10'000'000;  // window of the events: short, so that edges stand apart
constexpr std::int64_t kSpareNs = 7'000'000;   // the picture may be older than the newest events by this much

std::span<const Event> between(const Events& events, std::int64_t t0_ns, std::int64_t t1_ns) {
  const auto before = [](const Event& e, std::int64_t t_ns) { return e.t_ns < t_ns; };
  const auto first = std::lower_bound(events.begin(), events.end(), t0_ns, before);
  return {first, std::lower_bound(first, events.end(), t1_ns, before)};
}

}  // namespace

Preview::Preview(const std::string& path, std::int64_t at_ns, std::int64_t frame_ns)
    : path_(path), at_ns_(at_ns), window_ns_(std::max(kShownNs, frame_ns)) {}

void Preview::see(const DecodedPacket& batch, StreamHandle& stream) {
  if (batch.header.sensor() != 0 || state_ == State::kWritten || state_ == State::kFailed) return;
  keepTail(batch);
  try {
    advance(batch.header.t1_ns(), stream);
  } catch (const std::runtime_error& error) {
    print(stderr, "saccade: no preview: %s\n", error.what());
    state_ = State::kFailed;
  }
}

// Drops old events until the picture has been taken, and then keeps all until they reach its time.
void Preview::keepTail(const DecodedPacket& batch) {
  if (state_ == State::kWaiting) {
    const std::int64_t oldest = batch.header.t1_ns() - window_ns_ - kSpareNs;
    std::erase_if(tail_, [=](const Event& e) { return e.t_ns < oldest; });
  }
  tail_.insert(tail_.end(), batch.events.begin(), batch.events.end());
}

void Preview::advance(std::int64_t time_ns, StreamHandle& stream) {
  if (state_ == State::kWaiting && time_ns >= at_ns_) {
    try {
      frame_ = stream.picture();
    } catch (const Refused& refused) {
      if (refused.code != v1::CODE_RESOURCE_EXHAUSTED) throw;
      return;  // too many requests at once; the next batch tries again
    }
    state_ = State::kAsked;
  }
  if (state_ == State::kAsked && time_ns >= frame_.t1_ns()) {
    write();
    state_ = State::kWritten;
  }
}

void Preview::write() const {
  writePng(path_,
           drawPreview(frame_, between(tail_, frame_.t1_ns() - window_ns_, frame_.t1_ns()), window_ns_));
}

}  // namespace saccade::client
