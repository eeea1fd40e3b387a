#include "app/streams/frame_picture.h"

#include <string>

#include "events/log_response.h"

namespace saccade {
namespace {

// Planes go out as they lie in memory: little-endian here, as on all machines we build for.
std::string packRows(const ImageF& image) {
  std::string bytes;
  bytes.reserve(sizeof(float) * image.width() * image.height());
  for (int y = 0; y < image.height(); ++y) {
    bytes.append(reinterpret_cast<const char*>(image.row(y)), sizeof(float) * image.width());
  }
  return bytes;
}

}  // namespace

void FramePicture::take(const IntensityChange& change) {
  std::lock_guard lock(mutex_);
  newest_.t0 = change.t0;
  newest_.t1 = change.t1;
  newest_.frame = change.frame;
  newest_.dI.copyFrom(change.dI);
  newest_.I_prev.copyFrom(change.I_prev);
  newest_.I_now.copyFrom(change.I_now);
  taken_ = true;
}

std::optional<v1::FramePicture> FramePicture::picture(double bias) const {
  std::lock_guard lock(mutex_);
  if (!taken_) return {};
  ImageF dL(newest_.dI.width(), newest_.dI.height());
  logResponse(newest_, static_cast<float>(bias), dL);
  v1::FramePicture picture;
  picture.set_width(static_cast<std::uint32_t>(dL.width()));
  picture.set_height(static_cast<std::uint32_t>(dL.height()));
  picture.set_frame(newest_.frame);
  picture.set_t0_ns(newest_.t0.count());
  picture.set_t1_ns(newest_.t1.count());
  picture.set_intensity(packRows(newest_.I_now));
  picture.set_brightness_change(packRows(dL));
  return picture;
}

}  // namespace saccade
