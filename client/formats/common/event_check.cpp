#include "client/formats/common/event_check.h"

#include "client/formats/common/units.h"

namespace saccade::client {

void EventCheck::check(const Events& events) {
  for (const Event& event : events) {
    ++count_;
    if (event.t_ns < last_ns_ || event.x >= size_.width || event.y >= size_.height) fail(event, count_);
    last_ns_ = event.t_ns;
  }
}

void EventCheck::fail(const Event& event, std::uint64_t number) const {
  const std::string place = "event " + std::to_string(number) + " ";
  if (event.t_ns < last_ns_)
    throw FileFault(path_, place + "is " + textOfUs(last_ns_ - event.t_ns) + " earlier than the one before" +
                               (mends_ ? "; --sort WINDOW_US puts such events in order" : ""));
  throw FileFault(path_, place + "is at (" + std::to_string(event.x) + ", " + std::to_string(event.y) +
                             "), outside of " + std::to_string(size_.width) + "x" +
                             std::to_string(size_.height) + " pixels" +
                             (mends_ ? "; --crop leaves such events out" : ""));
}

std::string textOfUs(std::int64_t ns) {
  return std::to_string((ns + kNsPerUs - 1) / kNsPerUs) + " us";
}

}  // namespace saccade::client
