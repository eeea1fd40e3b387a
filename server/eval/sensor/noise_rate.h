// Events of a sensor that sees a still picture.
#pragma once

#include "eval/sensor/sensor_run.h"

namespace saccade::eval {

struct NoiseRate {
  double on_hz, off_hz;  // per pixel
};
// On a still picture of intensity `I` for `duration_s` seconds. It has stood for as long before, so that the
// levels have forgotten where they began.
NoiseRate measureNoise(const SensorSetup& setup, double I, double duration_s);

}  // namespace saccade::eval
