#include "eval/metrics/frame_errors.h"

#include "eval/metrics/brightness_change.h"
#include "eval/metrics/plane_error.h"

namespace saccade::eval {

FrameErrors frameErrors(const IntensityChange& x, const IntensityChange& ref, float bias, double threshold) {
  const ImageF dL = brightnessChange(x, bias), dL_ref = brightnessChange(ref, bias);
  return {relativeL1(x.dI, ref.dI), mape(x.dI, ref.dI), relativeL1(dL, dL_ref), mape(dL, dL_ref),
          integratedRates(dL, dL_ref, threshold)};
}

}  // namespace saccade::eval
