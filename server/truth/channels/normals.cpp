// Normal of the surface that the pixel centre shows.
#include "frame/plane_bytes.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

class Normals final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    const GBuffer& g = frame.rendered->frame.g;
    std::string elements;
    for (const ImageF* axis : {&g.nx, &g.ny, &g.nz}) {
      appendPixels(axis->width(), axis->height(), elements,
                   [&](int x, int y) { return g.z.at(x, y) == kMissDepth ? 0.0f : axis->at(x, y); });
    }
    return elements;
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeNormals(const TruthConfig& config) {
  return std::make_unique<Normals>(config);
}

}  // namespace saccade
