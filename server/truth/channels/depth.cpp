// Depth of the surface that the pixel centre shows.
#include "frame/plane_bytes.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class Depth final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    std::string elements;
    appendPlane(frame.rendered->frame.g.z, elements);
    return elements;
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeDepth(const TruthConfig& config) {
  return std::make_unique<Depth>(config);
}

}  // namespace saccade
