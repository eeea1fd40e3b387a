// Groups events into messages for robot middleware.
#pragma once

#include <cstdint>
#include <functional>

#include "wire/event.h"

namespace saccade::client {

// The events of a message lie in one interval [5 ms * k, 5 ms * (k + 1)) of time. An interval without events
// gives no message, and one with more than 65536 events gives several.
class MessageSplitter {
 public:
  using Send = std::function<void(const Events& events)>;

  // `send` gets each message, which has at least one event.
  explicit MessageSplitter(Send send) : send_(std::move(send)) {}

  void add(const Events& events, std::int64_t until_ns);  // as Writer::write()
  void flush();                                           // sends the events that are left

 private:
  const Send send_;
  Events message_, sent_;
  std::int64_t end_ns_ = INT64_MIN;  // of the interval of message_
};

}  // namespace saccade::client
