// Groups events into messages of robot middleware, and into packets of files.
#pragma once

#include <cstdint>
#include <functional>

#include "saccade/wire/event.h"

namespace saccade::client {

inline constexpr std::size_t kMostMessageEvents = 1 << 16;

// The end of the interval [5 ms * k, 5 ms * (k + 1)) of time that holds `t_ns`.
std::int64_t intervalEnd(std::int64_t t_ns);

// The events of a message lie in one interval. An interval without events gives no message, and one with more
// than kMostMessageEvents gives several.
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
