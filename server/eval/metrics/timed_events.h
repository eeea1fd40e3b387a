// Events of pixels whose log brightness is straight between known times, and how far such events of two
// sources are apart.
#pragma once

#include <cstdint>
#include <vector>

namespace saccade::eval {

struct TimedEvent {
  std::uint32_t pixel;
  double time;
  bool on;
};

// An accumulating sensor without noise, whose pixels have random start phases that depend on their number
// alone.
class LineSensor {
 public:
  // `threshold`: of log brightness, > 0.
  LineSensor(std::size_t pixels, double threshold);

  // Log brightness of a pixel changes by `change` from t0 to t1, where the last call for it ended.
  void move(std::uint32_t pixel, double t0, double t1, double change);
  // Sorted by pixel, then by time.
  std::vector<TimedEvent> events() const;

 private:
  double threshold_;
  std::vector<double> level_;  // since the last event, in (-threshold, threshold)
  std::vector<TimedEvent> events_;
};

struct TimedScore {
  double false_events = 0,
         missed = 0;      // differences of counts per pixel, polarity and window, over true events
  double time_error = 0;  // mean over the k-th events of a pixel and polarity
};

// Of events sorted by pixel, then by time. `window`: of time, > 0.
TimedScore scoreEvents(const std::vector<TimedEvent>& events, const std::vector<TimedEvent>& truth,
                       double window);

}  // namespace saccade::eval
