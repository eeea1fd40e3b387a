// The digest of events that Recording.digest holds, whatever the format of their file.
#pragma once

#include <sodium.h>

#include <string>

#include "saccade/wire/event.h"

namespace saccade::client {

class EventDigest {
 public:
  EventDigest();
  void add(const Events& events);  // t_ns counts whole microseconds
  std::string hex();               // the last call

 private:
  crypto_generichash_state state_;
  std::string bytes_;
};

}  // namespace saccade::client
