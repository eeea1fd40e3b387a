// Drives an event model with planes of brightness change made up by a test.
#pragma once

#include <memory>

#include "events/event_model.h"

namespace saccade::test {

inline constexpr TimeNs kMs{1'000'000};

struct ModelRun {
  ModelRun(const SensorConfig& config, int width, int height)
      : model(findEventModel(config.model)->make(config, width, height)), dL(width, height) {}

  // One interval of 1 ms (by default) with dL(x, y) = change(x, y). Its events are those of this interval
  // alone.
  template <class F>
  const Events& step(F&& change, TimeNs length = kMs) {
    for (int y = 0; y < dL.height(); ++y) {
      for (int x = 0; x < dL.width(); ++x) dL.at(x, y) = change(x, y);
    }
    events.clear();
    suppressed = model->generate(dL, {now, now + length, ++frame}, events);
    now += length;
    return events;
  }
  const Events& step(float change, TimeNs length = kMs) {
    return step([=](int, int) { return change; }, length);
  }

  std::unique_ptr<EventModel> model;
  ImageF dL;
  Events events;
  std::uint64_t suppressed = 0;  // of the newest interval
  TimeNs now{0};
  FrameIndex frame = 0;
};

}  // namespace saccade::test
