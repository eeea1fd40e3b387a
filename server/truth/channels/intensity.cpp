// Intensity from which the sensors make events.
#include "frame/plane_bytes.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class Intensity final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    std::string elements;
    appendPlane(frame.intensity, elements);
    return elements;
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeIntensity(const TruthConfig& config) {
  return std::make_unique<Intensity>(config);
}

}  // namespace saccade
