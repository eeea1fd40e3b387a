#include "eval/sensor/sensor_run.h"

#include <algorithm>

#include "events/sensor.h"

namespace saccade::eval {
namespace {

void setAll(ImageF& plane, double value) {
  for (int y = 0; y < plane.height(); ++y)
    std::fill_n(plane.row(y), plane.width(), static_cast<float>(value));
}

// Sets the planes to the change from frame `a` to frame `b`.
void setChange(const StimulusFrame& a, const StimulusFrame& b, IntensityChange& change) {
  change.t0 = a.t, change.t1 = b.t;
  ++change.frame;
  setAll(change.dI, b.I - a.I);
  setAll(change.I_prev, a.I);
  setAll(change.I_now, b.I);
}

}  // namespace

void runSensor(const SensorSetup& setup, const Stimulus& stimulus,
               const std::function<void(const Event&)>& take) {
  SACCADE_CHECK(stimulus.size() >= 2);
  SensorConfig config = setup.config;
  config.reconstruction = "direct";  // a stimulus has no noise of rendering
  config.noise.readout_hz = 0;
  Sensor sensor(config, setup.width, setup.height);
  IntensityChange change(setup.width, setup.height);
  SensorOutput out;
  for (std::size_t k = 1; k < stimulus.size(); ++k) {
    setChange(stimulus[k - 1], stimulus[k], change);
    sensor.generate(change, out);
    std::for_each(out.events.begin(), out.events.end(), take);
  }
}

}  // namespace saccade::eval
