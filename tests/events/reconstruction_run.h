// Drives a reconstruction with one pixel of brightness made up by a test; it starts at 0.
#pragma once

#include <cmath>

#include "events/reconstruction.h"

namespace saccade::test {

struct ReconstructionRun {
  explicit ReconstructionRun(const SensorConfig& config, double rate_hz = 500)
      : bias(config.bias),
        rate_hz(rate_hz),
        change(1, 1),
        dL(1, 1),
        reconstruction(findReconstruction(config.reconstruction)->make(config, 1, 1)) {
    change.I_prev.at(0, 0) = intensity(0);
  }

  // Both relative: those of the logarithm.
  void setVariances(double of_dL, double of_primal) {
    const double scale = std::pow(bias + change.I_prev.at(0, 0), 2);
    change.var_dI.at(0, 0) = static_cast<float>(scale * of_dL);
    change.var_I_prev.at(0, 0) = static_cast<float>(scale * of_primal);
  }

  // One frame with the given dL and primal brightness. Returns the change of L^.
  double step(double delta, double primal) {
    change.I_now.at(0, 0) = intensity(primal);
    change.t0 = frameTime(change.frame, rate_hz);
    change.t1 = frameTime(++change.frame, rate_hz);
    dL.at(0, 0) = static_cast<float>(delta);
    reconstruction->reconstruct(change, dL);
    sum += dL.at(0, 0);
    return dL.at(0, 0);
  }

  float intensity(double brightness) const { return static_cast<float>(std::exp(brightness) - bias); }

  double bias, rate_hz;
  IntensityChange change;
  ImageF dL;
  std::unique_ptr<Reconstruction> reconstruction;
  double sum = 0;  // of all changes: L^_t - L^_0
};

}  // namespace saccade::test
