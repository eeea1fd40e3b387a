#include "client/formats/common/message_splitter.h"

namespace saccade::client {

std::int64_t intervalEnd(std::int64_t t_ns) {
  constexpr std::int64_t kIntervalNs = 5'000'000;
  std::int64_t rest_ns = t_ns % kIntervalNs;
  if (rest_ns < 0) rest_ns += kIntervalNs;
  return t_ns - rest_ns + kIntervalNs;
}

void MessageSplitter::add(const Events& events, std::int64_t until_ns) {
  for (const Event& event : events) {
    if (event.t_ns >= end_ns_ || message_.size() == kMostMessageEvents) {
      flush();
      end_ns_ = intervalEnd(event.t_ns);
    }
    message_.push_back(event);
  }
  if (until_ns >= end_ns_) flush();
}

void MessageSplitter::flush() {
  if (message_.empty()) return;
  sent_.clear();
  std::swap(message_, sent_);  // before send_(), which may throw: no event is sent twice
  send_(sent_);
}

}  // namespace saccade::client
