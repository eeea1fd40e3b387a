// Drives a sensor with pictures made up by a test.
#pragma once

#include "events/sensor.h"

namespace saccade::test {

struct SensorRun {
  SensorRun(const SensorConfig& config, int width, int height)
      : sensor(config, width, height), change(width, height) {
    setIntensity(1);
  }

  void setIntensity(float I) {
    change.I_prev.fill(I);
    change.I_now.fill(I);
  }

  // The next interval, of `length`, without a change unless the test has put one into change.dI. Collects its
  // events.
  const SensorOutput& step(TimeNs length = TimeNs(1'000'000)) {
    change.t0 = change.t1;
    change.t1 += length;
    ++change.frame;
    sensor.generate(change, out);
    all.insert(all.end(), out.events.begin(), out.events.end());
    return out;
  }

  Sensor sensor;
  IntensityChange change;
  SensorOutput out;
  Events all;
};

}  // namespace saccade::test
