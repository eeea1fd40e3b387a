// The digest of events that Recording.digest holds, whatever the format of their file.
#pragma once

#include <string>

#include "client/recording/digest.h"
#include "saccade/wire/event.h"

namespace saccade::client {

class EventDigest {
 public:
  void add(const Events& events);              // t_ns counts whole microseconds
  std::string hex() { return digest_.hex(); }  // the last call

 private:
  Digest digest_;
  std::string bytes_;
};

}  // namespace saccade::client
