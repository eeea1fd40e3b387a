#include "eval/tasks/windows.h"

#include <algorithm>

namespace saccade::eval {

std::vector<Window> windowsOf(const TaskInput& input, std::size_t length) {
  const std::vector<TruthFrame>& frames = input.truth.frames;
  const auto eventAt = [&](TimeNs t) {
    return std::partition_point(input.events.begin(), input.events.end(),
                                [&](const Event& e) { return e.t_ns < t.count(); });
  };
  std::vector<Window> windows;
  for (std::size_t last = length - 1; last < frames.size(); last += length) {
    const TimeNs begin = frames[last + 1 - length].t0, end = frames[last].t1;
    windows.push_back({{eventAt(begin), eventAt(end)}, begin, end});
  }
  return windows;
}

}  // namespace saccade::eval
