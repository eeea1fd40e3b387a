#include "client/formats/common/event_check.h"

namespace saccade::client {

void EventCheck::check(const Events& events) {
  for (const Event& event : events) {
    ++count_;
    if (event.t_ns < last_ns_ || event.x >= size_.width || event.y >= size_.height || event.p > 1)
      fail(event, count_);
    last_ns_ = event.t_ns;
  }
}

void EventCheck::fail(const Event& event, std::uint64_t number) const {
  const std::string place = "event " + std::to_string(number) + " ";
  if (event.t_ns < last_ns_) throw FileFault(path_, place + "is earlier than the one before");
  if (event.p > 1) throw FileFault(path_, place + "has a polarity other than 0 and 1");
  throw FileFault(path_, place + "is at (" + std::to_string(event.x) + ", " + std::to_string(event.y) +
                             "), outside of " + std::to_string(size_.width) + "x" +
                             std::to_string(size_.height) + " pixels");
}

}  // namespace saccade::client
