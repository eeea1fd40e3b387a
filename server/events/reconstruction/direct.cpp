// Direct accumulation [E (22)]: dL stays as it is.
#include "events/reconstruction/reconstructions.h"

namespace saccade {
namespace {

class Direct final : public Reconstruction {
 public:
  void reconstruct(const IntensityChange&, ImageF&) override {}
  bool corrects() const override { return false; }
  void setBias(double) override {}
};

}  // namespace

std::unique_ptr<Reconstruction> makeDirect(const SensorConfig&, int, int) {
  return std::make_unique<Direct>();
}

}  // namespace saccade
