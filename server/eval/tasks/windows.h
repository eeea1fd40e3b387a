// Cuts a sequence into windows for algorithms that take many events at once.
#pragma once

#include <span>
#include <vector>

#include "eval/tasks/task.h"

namespace saccade::eval {

inline constexpr std::size_t kWindowFrames = 8;

struct Window {
  std::span<const Event> events;  // of [begin, end)
  TimeNs begin, end;
  TimeNs middle() const { return (begin + end) / 2; }
  double span_s() const { return seconds(end - begin); }
};

// Windows of `length` frames each, >= 1, one after the other. A rest of less frames is left out.
std::vector<Window> windowsOf(const TaskInput& input, std::size_t length = kWindowFrames);

}  // namespace saccade::eval
