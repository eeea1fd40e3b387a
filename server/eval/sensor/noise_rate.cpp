#include "eval/sensor/noise_rate.h"

namespace saccade::eval {

NoiseRate measureNoise(const SensorSetup& setup, double I, double duration_s) {
  double on = 0, off = 0;
  runSensor(setup, stillPicture(I, 2 * duration_s), [&](const Event& e) {
    if (seconds(TimeNs(e.t_ns)) >= duration_s) ++(e.p == 1 ? on : off);
  });
  const double pixel_seconds = setup.pixels() * duration_s;
  return {on / pixel_seconds, off / pixel_seconds};
}

}  // namespace saccade::eval
