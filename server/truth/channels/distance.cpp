// Distance from the camera to the surface that the pixel centre shows.
#include "frame/plane_bytes.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class Distance final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    const ImageF& z = frame.rendered->frame.g.z;
    std::string elements;
    appendPixels(z.width(), z.height(), elements, [&](int x, int y) {
      const float depth = z.at(x, y);
      if (depth == kMissDepth) return depth;
      return depth * length(frame.rendered->camera.direction(static_cast<float>(x), static_cast<float>(y)));
    });
    return elements;
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeDistance(const TruthConfig& config) {
  return std::make_unique<Distance>(config);
}

}  // namespace saccade
