// The change of brightness of a whole frame.
#pragma once

#include "events/log_response.h"

namespace saccade {

// dL [E (21)] under the bias I_eps, as a sensor sees it.
inline ImageF brightnessChange(const IntensityChange& change, float bias) {
  ImageF dL(change.dI.width(), change.dI.height());
  logResponse(change, bias, dL);
  return dL;
}

}  // namespace saccade
