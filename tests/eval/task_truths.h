// Truth for tasks with known values, and events of points that move.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "eval/tasks/task_truth.h"
#include "saccade/wire/event.h"

namespace saccade::test {

inline constexpr TimeNs kTaskFrame{4'000'000};

// Frames one after the other from time 0 on, in which everything moves by `flow`, pixels per second. No
// surface is a body, and the camera stands.
inline eval::TaskTruth steadyTruth(int width, int height, int frames, Vec2 flow) {
  eval::TaskTruth truth{pinhole(60, width, height), ImageF(width, height), {}};
  for (int f = 0; f < frames; ++f) {
    eval::TruthFrame frame{f * kTaskFrame,        (f + 1) * kTaskFrame,
                           ImageF(width, height), ImageF(width, height),
                           ImageF(width, height), Image<std::uint32_t>(width, height),
                           ImageF(width, height), {}};
    frame.z.fill(1), frame.flow_x.fill(flow.x), frame.flow_y.fill(flow.y);
    truth.frames.push_back(std::move(frame));
  }
  return truth;
}

// Events of `points` points at random places, `each` of every one at random times within `span_s`. At time t,
// seconds, a point at p is seen at place(p, t).
template <class Place>
Events eventsOfPoints(int points, int each, int width, int height, double span_s, Place place) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> x(0, width - 1), y(0, height - 1), time(0, span_s);
  Events events;
  for (int i = 0; i < points; ++i) {
    const Vec2 p{static_cast<float>(x(random)), static_cast<float>(y(random))};
    for (int k = 0; k < each; ++k) {
      const double t = time(random);
      const Vec2 at = place(p, t);
      const long px = std::lround(at.x), py = std::lround(at.y);
      if (px < 0 || py < 0 || px >= width || py >= height) continue;
      events.push_back({static_cast<std::int64_t>(1e9 * t), static_cast<std::uint16_t>(px),
                        static_cast<std::uint16_t>(py), 1});
    }
  }
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) { return a.t_ns < b.t_ns; });
  return events;
}

}  // namespace saccade::test
