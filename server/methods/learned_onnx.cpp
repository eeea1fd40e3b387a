// A small network that training/train.py has trained, run by ONNX Runtime. RIVALS.md tells of it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <vector>

#include "filter/demodulation.h"
#include "methods/learned_denoiser.h"
#include "methods/onnx_session.h"
#include "methods/optional_method.h"

namespace saccade {
namespace {

constexpr const char* kVariable = "SACCADE_LEARNED_MODEL";
constexpr std::size_t kPlanes = 8;
constexpr double kBytes = 2000;  // of a pixel while the network of training/ runs; 1640 were measured
// As in train.py.
constexpr float kDark = 1e-2f, kMostLight = 1e4f, kNearest = 8;

class Learned final : public PictureDenoiser {
 public:
  Learned(std::shared_ptr<const OnnxSession> network, int width, int height);
  void denoise(const Frame& frame, ImageF& I) override;

 private:
  std::span<float> plane(std::size_t k) {
    return std::span(planes_).subspan(k * light_.size(), light_.size());
  }
  // The means of light and 1 / z of the first frame, which all frames are measured in.
  void measure(const Frame& first);
  void fillPlanes(const Frame& frame);

  std::shared_ptr<const OnnxSession> network_;
  std::vector<float> light_, planes_;
  float light_scale_ = 0, near_scale_ = 0;  // 0: not measured yet
};

Learned::Learned(std::shared_ptr<const OnnxSession> network, int w, int h)
    : network_(std::move(network)),
      light_(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
      planes_(kPlanes * light_.size()) {}

// i = (I - E) / A [E (17)]; 0 where a sample is not finite.
float lightAt(const Frame& frame, int x, int y) {
  const float i = (frame.samples.I2.at(x, y) - frame.g.emission.at(x, y)) /
                  filterAlbedo(frame.g.albedo.at(x, y), Demodulation::kAlbedo);
  return i > 0 && i <= 1e18f ? i : 0.f;
}

void Learned::measure(const Frame& first) {
  double light = 0, near = 0, lit = 0;
  for (int y = 0; y < first.height(); ++y) {
    for (int x = 0; x < first.width(); ++x) {
      near += 1 / first.g.z.at(x, y);
      if (first.g.albedo.at(x, y) < kDark) continue;
      light += lightAt(first, x, y);
      ++lit;
    }
  }
  light_scale_ = light > 0 ? static_cast<float>(light / lit) : 1;
  near_scale_ = static_cast<float>(near / (static_cast<double>(first.width()) * first.height()));
}

void Learned::fillPlanes(const Frame& frame) {
  std::size_t at = 0;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x, ++at) {
      const float light = std::min(lightAt(frame, x, y) / light_scale_, kMostLight);
      const GBuffer& g = frame.g;
      const float values[kPlanes] = {light,
                                     1,
                                     std::log1p(10 * light),
                                     g.albedo.at(x, y),
                                     g.nx.at(x, y),
                                     g.ny.at(x, y),
                                     g.nz.at(x, y),
                                     std::min(1 / (g.z.at(x, y) * near_scale_), kNearest)};
      for (std::size_t k = 0; k < kPlanes; ++k) plane(k)[at] = values[k];
    }
  }
}

void Learned::denoise(const Frame& frame, ImageF& I) {
  if (light_scale_ == 0) measure(frame);
  fillPlanes(frame);
  network_->run(planes_, light_, frame.width(), frame.height());
  std::size_t at = 0;
  for (int y = 0; y < frame.height(); ++y) {
    for (int x = 0; x < frame.width(); ++x, ++at) {
      const float albedo = modulationAlbedo(frame.g.albedo.at(x, y), Demodulation::kAlbedo);
      I.at(x, y) = albedo * light_[at] * light_scale_ + frame.g.emission.at(x, y);
    }
  }
}

// The network of all feeds.
const std::shared_ptr<const OnnxSession>& network() {
  static const auto session = std::make_shared<const OnnxSession>(std::getenv(kVariable), kPlanes);
  return session;
}

std::string whyAbsent() {
  const char* file = std::getenv(kVariable);
  if (!file || !*file)
    return std::string(kVariable) +
           " must name the file of a network, which server/methods/training/train.py makes";
  try {
    network();
  } catch (const std::exception& fault) {
    return std::string(kVariable) + ": " + fault.what();
  }
  return {};
}

}  // namespace

OptionalMethod learnedMethod() {
  MethodInfo info{"learned",
                  "a small trained network: filters each frame by itself, then takes the difference",
                  {},
                  [](const ParamValues&) -> SeedPlanner { return SeedPlan::independent; },
                  [](const MethodSetup& setup) -> std::unique_ptr<Method> {
                    return std::make_unique<LearnedDenoiser>(
                        std::make_unique<Learned>(network(), setup.width, setup.height), setup.width,
                        setup.height);
                  }};
  info.memory = [](const ParamValues&, const ViewTraits& view) { return kBytes * view.pixels; };
  return {info, whyAbsent()};
}

}  // namespace saccade
