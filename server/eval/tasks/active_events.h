// The surface of active events: the times of the latest events.
#pragma once

#include <array>

#include "frame/image.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

// An edge of much contrast makes several events at a pixel, and only the first of them tells its arrival. So
// an event is left out if one of its polarity came in the same pixel within kSameEdgeS before [AC18].
//
// [AC18] Alzugaray and Chli, Asynchronous corner detection and tracking for event cameras in real time, RA-L
// 2018: the filter with the time kappa.
inline constexpr double kSameEdgeS = 0.05;

class ActiveEvents {
 public:
  ActiveEvents(int width, int height);

  // Takes the events in time order. Returns whether this one is kept.
  bool add(const Event& e);
  // By pixel, seconds, of events of this polarity that were kept: -infinity where there was none, and in the
  // border.
  const Image<double>& times(int polarity) const { return kept_[static_cast<std::size_t>(polarity)]; }

 private:
  std::array<Image<double>, 2> kept_, latest_;  // by polarity
};

}  // namespace saccade::eval
