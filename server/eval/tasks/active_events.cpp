#include "eval/tasks/active_events.h"

#include <limits>

namespace saccade::eval {

ActiveEvents::ActiveEvents(int width, int height)
    : kept_{Image<double>(width, height), Image<double>(width, height)},
      latest_{Image<double>(width, height), Image<double>(width, height)} {
  for (auto* surfaces : {&kept_, &latest_})
    for (Image<double>& times : *surfaces) times.fill(-std::numeric_limits<double>::infinity());
}

bool ActiveEvents::add(const Event& e) {
  const double t = 1e-9 * static_cast<double>(e.t_ns);
  double& latest = latest_[e.p].at(e.x, e.y);
  const bool is_first = t - latest > kSameEdgeS;
  latest = t;
  if (is_first) kept_[e.p].at(e.x, e.y) = t;
  return is_first;
}

}  // namespace saccade::eval
