// Tells of events which objects their pixels show.
#pragma once

#include <cstdint>
#include <vector>

#include "feed/feed_interval.h"
#include "saccade/wire/event.h"

namespace saccade {

class EventObjects {
 public:
  // Sets Event::object of the events of an interval to numbers of the truth channel ids. They are those of
  // the frame that is nearer in time, or of the later one. All intervals are of one scene of at most
  // kMaxObject shapes.
  void find(const RenderedInterval& interval, Events& events);

 private:
  std::vector<std::uint32_t> numbers_;  // by shape, once the scene is known
};

}  // namespace saccade
