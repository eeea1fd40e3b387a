// Log brightness before the sensor.
#include <cmath>

#include "frame/plane_bytes.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class Brightness final : public PictureSource {
 public:
  explicit Brightness(const TruthConfig& config)
      : PictureSource(config), bias_(static_cast<float>(config.bias)) {}

 protected:
  std::string picture(const TruthFrame& frame) override {
    const ImageF& intensity = frame.intensity;
    std::string elements;
    appendPixels(intensity.width(), intensity.height(), elements,
                 [&](int x, int y) { return std::log(bias_ + intensity.at(x, y)); });
    return elements;
  }

 private:
  float bias_;
};

}  // namespace

std::unique_ptr<TruthSource> makeBrightness(const TruthConfig& config) {
  return std::make_unique<Brightness>(config);
}

}  // namespace saccade
