#include "eval/metrics/frame_errors.h"

#include "eval/metrics/plane_error.h"
#include "events/log_response.h"

namespace saccade {

FrameErrors frameErrors(const IntensityChange& x, const IntensityChange& ref, float bias, double threshold) {
  ImageF dL(x.dI.width(), x.dI.height()), dL_ref(ref.dI.width(), ref.dI.height());
  logResponse(x, bias, dL);
  logResponse(ref, bias, dL_ref);
  return {relativeL1(x.dI, ref.dI), mape(x.dI, ref.dI), relativeL1(dL, dL_ref), mape(dL, dL_ref),
          integratedRates(dL, dL_ref, threshold)};
}

}  // namespace saccade
