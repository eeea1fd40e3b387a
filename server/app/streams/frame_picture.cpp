#include "app/streams/frame_picture.h"

#include <string>

#include "events/log_response.h"

namespace saccade {
namespace {

// The bytes of the planes as they lie in memory, which is little-endian on all machines we build for.
std::string packRows(const ImageF& image) {
  std::string bytes;
  bytes.reserve(sizeof(float) * image.width() * image.height());
  for (int y = 0; y < image.height(); ++y) {
    bytes.append(reinterpret_cast<const char*>(image.row(y)), sizeof(float) * image.width());
  }
  return bytes;
}

}  // namespace

v1::FramePicture drawPicture(const IntensityChange& change, double bias) {
  ImageF dL(change.dI.width(), change.dI.height());
  logResponse(change, static_cast<float>(bias), dL);
  v1::FramePicture picture;
  picture.set_width(static_cast<std::uint32_t>(dL.width()));
  picture.set_height(static_cast<std::uint32_t>(dL.height()));
  picture.set_frame(change.frame);
  picture.set_t0_ns(change.t0.count());
  picture.set_t1_ns(change.t1.count());
  picture.set_intensity(packRows(change.I_now));
  picture.set_brightness_change(packRows(dL));
  return picture;
}

}  // namespace saccade
