// Computes the change of brightness of a whole frame.
#pragma once

#include "events/log_response.h"

namespace saccade::eval {

// dL [E (21)] under the bias I_eps, as a sensor sees it.
inline ImageF brightnessChange(const IntensityChange& change, float bias) {
  ImageF dL(change.dI.width(), change.dI.height());
  logResponse(change, bias, dL);
  return dL;
}

// The same of another estimate of the difference.
inline ImageF brightnessChange(const ImageF& dI, const ImageF& I_prev, float bias) {
  IntensityChange change(dI.width(), dI.height());
  change.dI.copyFrom(dI);
  change.I_prev.copyFrom(I_prev);
  return brightnessChange(change, bias);
}

}  // namespace saccade::eval
