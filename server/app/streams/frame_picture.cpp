#include "app/streams/frame_picture.h"

#include "events/log_response.h"
#include "frame/plane_bytes.h"

namespace saccade {
v1::FramePicture drawPicture(const IntensityChange& change, double bias) {
  ImageF dL(change.dI.width(), change.dI.height());
  logResponse(change, static_cast<float>(bias), dL);
  v1::FramePicture picture;
  picture.set_width(static_cast<std::uint32_t>(dL.width()));
  picture.set_height(static_cast<std::uint32_t>(dL.height()));
  picture.set_frame(change.frame);
  picture.set_t0_ns(change.t0.count());
  picture.set_t1_ns(change.t1.count());
  appendPlane(change.I_now, *picture.mutable_intensity());
  appendPlane(dL, *picture.mutable_brightness_change());
  return picture;
}

}  // namespace saccade
